#include "app/gui/field_steps/field_compare_presenter.h"
#include "app/gui/field_steps/field_export_presenter.h"
#include "app/gui/field_steps/field_fit_presenter.h"
#include "app/gui/field_steps/field_page_figures.h"
#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/field_steps/field_review_presenter.h"
#include "app/gui/field_steps/field_verify_presenter.h"
#include "tests/app/gui/field_steps/field_document_fixture.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <algorithm>
#include <utility>

namespace straightedge::gui {

using testing::OpenFieldDocument;
using testing::quickCampaign;

class FieldPresentersTest : public QObject {
  Q_OBJECT
private slots:
  void everyPresenterSaysWhatToDoWithoutData();
  void fitShowsFiguresAndTables();
  void fitChangesTheChoices();
  void aBlockSwitchedOffSaysWhatItCosts();
  void aMissingStageIsAWarning();
  void jointFitIsComparedWithStepwise();
  void verifyFollowsLimitAndScale();
  void verifyWithAFreshCampaign();
  void verifyRefusesAFileWithoutRows();
  void reviewListsEveryRow();
  void reviewSwitchesWithUndo();
  void reviewSaysWhatIsLeftOut();
  void exportWritesFiles();
  void compareChoosesAnOrder();
  void wordsAreForPeople();
};

void FieldPresentersTest::everyPresenterSaysWhatToDoWithoutData() {
  OpenFieldDocument open;
  const FieldFitPresenter fit(open.document);
  QVERIFY(fit.missing().contains("capture"));
  QVERIFY(fit.figures().isEmpty());
  QCOMPARE(fit.emptyPlot().note, fit.missing());
  QCOMPARE(fit.notices().size(), 1);
  for (const auto& block : fit.blocks()) {
    QVERIFY(!block.measured);
    QVERIFY(block.cost.endsWith('.'));
  }
  const FieldVerifyPresenter verify(open.document, open.jobs);
  QCOMPARE(verify.outcome(), FieldVerifyPresenter::Outcome::None);
  QCOMPARE(verify.verdictText(), verify.missing());
  QVERIFY(verify.table().rows.isEmpty());
  const FieldReviewPresenter review(open.document);
  QVERIFY(!review.hasCampaign());
  QVERIFY(review.missing().contains("import"));
  QVERIFY(review.stages().empty());
  const FieldExportPresenter files(open.document, open.jobs);
  QVERIFY(!files.canStart());
  QVERIFY(files.fileNames().isEmpty());
  const FieldComparePresenter compare(open.document, open.jobs);
  QVERIFY(!compare.missing().isEmpty());
  QCOMPARE(compare.figure().note, compare.missing());
  QVERIFY(!compare.choiceAt(0, 0));
}

void FieldPresentersTest::fitShowsFiguresAndTables() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const FieldFitPresenter presenter(open.document);
  QCOMPARE(presenter.missing(), QString());
  QCOMPARE(presenter.orders().rows.size(), 7);
  QVERIFY(presenter.blockRows().rows.size() >= 7);
  QVERIFY(!presenter.blockRows().rows.first().last().isEmpty()); // how
  QVERIFY(!presenter.coefficients().rows.isEmpty());
  QVERIFY(!presenter.uncertainty().rows.isEmpty());
  const ReportTable states = presenter.states();
  QVERIFY(!states.rows.isEmpty());
  QCOMPARE(states.header.size(), states.rows.first().size());
  QSet<QString> stems;
  for (const NamedFigure& figure : presenter.figures()) {
    QVERIFY2(figure.isScene() ? !isEmptyScene(figure.scene()) : !figure.make().series.isEmpty(),
             qPrintable(figure.stem));
    QVERIFY(figure.topic != FigureTopic::Data);
    stems.insert(figure.stem);
  }
  QCOMPARE(stems.size(), presenter.figures().size());
  QVERIFY(stems.contains("nonlinearity-residuals-x"));
  QVERIFY(stems.contains("probe-temperature-hysteresis"));
  QVERIFY(stems.contains("axis-directions") && stems.contains("orientations") && stems.contains("surface-after-y"));
  QCOMPARE(presenter.beforeAfter().size(), 4); // three axes and the uncertainty
  QVERIFY(presenter.beforeAfter().first().value.contains(" → "));
  QVERIFY(presenter.fitText().startsWith("x: "));
}

