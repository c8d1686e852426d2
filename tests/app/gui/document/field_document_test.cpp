#include "app/gui/document/campaign_runs.h"
#include "app/gui/document/field_document.h"
#include "app/gui/document/scratch_folder.h"
#include "app/gui/jobs/job_runner.h"
#include "core/export/field_calibration_json.h"
#include "core/field/campaign_csv.h"
#include "core/field/session_campaign.h"
#include "devices/simulated/hall_campaign.h"

#include <QCryptographicHash>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <memory>

namespace straightedge::gui {

class FieldDocumentTest : public QObject {
  Q_OBJECT
private slots:
  void initTestCase();
  void init();
  void cleanup();

  void anEmptyScratchLeavesNothingBehind();
  void aScratchWithContentIsKeptAndRecovered();
  void anAngleSessionIsRefused();
  void everythingIsThereAfterReopening();
  void reopeningDoesNotTouchTheFile();
  void capturedSamplesBecomeTheCampaign();
  void runsArePlateausAndSweeps();
  void switchedOffRowsCountNoLonger();
  void importIsUndoable();
  void choicesUndoAndMerge();
  void aBlockSwitchedOffIsOff();
  void recomputeFollowsChoices();
  void aRefusedCampaignSaysWhy();
  void verificationFollowsTheLimit();
  void aFreshCampaignIsVerifiedInstead();
  void comparisonIsMadeWhileWanted();
  void detailsTravelWithTheResult();

private:
  void waitUntilIdle();
  void open();
  void openWithCampaign();

