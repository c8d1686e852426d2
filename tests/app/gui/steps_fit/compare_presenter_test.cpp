#include "app/gui/steps/compare_presenter.h"
#include "app/gui/steps/comparison_table.h"
#include "tests/app/gui/steps_fit/document_fixture.h"

using namespace straightedge;
using namespace straightedge::gui;
using gui::testing::OpenDocument;

class ComparePresenterTest : public QObject {
  Q_OBJECT

private slots:
  void answersWhileALineIsDragged();
  void keepsTheFigureWhileDragging();
  void clickingAPointChoosesItsModel();
  void measuresAndWidthChangeTheFigure();
  void budgetIsKeptInEntriesOnAnAxisOfBytes();
  void tableFiltersSortsAndCopies();
  void saysWhatToDoWithoutData();
};

void ComparePresenterTest::answersWhileALineIsDragged() {
  OpenDocument open;
  QVERIFY(open.load());
  ComparePresenter presenter(open.document, open.jobs);
  QSignalSpy demands(&presenter, &ComparePresenter::demandsChanged);
  presenter.dragGuide(targetGuide, 1.0);
  const angle::Recommendation loose = presenter.forTarget();
  QVERIFY(loose.choice && loose.choice->maxErrorDeg <= 1.0);
  presenter.dragGuide(targetGuide, 0.1);
  const angle::Recommendation tight = presenter.forTarget();
  QVERIFY(tight.choice && tight.choice->maxErrorDeg <= 0.1);
  QVERIFY(tight.choice->storageEntries > loose.choice->storageEntries);
  QVERIFY(tight.sentence != loose.sentence);
  presenter.dragGuide(budgetGuide, 9.9);
  QCOMPARE(presenter.budgetEntries(), 9);
  QVERIFY(presenter.forBudget().choice->storageEntries <= 9);
  QCOMPARE(demands.count(), 3);
}

void ComparePresenterTest::keepsTheFigureWhileDragging() {
  OpenDocument open;
  QVERIFY(open.load());
  ComparePresenter presenter(open.document, open.jobs);
  const qsizetype series = presenter.figure().series.size();
  QCOMPARE(series, 6); // minimax is in
  QSignalSpy figure(&presenter, &ComparePresenter::figureChanged);
  presenter.dragGuide(targetGuide, 0.25);
  QCOMPARE(figure.count(), 0);
  for (const PlotGuide& guide : presenter.figure().guides) {
    if (guide.id == QLatin1String(targetGuide)) {
      QCOMPARE(guide.value, 0.25);
    }
  }
}

void ComparePresenterTest::clickingAPointChoosesItsModel() {
  OpenDocument open;
  QVERIFY(open.load());
  ComparePresenter presenter(open.document, open.jobs);
  const PlotSpec& spec = presenter.figure();
  QCOMPARE(spec.series[1].name, QStringLiteral("Linear, least squares"));
  presenter.choosePoint(1, 38); // sizes start at 2
  QCOMPARE(open.document.choices().selected.text(), std::string("linear:40"));
  QCOMPARE(open.document.choices().models.back().text(), std::string("linear:40"));
  QVERIFY(presenter.chosenText().startsWith("Chosen: linear:40, 40 entries, 160 bytes; leaves "));
  QVERIFY(presenter.figure().series[1].emphasised[38]);
  presenter.choosePoint(1, 38);
  QCOMPARE(open.document.choices().models.size(), std::size_t{4}); // not twice
  presenter.choosePoint(-1, -1);
  presenter.choosePoint(99, 0);
  QCOMPARE(open.document.choices().selected.text(), std::string("linear:40"));
}

void ComparePresenterTest::measuresAndWidthChangeTheFigure() {
  OpenDocument open;
  QVERIFY(open.load());
  ComparePresenter presenter(open.document, open.jobs);
  QSignalSpy figure(&presenter, &ComparePresenter::figureChanged);
  presenter.setErrorMeasure(ErrorMeasure::Rms);
  QCOMPARE(presenter.figure().y.title, QStringLiteral("Rms error (°)"));
  presenter.setErrorMeasure(ErrorMeasure::Rms);
  QCOMPARE(figure.count(), 1); // nothing new
  presenter.setBits(8);
  QVERIFY(open.settle());
  QVERIFY(presenter.comparison()->rows.back().name.bits == 8);
  QVERIFY(figure.count() >= 2);
}

void ComparePresenterTest::budgetIsKeptInEntriesOnAnAxisOfBytes() {
  OpenDocument open;
  QVERIFY(open.load());
  ComparePresenter presenter(open.document, open.jobs);
  presenter.setBudgetEntries(50);
  presenter.setStorageMeasure(StorageMeasure::Bytes);
  QCOMPARE(presenter.guideValue(budgetGuide), 200.0);
  presenter.dragGuide(budgetGuide, 130.0);
  QCOMPARE(presenter.budgetEntries(), 32);
}

void ComparePresenterTest::tableFiltersSortsAndCopies() {
  OpenDocument open;
  QVERIFY(open.load());
  ComparisonTable table;
  table.setComparison(open.document.comparison());
  ComparisonFilter filter;
  filter.setSourceModel(&table);
  const int powers = filter.rowCount();
  filter.setPowersOnly(false);
  QCOMPARE(filter.rowCount(), static_cast<int>(open.document.comparison()->rows.size()));
  QVERIFY(powers > 20 && powers < 70);
  filter.setMethod(std::pair(angle::ModelKind::LookupTable, angle::FitMethod::Mean));
  QCOMPARE(filter.rowCount(), 1023);
  filter.sort(ComparisonTable::Size, Qt::DescendingOrder);
  QCOMPARE(filter.index(0, ComparisonTable::Model).data().toString(), QStringLiteral("lut:1024"));
  filter.setPowersOnly(true);
  const QStringList lines = filter.text().split('\n', Qt::SkipEmptyParts);
  QCOMPARE(lines.size(), 11); // a header, 2 to 1024
  QVERIFY(lines[0].startsWith("Model\tMethod\tSize"));
  QCOMPARE(filter.text({0}).split('\n', Qt::SkipEmptyParts).size(), 2);
}

void ComparePresenterTest::saysWhatToDoWithoutData() {
  OpenDocument open;
  ComparePresenter presenter(open.document, open.jobs);
  QVERIFY(presenter.missing().contains("capture"));
  QVERIFY(presenter.figure().series.isEmpty());
  QVERIFY(presenter.figure().guides.isEmpty());
  QVERIFY(!presenter.forTarget().choice);
}

QTEST_GUILESS_MAIN(ComparePresenterTest)
#include "compare_presenter_test.moc"