void FieldPresentersTest::fitChangesTheChoices() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  FieldFitPresenter presenter(open.document);
  QSignalSpy changed(&presenter, &FieldFitPresenter::changed);
  presenter.setOrder(3);
  presenter.setReferenceTemperatureC(25.0);
  presenter.setFullScaleT(1.5);
  presenter.setFullScaleT(0.0); // no scale
  QVERIFY(changed.count() >= 3);
  QVERIFY(open.settle());
  QCOMPARE(open.document.run()->result.order, 3);
  QCOMPARE(open.document.run()->result.chain.fullScaleT, 1.5);
  QCOMPARE(open.document.run()->result.chain.referenceTemperatureC, 25.0);
  presenter.setOrder(99);
  QCOMPARE(presenter.choices().order, 7);
  open.document.undoStack().undo();
  QCOMPARE(presenter.choices().order, 3);
}

void FieldPresentersTest::aBlockSwitchedOffSaysWhatItCosts() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  FieldFitPresenter presenter(open.document);
  QCOMPARE(presenter.notices().size(), 0);
  presenter.setBlockOn(field::Block::Sensitivity, false);
  QVERIFY(open.settle());
  QVERIFY(!presenter.blocks()[3].on);
  QVERIFY(presenter.blocks()[3].measured);
  QCOMPARE(presenter.notices().size(), 1); // by choice: no warning beside it
  QCOMPARE(presenter.notices().first().level, Notice::Level::Information);
  QVERIFY(presenter.notices().first().text.contains("gain's drift with the probe's temperature"));
  presenter.setBlockOn(field::Block::Sensitivity, true);
  QVERIFY(open.settle());
  QCOMPARE(presenter.notices().size(), 0);
}

void FieldPresentersTest::aMissingStageIsAWarning() {
  OpenFieldDocument open;
  field::Campaign campaign = quickCampaign(7);
  std::erase_if(campaign.rows,
                [](const field::CampaignRow& row) { return row.step == field::CampaignStep::Orientation; });
  QVERIFY(open.load(std::move(campaign)));
  const FieldFitPresenter presenter(open.document);
  QVERIFY(!presenter.blocks().last().measured);
  QCOMPARE(presenter.notices().size(), 1);
  QCOMPARE(presenter.notices().first().level, Notice::Level::Warning);
  QVERIFY(presenter.notices().first().text.contains("axis-matrix"));
}

void FieldPresentersTest::jointFitIsComparedWithStepwise() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  FieldFitPresenter presenter(open.document);
  QVERIFY(!presenter.beforeAfter().first().hint.contains("step by step"));
  presenter.setMethod(field::FitMethod::Joint);
  QVERIFY(open.settle());
  QVERIFY(presenter.beforeAfter().first().hint.contains("step by step"));
  QVERIFY(!presenter.fitText().startsWith("x: ")); // how the joint fit went comes first
}

void FieldPresentersTest::verifyFollowsLimitAndScale() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  FieldVerifyPresenter presenter(open.document, open.jobs);
  QCOMPARE(presenter.outcome(), FieldVerifyPresenter::Outcome::Passed);
  QVERIFY(presenter.verdictText().startsWith("Largest error"));
  QVERIFY(presenter.ruleText().contains("full scale, 2 T"));
  QVERIFY(presenter.campaignText().contains("own verification rows"));
  QVERIFY(!presenter.figures().isEmpty());
  QVERIFY(!presenter.table().rows.isEmpty());
  presenter.setLimitPercent(0.0001);
  QVERIFY(open.settle());
  QCOMPARE(presenter.outcome(), FieldVerifyPresenter::Outcome::Failed);
  QVERIFY(presenter.verdictText().contains("exceeds the limit"));
  presenter.setLimitPercent(-1.0);
  QCOMPARE(presenter.limitPercent(), 0.0001);
  presenter.setPercentOf(field::PercentOf::Reading);
  QVERIFY(open.settle());
  QVERIFY(presenter.ruleText().contains("of reading"));
  QVERIFY(!presenter.table().rows.isEmpty());
}