  field::Campaign m_campaign; ///< as read from a file
  std::unique_ptr<QTemporaryDir> m_home;
  std::unique_ptr<JobRunner> m_jobs;
  std::unique_ptr<FieldDocument> m_document;
};

void FieldDocumentTest::initTestCase() {
  // Through CSV, as an imported one, with comment lines so that the file's lines are not the rows' numbers.
  const auto made = devices::makeHallCampaign(devices::quickHallCampaign(7));
  auto read = field::parseCampaignCsv("# a probe\n# of the simulated bench\n" + field::campaignCsv(made), "probe.csv",
                                      "probe.csv");
  QVERIFY2(read, read ? "" : read.error().message().c_str());
  m_campaign = std::move(*read);
  QVERIFY(m_campaign.rows.size() > 500);
}

void FieldDocumentTest::init() {
  m_home = std::make_unique<QTemporaryDir>();
  QVERIFY(m_home->isValid());
  qputenv("XDG_DATA_HOME", m_home->path().toUtf8());
  m_jobs = std::make_unique<JobRunner>();
  m_document = std::make_unique<FieldDocument>(*m_jobs);
}

void FieldDocumentTest::cleanup() {
  m_document.reset();
  m_jobs.reset();
  m_home.reset();
}

void FieldDocumentTest::waitUntilIdle() {
  QCoreApplication::processEvents(); // recomputing starts with the event loop's next turn
  if (m_jobs->busy()) {
    QSignalSpy idle(m_jobs.get(), &JobRunner::idle);
    QVERIFY(idle.wait(60000));
  }
}

void FieldDocumentTest::open() { QVERIFY(m_document->createScratch()); }

void FieldDocumentTest::openWithCampaign() {
  open();
  m_document->setCampaign(m_campaign, "import");
  waitUntilIdle();
  QVERIFY2(m_document->run(), m_document->runError() ? m_document->runError()->message().c_str() : "no result");
}

void FieldDocumentTest::anEmptyScratchLeavesNothingBehind() {
  open();
  QVERIFY(!m_document->hasContent());
  const QString file = m_document->file();
  QVERIFY(QFile::exists(file));
  QVERIFY(m_document->close());
  QVERIFY(!QFile::exists(file));
}

void FieldDocumentTest::aScratchWithContentIsKeptAndRecovered() {
  open();
  m_document->setCampaign(m_campaign, "import");
  QVERIFY(m_document->hasUnsavedState());
  QVERIFY(m_document->close());
  QCOMPARE(m_document->campaign().rows.size(), 0U);
  const auto kept = ScratchFolder::recoverable();
  QCOMPARE(kept.size(), 1);
  QVERIFY(*CalibrationDocument::probe(kept.first().file) == session::SessionKind::Field);
  QVERIFY(m_document->open(kept.first().file));
  QVERIFY(m_document->isScratch());
  QCOMPARE(m_document->campaign().rows.size(), m_campaign.rows.size());
}

void FieldDocumentTest::anAngleSessionIsRefused() {
  const QString file = m_home->filePath("angle.sedge");
  QVERIFY((*session::Session::create(file.toStdString(), session::SessionKind::Angle))->close());
  openWithCampaign();
  const auto opened = m_document->open(file);
  QVERIFY(!opened);
  QCOMPARE(opened.error().what, "this session is not a field calibration");
  QVERIFY(m_document->run()); // the one that was open stays open
}

void FieldDocumentTest::everythingIsThereAfterReopening() {
  const QString target = m_home->filePath("a.sedge");
  open();
  m_document->setCampaign(m_campaign, "import");
  m_document->setRowsEnabled({0, 5, 9}, false);
  FieldChoices choices;
  choices.order = 4;
  choices.method = field::FitMethod::Joint;
  choices.fullScaleT = 2.5;
  choices.referenceTemperatureC = 23.5;
  choices.blocksOff = {field::Block::Electronics, field::Block::AxisMatrix};
  choices.limitPercent = 0.02;
  choices.percentOf = field::PercentOf::Reading;
  m_document->setChoices(choices, "choose");
  field::Campaign fresh = m_campaign;
  fresh.name = "fresh.csv";
  m_document->setVerificationCampaign(fresh);
  Traceability who;
  who.deviceSerial = "H-1";
  who.reference.uncertainty = 5e-6;
  m_document->setTraceability(who);
  devices::FieldPlan plan = m_document->plan();
  plan.settleS = 7.5;
  m_document->setPlan(plan);
  QVERIFY(m_document->saveAs(target));
  QVERIFY(m_document->close());
  QVERIFY(m_document->choices() == FieldChoices{});

  QVERIFY(m_document->open(target));
  QCOMPARE(field::campaignCsv(m_document->campaign()), field::campaignCsv(m_campaign));
  QCOMPARE(m_document->campaign().name, "probe.csv");
  QCOMPARE(m_document->campaign().sha256, m_campaign.sha256);
  QCOMPARE(m_document->campaign().rows[10].line, m_campaign.rows[10].line);
  QVERIFY(!m_document->isCaptured());
  QVERIFY(!m_document->isRowEnabled(0) && m_document->isRowEnabled(1) && !m_document->isRowEnabled(9));
  QVERIFY(m_document->choices() == choices);
  QCOMPARE(m_document->verificationCampaign().name, "fresh.csv");
  QCOMPARE(m_document->verificationCampaign().rows.size(), m_campaign.rows.size());
  QCOMPARE(m_document->traceability().deviceSerial, "H-1");
  QVERIFY(m_document->plan() == plan);
  QVERIFY(!m_document->hasUnsavedState());
}

void FieldDocumentTest::reopeningDoesNotTouchTheFile() {
  const QString target = m_home->filePath("a.sedge");
  openWithCampaign();
  QVERIFY(m_document->saveAs(target));
  field::FieldCalibration result = m_document->run()->result;
  QCOMPARE(*m_document->session()->document("result"), exporting::fieldCalibrationToJson(result));
  QVERIFY(m_document->close());
  result.created = "2020-02-29T12:00:00Z"; // long ago: what is computed now says another time
  const std::string kept = exporting::fieldCalibrationToJson(result);
  {
    const auto session = session::Session::open(target.toStdString());
    QVERIFY(session);
    QVERIFY((*session)->setDocument("result", kept));
    QVERIFY((*session)->close());
  }

  QVERIFY(m_document->open(target));
  waitUntilIdle();
  QVERIFY(m_document->run());
  QVERIFY(!m_document->hasUnsavedState()); // the same result again is nothing new
  QCOMPARE(*m_document->session()->document("result"), kept);
  FieldChoices choices;
  choices.order = 3;
  m_document->setChoices(choices, "order");
  waitUntilIdle();
  QVERIFY(m_document->hasUnsavedState());
  QVERIFY(m_document->close());
  const auto closed = session::Session::openReadOnly(target.toStdString());
  QVERIFY(closed);
  const auto changed = exporting::fieldCalibrationFromJson(*(*closed)->document("result"), "result");
  QVERIFY(changed);
  QCOMPARE(changed->order, 3);
}

void FieldDocumentTest::capturedSamplesBecomeTheCampaign() {
  open();
  {
    auto sink = m_document->session()->fieldSink(session::SweepRole::Calibration);
    QVERIFY(sink);
    std::vector<session::FieldSample> samples;
    for (const auto& row : m_campaign.rows) {
      samples.push_back(field::sampleFromRow(row));
      samples.back().sequence = static_cast<std::int64_t>(samples.size()) - 1;
      samples.back().stage = static_cast<int>(row.step);
    }
    QVERIFY((*sink)->append(samples));
    QVERIFY((*sink)->commit());
  }
  QVERIFY(m_document->hasContent());
  QSignalSpy changed(m_document.get(), &FieldDocument::campaignChanged);
  m_document->reloadCampaignFromSession();
  QCOMPARE(changed.count(), 1);
  QVERIFY(m_document->isCaptured());
  QCOMPARE(field::campaignCsv(m_document->campaign()), field::campaignCsv(m_campaign));
  m_document->setRowsEnabled({3}, false);
  m_document->reloadCampaignFromSession(); // nothing new: what was switched off stays off
  QVERIFY(!m_document->isRowEnabled(3));
  QVERIFY(m_document->undoStack().canUndo());
  waitUntilIdle();
  QVERIFY(m_document->run());
  const std::string csv = field::campaignCsv(m_campaign);
  QCOMPARE(m_document->run()->result.source.sha256,
           QCryptographicHash::hash(QByteArray::fromStdString(csv), QCryptographicHash::Sha256).toHex().toStdString());
  QVERIFY(m_document->run()->result.source.file.ends_with(".sedge"));

  const QString target = m_home->filePath("captured.sedge");
  QVERIFY(m_document->saveAs(target));
  QVERIFY(m_document->close());
  QVERIFY(m_document->open(target));
  QVERIFY(m_document->isCaptured());
  QCOMPARE(m_document->campaign().rows.size(), m_campaign.rows.size());
  QVERIFY(!m_document->isRowEnabled(3));
}

void FieldDocumentTest::runsArePlateausAndSweeps() {
  const auto runs = campaignRuns(m_campaign);
  QVERIFY(runs.size() > 20);
  std::size_t next = 0;
  for (const CampaignRun& run : runs) {
    QCOMPARE(run.first, next);
    QVERIFY(run.count > 0);
    next += run.count;
    for (std::size_t i = run.first; i < next; ++i) {
      QVERIFY(m_campaign.rows[i].step == run.step && m_campaign.rows[i].axis == run.axis);
    }
  }
  QCOMPARE(next, m_campaign.rows.size());
  // A step of 11 mT begins another plateau, one of 9 mT does not.
  field::Campaign two;
  for (const double referenceT : {0.5, 0.509, 0.52, 0.521}) {
    field::CampaignRow row;
    row.axis = field::Axis::X;
    row.locked = true;
    row.referenceT = referenceT;
    two.rows.push_back(row);
  }
  const auto plateaus = campaignRuns(two);
  QCOMPARE(plateaus.size(), 2U);
  QCOMPARE(plateaus[1].first, 2U);
  QCOMPARE(plateaus[1].referenceT, 0.5205);
}

void FieldDocumentTest::switchedOffRowsCountNoLonger() {
  openWithCampaign();
  const auto plateausOfX = [this] { return m_document->run()->reports.nonlinearity[0]->plateaus.plateaus.size(); };
  const std::size_t before = plateausOfX();
  const auto runs = campaignRuns(m_document->campaign());
  const auto plateau = std::find_if(runs.begin(), runs.end(), [](const CampaignRun& run) {
    return run.step == field::CampaignStep::Nonlinearity && run.axis == field::Axis::X && run.locked >= 3;
  });
  QVERIFY(plateau != runs.end());
  std::vector<std::size_t> rows(plateau->count);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] = plateau->first + i;
  }
  m_document->setRowsEnabled(rows, false, "switch off the plateau");
  QCOMPARE(m_document->undoStack().undoText(), "switch off the plateau");
  waitUntilIdle();
  QCOMPARE(plateausOfX(), before - 1);
  m_document->undoStack().undo();
  waitUntilIdle();
  QCOMPARE(plateausOfX(), before);
  const int steps = m_document->undoStack().count();
  m_document->setRowsEnabled({1000000}, false); // no such row
  m_document->setRowsEnabled({2}, true);        // is on already
  QCOMPARE(m_document->undoStack().count(), steps);
}