void FieldPresentersTest::verifyWithAFreshCampaign() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  FieldVerifyPresenter presenter(open.document, open.jobs);
  QTemporaryDir folder;
  QFile file(folder.filePath("fresh.csv"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(QByteArray::fromStdString(field::campaignCsv(quickCampaign(7))));
  file.close();
  presenter.loadCsv(file.fileName());
  QVERIFY(open.settle());
  QCOMPARE(presenter.problem(), QString());
  QVERIFY(presenter.hasFresh());
  QVERIFY(presenter.campaignText().startsWith("fresh.csv: "));
  QVERIFY(open.document.verificationIsFresh());
  presenter.forgetFresh();
  QVERIFY(open.settle());
  QVERIFY(!presenter.hasFresh());
  QVERIFY(!open.document.verificationIsFresh());
}

void FieldPresentersTest::verifyRefusesAFileWithoutRows() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  FieldVerifyPresenter presenter(open.document, open.jobs);
  field::Campaign campaign = quickCampaign(7);
  std::erase_if(campaign.rows,
                [](const field::CampaignRow& row) { return row.step == field::CampaignStep::Verification; });
  QTemporaryDir folder;
  QFile file(folder.filePath("none.csv"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(QByteArray::fromStdString(field::campaignCsv(campaign)));
  file.close();
  presenter.loadCsv(file.fileName());
  QVERIFY(open.settle());
  QVERIFY(presenter.problem().contains("no rows of the step verification"));
  QVERIFY(!presenter.hasFresh());
  presenter.loadCsv(folder.filePath("absent.csv"));
  QVERIFY(open.settle());
  QVERIFY(presenter.problem().contains("absent.csv"));
}

void FieldPresentersTest::reviewListsEveryRow() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const FieldReviewPresenter presenter(open.document);
  std::size_t next = 0;
  for (std::size_t stage = 0; stage < presenter.stages().size(); ++stage) {
    QVERIFY(!presenter.stages()[stage].title.isEmpty());
    for (const std::size_t row : presenter.rowsOf(stage, std::nullopt)) {
      QCOMPARE(row, next++);
    }
  }
  QCOMPARE(next, open.document.campaign().rows.size());
  QCOMPARE(presenter.facts().first().value, QString::number(next));
  QCOMPARE(presenter.placeOfRow(0), std::make_optional(std::pair<std::size_t, std::size_t>(0, 0)));
  QVERIFY(!presenter.placeOfRow(next));
  for (const ListedStage& stage : presenter.stages()) {
    QVERIFY(!presenter.plot(stage.step).series.isEmpty());
    const auto row = presenter.rowAt(0, 0);
    QVERIFY(row);
    QCOMPARE(open.document.campaign().rows[*row].step, stage.step);
  }
  QVERIFY(!presenter.rowAt(99, 0));
  QVERIFY(!presenter.rowAt(0, -1));
}

void FieldPresentersTest::reviewSwitchesWithUndo() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  FieldReviewPresenter presenter(open.document);
  const auto rows = presenter.rowsOf(0, 1);
  QVERIFY(!rows.empty());
  presenter.setEnabled(rows, false, QStringLiteral("plateau 2"));
  QCOMPARE(open.document.undoStack().undoText(), QStringLiteral("Switch off plateau 2"));
  QCOMPARE(presenter.stages()[0].runs[1].on, 0U);
  QCOMPARE(presenter.stages()[0].runs[1].leftOut, QStringLiteral("switched off"));
  QVERIFY(presenter.anyOff());
  presenter.toggle(rows);
  QVERIFY(!presenter.anyOff());
  presenter.toggle({rows.front()});
  QCOMPARE(presenter.stages()[0].runs[1].leftOut.startsWith("1 switched off"), true);
  open.document.undoStack().undo();
  QVERIFY(!presenter.anyOff());
  presenter.setEnabled(presenter.rowsOf(0, std::nullopt), false);
  presenter.switchAllOn();
  QVERIFY(!presenter.anyOff());
}

void FieldPresentersTest::reviewSaysWhatIsLeftOut() {
  OpenFieldDocument open;
  field::Campaign campaign = quickCampaign(7);
  const CampaignRun plateau = campaignRuns(campaign)[1];
  bool kept = false;
  for (std::size_t row = plateau.first; row < plateau.first + plateau.count; ++row) {
    campaign.rows[row].locked = campaign.rows[row].locked && !std::exchange(kept, kept || campaign.rows[row].locked);
  }
  QVERIFY(open.load(std::move(campaign)));
  const FieldReviewPresenter presenter(open.document);
  const auto lost = presenter.placeOfRow(plateau.first);
  QVERIFY(lost);
  QVERIFY2(presenter.stages()[lost->first].runs[lost->second].leftOut.contains("rejected: only 1 row"),
           qPrintable(presenter.stages()[lost->first].runs[lost->second].leftOut));
  QVERIFY(presenter.stages()[0].leftOut.startsWith("rows left out of"));
}

void FieldPresentersTest::exportWritesFiles() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  FieldExportPresenter presenter(open.document, open.jobs);
  QTemporaryDir folder;
  presenter.setFolder(folder.filePath("out"));
  ExportChoices choices;
  choices.plotsPng = false;
  choices.reportPdf = false;
  presenter.setChoices(choices);
  QVERIFY(presenter.fileNames().contains("calibration.json"));
  QVERIFY(presenter.fileNames().contains("coefficients.csv"));
  QVERIFY(presenter.fileNames().contains("campaign.csv"));
  QVERIFY(presenter.existing().isEmpty());
  const QStringList names = presenter.fileNames();
  presenter.start();
  QVERIFY(presenter.isRunning());
  QVERIFY(open.settle());
  QVERIFY2(!presenter.failed(), qPrintable(presenter.statusText()));
  QCOMPARE(presenter.written(), names);
  for (const QString& name : names) {
    QVERIFY2(QFile(folder.filePath("out/" + name)).size() > 0, qPrintable(name));
  }
  choices.sweep = false;
  presenter.setChoices(choices);
  QVERIFY(presenter.written().isEmpty());
  QCOMPARE(presenter.existing().size(), names.size() - 1);
}

void FieldPresentersTest::compareChoosesAnOrder() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  FieldComparePresenter presenter(open.document, open.jobs);
  QVERIFY(presenter.table().rows.isEmpty());
  presenter.setShown(true);
  QVERIFY(!presenter.progressText().isEmpty());
  QVERIFY(open.settle());
  QCOMPARE(presenter.progressText(), QString());
  const auto comparison = open.document.comparison();
  QVERIFY(comparison);
  QCOMPARE(static_cast<std::size_t>(presenter.table().rows.size()), comparison->choices.size());
  const qsizetype all = presenter.table().rows.size();
  presenter.setOnlyBest(true);
  QVERIFY(presenter.table().rows.size() < all);
  QVERIFY(!presenter.table().rows.isEmpty());
  QVERIFY(!presenter.figure().series.isEmpty());
  QVERIFY(presenter.choiceAt(0, 0));
  QVERIFY(!presenter.choiceAt(0, 1000));
  for (std::size_t i = 0; i < comparison->choices.size(); ++i) {
    if (comparison->choices[i].order == 4 && !comparison->choices[i].without) {
      presenter.choose(i);
      break;
    }
  }
  QCOMPARE(open.document.choices().order, 4);
  const auto without =
      std::ranges::find_if(comparison->choices, [](const auto& each) { return each.without.has_value(); });
  QVERIFY(without != comparison->choices.end());
  presenter.choose(static_cast<std::size_t>(without - comparison->choices.begin()));
  QVERIFY(open.document.choices().blocksOff.contains(*without->without));
  presenter.setShown(false);
  QVERIFY(open.settle());
  QVERIFY(presenter.chosenText().startsWith(QStringLiteral("Fitted now: order %1").arg(without->order)));
}

void FieldPresentersTest::wordsAreForPeople() {
  QCOMPARE(stageWord(field::CampaignStep::Orientation, std::nullopt, field::Orientation::MinusX),
           QStringLiteral("Orientation, −x"));
  QCOMPARE(stageWord(field::CampaignStep::Sensitivity, field::Axis::Y, std::nullopt), QStringLiteral("Sensitivity, y"));
  QCOMPARE(percentFigure(-0.00001), QStringLiteral("0.0000"));
  QCOMPARE(percentFigure(-0.12345), QStringLiteral("−0.1235"));
  NamedFigure figure;
  figure.stem = QStringLiteral("nonlinearity-residuals-x");
  QCOMPARE(shortName(figure), QStringLiteral("Nonlinearity residuals, x"));
  QCOMPARE(placeOf({}, figure.stem), -1);
  QCOMPARE(placeOf({NamedFigure{}, figure}, figure.stem), 1);
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::FieldPresentersTest)
#include "field_presenters_test.moc"