void FieldDocumentTest::importIsUndoable() {
  openWithCampaign();
  m_document->undoStack().undo();
  QCOMPARE(m_document->campaign().rows.size(), 0U);
  waitUntilIdle();
  QVERIFY(!m_document->run());
  QVERIFY(!m_document->runError());
  QVERIFY(!m_document->verification());
  m_document->undoStack().redo();
  QCOMPARE(m_document->campaign().rows.size(), m_campaign.rows.size());
}

void FieldDocumentTest::choicesUndoAndMerge() {
  open();
  FieldChoices choices;
  for (const double limit : {0.04, 0.03, 0.02}) {
    choices.limitPercent = limit;
    m_document->setChoices(choices, "limit");
  }
  choices.order = 7;
  m_document->setChoices(choices, "order");
  QCOMPARE(m_document->undoStack().count(), 2);
  m_document->undoStack().undo();
  QCOMPARE(m_document->choices().order, 5);
  QCOMPARE(m_document->choices().limitPercent, 0.02);
  m_document->undoStack().undo();
  QCOMPARE(m_document->choices().limitPercent, 0.05);
  QSignalSpy changed(m_document.get(), &FieldDocument::choicesChanged);
  m_document->setChoices(m_document->choices(), "nothing");
  QCOMPARE(changed.count(), 0);
}

void FieldDocumentTest::aBlockSwitchedOffIsOff() {
  openWithCampaign();
  QVERIFY(m_document->run()->reports.axisMatrix);
  QVERIFY(m_document->run()->reports.electronics[0]);
  FieldChoices choices;
  choices.blocksOff = {field::Block::AxisMatrix, field::Block::Electronics};
  m_document->setChoices(choices, "blocks");
  waitUntilIdle();
  QVERIFY(m_document->run());
  QVERIFY(!m_document->run()->result.chain.axisMatrix);
  QVERIFY(!m_document->run()->result.chain.axes[0].electronicsT);
  QVERIFY(m_document->run()->result.chain.axes[0].offsetT);
  const auto& warnings = m_document->run()->result.warnings;
  QVERIFY(std::any_of(warnings.begin(), warnings.end(),
                      [](const auto& warning) { return warning.block == field::Block::AxisMatrix; }));
}

void FieldDocumentTest::recomputeFollowsChoices() {
  openWithCampaign();
  QCOMPARE(m_document->run()->result.order, 5);
  QVERIFY(m_document->run()->result.uncertainty);
  QVERIFY(m_document->run()->result.uncertainty->largestT > 0.0);
  QVERIFY(!m_document->run()->result.created.empty());
  QVERIFY(!m_document->run()->joint);
  FieldChoices choices;
  choices.order = 3;
  choices.method = field::FitMethod::Joint;
  m_document->setChoices(choices, "choose");
  const auto former = m_document->run();
  QVERIFY(former); // until the job is done the former result stays
  waitUntilIdle();
  QCOMPARE(m_document->run()->result.order, 3);
  QVERIFY(m_document->run()->joint);
  QVERIFY(former != m_document->run());
}

void FieldDocumentTest::aRefusedCampaignSaysWhy() {
  openWithCampaign();
  field::Campaign positive = m_campaign;
  std::erase_if(positive.rows, [](const field::CampaignRow& row) {
    return row.step == field::CampaignStep::Nonlinearity && row.axis == field::Axis::Y && row.referenceT < 0.0;
  });
  m_document->setCampaign(positive, "import");
  waitUntilIdle();
  QVERIFY(!m_document->run());
  QVERIFY(!m_document->verification());
  QVERIFY(m_document->runError().has_value());
  QCOMPARE(m_document->runError()->kind, ErrorKind::Input);
  m_document->undoStack().undo();
  waitUntilIdle();
  QVERIFY(m_document->run());
  QVERIFY(m_document->verification());
}

void FieldDocumentTest::verificationFollowsTheLimit() {
  openWithCampaign();
  QVERIFY(m_document->verification());
  QVERIFY(!m_document->verificationIsFresh());
  const double peak = m_document->verification()->peakPercent;
  QVERIFY(peak > 0.0);
  FieldChoices choices;
  choices.limitPercent = peak * 1.01;
  m_document->setChoices(choices, "limit");
  waitUntilIdle();
  QVERIFY(m_document->verification()->met);
  choices.limitPercent = peak * 0.99;
  m_document->setChoices(choices, "limit");
  waitUntilIdle();
  QVERIFY(!m_document->verification()->met);
}

void FieldDocumentTest::aFreshCampaignIsVerifiedInstead() {
  openWithCampaign();
  const double peak = m_document->verification()->peakPercent;
  auto settings = devices::quickHallCampaign(7);
  settings.seed += 1; // the same probe, other noise
  m_document->setVerificationCampaign(devices::makeHallCampaign(settings));
  waitUntilIdle();
  QVERIFY(m_document->verification());
  QVERIFY(m_document->verificationIsFresh());
  QVERIFY(m_document->verification()->peakPercent != peak);
  m_document->setVerificationCampaign({});
  waitUntilIdle();
  QVERIFY(!m_document->verificationIsFresh());
  QCOMPARE(m_document->verification()->peakPercent, peak);
  field::Campaign useless = m_campaign;
  std::erase_if(useless.rows,
                [](const field::CampaignRow& row) { return row.step == field::CampaignStep::Verification; });
  m_document->setVerificationCampaign(useless);
  waitUntilIdle();
  QVERIFY(!m_document->verification());
  QVERIFY(m_document->verificationError());
}

void FieldDocumentTest::comparisonIsMadeWhileWanted() {
  openWithCampaign();
  QVERIFY(!m_document->comparison()); // nobody has asked
  m_document->setComparisonWanted(true);
  m_document->setComparisonWanted(false); // cancelled before it could end
  m_document->setComparisonWanted(true);
  waitUntilIdle();
  QVERIFY(m_document->comparison());
  QVERIFY(m_document->comparisonIsCurrent());
  const auto first = m_document->comparison();
  QVERIFY(first->choices.size() > 7);
  m_document->setComparisonWanted(true); // is there already
  QVERIFY(!m_jobs->busy());
  m_document->setComparisonWanted(false);
  m_document->setRowsEnabled({0}, false);
  waitUntilIdle();
  QCOMPARE(m_document->comparison(), first);
  QVERIFY(!m_document->comparisonIsCurrent());
  m_document->setComparisonWanted(true);
  waitUntilIdle();
  QVERIFY(m_document->comparisonIsCurrent());
  QVERIFY(m_document->comparison() != first);
  m_document->setCampaign({}, "nothing");
  waitUntilIdle();
  QVERIFY(!m_document->comparison());
}

void FieldDocumentTest::detailsTravelWithTheResult() {
  openWithCampaign();
  Traceability who;
  who.deviceSerial = "H-7";
  m_document->setTraceability(who);
  waitUntilIdle();
  QCOMPARE(m_document->run()->result.traceability.deviceSerial, "H-7");
  m_document->undoStack().undo();
  QVERIFY(m_document->traceability().deviceSerial.empty());
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::FieldDocumentTest)
#include "field_document_test.moc"
