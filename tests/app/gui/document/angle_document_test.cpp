#include "app/gui/document/angle_document.h"
#include "app/gui/document/scratch_folder.h"
#include "app/gui/jobs/job_runner.h"
#include "core/angle/session_sweep.h"
#include "core/angle/sweep_csv.h"
#include "core/export/calibration_json.h"

#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace straightedge::gui {

class AngleDocumentTest : public QObject {
  Q_OBJECT
private slots:
  void init();
  void cleanup();

  void anEmptyScratchLeavesNothingBehind();
  void aScratchWithContentIsKeptAndRecovered();
  void anOpenScratchIsNotOfferedForRecovery();
  void discardRemovesTheScratchFile();
  void saveAsMovesTheScratchFile();
  void saveAsReplacesAnotherFile();
  void saveAsIntoNowhereKeepsTheScratch();
  void openRefusesWhatIsNoSession();
  void everythingIsThereAfterReopening();
  void capturedSamplesBecomeTheSweep();
  void choicesUndoAndMerge();
  void switchedOffPointsCountNoLonger();
  void importIsUndoable();
  void aRefusedSweepSaysWhy();
  void recomputeFollowsChoices();
  void verificationFollowsTheLimit();
  void resultsAreKeptInTheSession();
  void aCapturedSweepIsTracedAsOnTheCommandLine();

private:
  angle::Sweep exampleSweep() const;
  void waitUntilIdle();

  std::unique_ptr<QTemporaryDir> m_home;
  std::unique_ptr<JobRunner> m_jobs;
  std::unique_ptr<AngleDocument> m_document;
};

void AngleDocumentTest::init() {
  m_home = std::make_unique<QTemporaryDir>();
  QVERIFY(m_home->isValid());
  qputenv("XDG_DATA_HOME", m_home->path().toUtf8());
  m_jobs = std::make_unique<JobRunner>();
  m_document = std::make_unique<AngleDocument>(*m_jobs);
}

void AngleDocumentTest::cleanup() {
  m_document.reset();
  m_jobs.reset();
  m_home.reset();
}

angle::Sweep AngleDocumentTest::exampleSweep() const {
  auto sweep = angle::readSweepCsv(STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv");
  return sweep ? *sweep : angle::Sweep{};
}

void AngleDocumentTest::waitUntilIdle() {
  QCoreApplication::processEvents(); // recomputing starts with the event loop's next turn
  if (m_jobs->busy()) {
    QSignalSpy idle(m_jobs.get(), &JobRunner::idle);
    QVERIFY(idle.wait(60000));
  }
}

void AngleDocumentTest::anEmptyScratchLeavesNothingBehind() {
  QVERIFY(m_document->createScratch());
  QVERIFY(m_document->isOpen());
  QVERIFY(m_document->isScratch());
  QVERIFY(!m_document->hasUnsavedState());
  const QString file = m_document->file();
  QVERIFY(QFile::exists(file));
  QVERIFY(m_document->close());
  QVERIFY(!QFile::exists(file));
  QVERIFY(ScratchFolder::recoverable().isEmpty());
}

void AngleDocumentTest::aScratchWithContentIsKeptAndRecovered() {
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  QVERIFY(m_document->hasUnsavedState());
  QVERIFY(m_document->close());
  const auto kept = ScratchFolder::recoverable();
  QCOMPARE(kept.size(), 1);
  QVERIFY(m_document->open(kept.first().file));
  QVERIFY(m_document->isScratch());
  QCOMPARE(m_document->displayName(), "Untitled");
  QCOMPARE(m_document->sweep().size(), 32U);
}

void AngleDocumentTest::anOpenScratchIsNotOfferedForRecovery() {
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  QVERIFY(ScratchFolder::recoverable().isEmpty());
  AngleDocument second(*m_jobs);
  const auto opened = second.open(m_document->file());
  QVERIFY(!opened);
  QCOMPARE(opened.error().what, "this unsaved calibration is open in another window of Straightedge");
}

void AngleDocumentTest::discardRemovesTheScratchFile() {
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  QVERIFY(m_document->discard());
  QVERIFY(!m_document->isOpen());
  QVERIFY(ScratchFolder::recoverable().isEmpty());
}

void AngleDocumentTest::saveAsMovesTheScratchFile() {
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  const QString former = m_document->file();
  const QString target = m_home->filePath("bearing 7.sedge");
  QVERIFY(m_document->saveAs(target));
  QVERIFY(!m_document->isScratch());
  QVERIFY(!m_document->hasUnsavedState());
  QCOMPARE(m_document->displayName(), "bearing 7");
  QVERIFY(!QFile::exists(former));
  QVERIFY(!QFile::exists(target + ".part"));
  m_document->setPointsEnabled({3}, false); // goes into the new file
  QVERIFY(m_document->close());
  QVERIFY(m_document->open(target));
  QCOMPARE(m_document->sweep().size(), 32U);
  QVERIFY(!m_document->sweep().isEnabled(3));
}

void AngleDocumentTest::saveAsReplacesAnotherFile() {
  const QString target = m_home->filePath("a.sedge");
  QVERIFY(m_document->createScratch());
  QVERIFY(m_document->saveAs(target));
  QVERIFY(m_document->close());
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  QVERIFY(m_document->saveAs(target));
  QVERIFY(m_document->close());
  QVERIFY(m_document->open(target));
  QCOMPARE(m_document->sweep().size(), 32U);
}

void AngleDocumentTest::saveAsIntoNowhereKeepsTheScratch() {
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  const auto saved = m_document->saveAs(m_home->filePath("no/such/folder/a.sedge"));
  QVERIFY(!saved);
  QCOMPARE(saved.error().kind, ErrorKind::Storage);
  QVERIFY(m_document->isScratch());
  QVERIFY(QFile::exists(m_document->file()));
  QCOMPARE(m_document->sweep().size(), 32U);
}

void AngleDocumentTest::openRefusesWhatIsNoSession() {
  const QString file = m_home->filePath("letter.sedge");
  QFile letter(file);
  QVERIFY(letter.open(QIODevice::WriteOnly));
  letter.write("Dear Sir or Madam, this is no database at all, whatever its name says.\n");
  letter.close();
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  const auto opened = m_document->open(file);
  QVERIFY(!opened);
  QVERIFY(!opened.error().message().empty());
  QVERIFY(m_document->isOpen()); // the one that was open stays open
  QCOMPARE(m_document->sweep().size(), 32U);
  QVERIFY(letter.open(QIODevice::ReadOnly));
  QVERIFY(letter.readAll().startsWith("Dear Sir"));
}

void AngleDocumentTest::everythingIsThereAfterReopening() {
  const QString target = m_home->filePath("a.sedge");
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  m_document->setPointsEnabled({0, 31}, false);
  m_document->setVerificationSweep(exampleSweep());
  AngleChoices choices;
  choices.curveMethod = angle::CurveMethod::Interpolate;
  choices.models = {*angle::parseModelName("linear:24@minimax/12"), *angle::parseModelName("lut:100")};
  choices.selected = *angle::parseModelName("harmonic:7@ordered");
  choices.targetErrorDeg = 0.1;
  choices.budgetEntries = 20;
  choices.bits = 10;
  choices.limitDeg = 0.3;
  m_document->setChoices(choices, "choose");
  Traceability who;
  who.deviceSerial = "S-1";
  who.operatorName = "Ä. Ohm";
  who.reference.uncertainty = 0.0012;
  who.ambientC = 21.5;
  m_document->setTraceability(who);
  devices::AnglePlan plan;
  plan.pointsPerTurn = 48;
  plan.bothDirections = true;
  m_document->setPlan(plan);
  QVERIFY(m_document->saveAs(target));
  QVERIFY(m_document->close());
  QVERIFY(m_document->choices() == AngleChoices{});
  QCOMPARE(m_document->sweep().size(), 0U);

  QVERIFY(m_document->open(target));
  QCOMPARE(m_document->sweep().encoderDeg, exampleSweep().encoderDeg);
  QCOMPARE(m_document->sweep().sensorDeg, exampleSweep().sensorDeg);
  QCOMPARE(m_document->sweep().source.sha256, exampleSweep().source.sha256);
  QVERIFY(!m_document->sweep().isEnabled(0));
  QVERIFY(m_document->sweep().isEnabled(1));
  QVERIFY(!m_document->sweep().isEnabled(31));
  QCOMPARE(m_document->verificationSweep().size(), 32U);
  QVERIFY(m_document->choices() == choices);
  QCOMPARE(m_document->traceability().deviceSerial, "S-1");
  QCOMPARE(m_document->traceability().operatorName, "Ä. Ohm");
  QCOMPARE(m_document->traceability().reference.uncertainty, 0.0012);
  QCOMPARE(*m_document->traceability().ambientC, 21.5);
  QVERIFY(m_document->plan() == plan);
  QVERIFY(!m_document->hasUnsavedState());
}

void AngleDocumentTest::capturedSamplesBecomeTheSweep() {
  QVERIFY(m_document->createScratch());
  {
    auto sink = m_document->session()->angleSink(session::SweepRole::Calibration);
    QVERIFY(sink);
    std::vector<session::AngleSample> samples(10);
    for (int i = 0; i < 10; ++i) {
      auto& sample = samples[static_cast<std::size_t>(i)];
      sample.sequence = i;
      sample.point = i;
      sample.encoderDeg = 36.0 * i;
      sample.sensorDeg = 36.0 * i;
    }
    samples.push_back(samples[4]); // point 4 again
    samples.back().sequence = 10;
    samples.back().attempt = 1;
    samples.back().sensorDeg = 145.0;
    QVERIFY((*sink)->append(samples));
    QVERIFY((*sink)->commit());
  }
  QSignalSpy changed(m_document.get(), &AngleDocument::sweepChanged);
  m_document->reloadSweepFromSession();
  QCOMPARE(changed.count(), 1);
  QCOMPARE(m_document->sweep().size(), 10U);
  QCOMPARE(m_document->sweep().sensorDeg[4], 145.0);
  // A point that is measured again keeps what was switched off.
  m_document->setPointsEnabled({9}, false);
  m_document->reloadSweepFromSession();
  QVERIFY(!m_document->sweep().isEnabled(9));
  QVERIFY(m_document->undoStack().canUndo());
}

void AngleDocumentTest::resultsAreKeptInTheSession() {
  const QString target = m_home->filePath("a.sedge");
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  m_document->setVerificationSweep(exampleSweep());
  waitUntilIdle();
  QVERIFY(m_document->run() && m_document->verification());
  QVERIFY(m_document->saveAs(target));
  const auto result = m_document->session()->document("result");
  const auto verified = m_document->session()->document("verification-result");
  QVERIFY(result && verified);
  QCOMPARE(*result, exporting::calibrationToJson(m_document->run()->result));
  QVERIFY(verified->find("\"max_error_deg\"") != std::string::npos);
  QVERIFY(m_document->close());

  QVERIFY(m_document->open(target));
  waitUntilIdle();
  QVERIFY(m_document->run() != nullptr);
  QVERIFY(!m_document->hasUnsavedState()); // the same result again is nothing new
  QCOMPARE(*m_document->session()->document("result"), *result);
  AngleChoices choices;
  choices.models = {*angle::parseModelName("lut:100")};
  m_document->setChoices(choices, "choose");
  waitUntilIdle();
  QVERIFY(m_document->close());
  auto closed = session::Session::openReadOnly(target.toStdString());
  QVERIFY(closed);
  QVERIFY((*closed)->document("result")->find("lut:100") != std::string::npos);
}

void AngleDocumentTest::aCapturedSweepIsTracedAsOnTheCommandLine() {
  const QString target = m_home->filePath("captured.sedge");
  QVERIFY(m_document->createScratch());
  {
    auto sink = m_document->session()->angleSink(session::SweepRole::Calibration);
    QVERIFY(sink);
    std::vector<session::AngleSample> samples(32);
    for (int i = 0; i < 32; ++i) {
      auto& sample = samples[static_cast<std::size_t>(i)];
      sample.sequence = i;
      sample.point = i;
      sample.encoderDeg = 11.25 * i;
      sample.sensorDeg = 11.25 * i;
    }
    QVERIFY((*sink)->append(samples));
    QVERIFY((*sink)->commit());
  }
  m_document->reloadSweepFromSession();
  m_document->setPointsEnabled({3}, false);
  QVERIFY(m_document->saveAs(target));
  AngleChoices choices;
  choices.limitDeg = 0.2;
  m_document->setChoices(choices, "limit");
  waitUntilIdle();
  QVERIFY(m_document->run() != nullptr);
  const SourceRecord traced = m_document->run()->result.source;
  QVERIFY(m_document->close());
  const auto onCommandLine = angle::readSessionSweep(target.toStdString(), session::SweepRole::Calibration);
  QVERIFY(onCommandLine);
  QCOMPARE(traced.sha256, onCommandLine->sweep.source.sha256);
  QCOMPARE(traced.sha256.size(), 64U);
  QVERIFY(traced.file.ends_with(".sedge"));
}

void AngleDocumentTest::choicesUndoAndMerge() {
  QVERIFY(m_document->createScratch());
  AngleChoices choices;
  for (const double target : {0.4, 0.3, 0.2}) {
    choices.targetErrorDeg = target;
    m_document->setChoices(choices, "drag target");
  }
  choices.budgetEntries = 7;
  m_document->setChoices(choices, "drag budget");
  QCOMPARE(m_document->undoStack().count(), 2); // the drag is one step
  m_document->undoStack().undo();
  QCOMPARE(m_document->choices().budgetEntries, 64);
  QCOMPARE(m_document->choices().targetErrorDeg, 0.2);
  m_document->undoStack().undo();
  QCOMPARE(m_document->choices().targetErrorDeg, 0.5);
  m_document->undoStack().redo();
  QCOMPARE(m_document->choices().targetErrorDeg, 0.2);
  QSignalSpy changed(m_document.get(), &AngleDocument::choicesChanged);
  m_document->setChoices(m_document->choices(), "nothing");
  QCOMPARE(changed.count(), 0);
}

void AngleDocumentTest::switchedOffPointsCountNoLonger() {
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  waitUntilIdle();
  QVERIFY(m_document->run());
  QCOMPARE(m_document->run()->aligned.readingDeg.size(), 32);
  m_document->setPointsEnabled({5, 6}, false);
  waitUntilIdle();
  QCOMPARE(m_document->run()->aligned.readingDeg.size(), 30);
  m_document->undoStack().undo();
  waitUntilIdle();
  QCOMPARE(m_document->run()->aligned.readingDeg.size(), 32);
  const int steps = m_document->undoStack().count();
  m_document->setPointsEnabled({1000}, false); // no such row
  m_document->setPointsEnabled({2}, true);     // is on already
  QCOMPARE(m_document->undoStack().count(), steps);
}

void AngleDocumentTest::importIsUndoable() {
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  m_document->undoStack().undo();
  QCOMPARE(m_document->sweep().size(), 0U);
  waitUntilIdle();
  QVERIFY(!m_document->run());
  QVERIFY(!m_document->runError());
  m_document->undoStack().redo();
  QCOMPARE(m_document->sweep().size(), 32U);
}

void AngleDocumentTest::aRefusedSweepSaysWhy() {
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  waitUntilIdle();
  QVERIFY(m_document->comparison());
  angle::Sweep few = exampleSweep();
  few.encoderDeg.resize(5);
  few.sensorDeg.resize(5);
  few.line.resize(5);
  m_document->setSweep(few, "import");
  QVERIFY(m_document->run()); // until the job says otherwise the former result stays
  waitUntilIdle();
  QVERIFY(!m_document->run());
  QVERIFY(!m_document->comparison());
  QVERIFY(m_document->runError().has_value());
  QCOMPARE(m_document->runError()->kind, ErrorKind::Input);
  m_document->undoStack().undo();
  waitUntilIdle();
  QVERIFY(m_document->run());
  QVERIFY(!m_document->runError());
  QVERIFY(m_document->comparison());
}

void AngleDocumentTest::recomputeFollowsChoices() {
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  waitUntilIdle();
  QCOMPARE(m_document->run()->result.models.size(), 3U);
  QVERIFY(!m_document->run()->result.created.empty());
  QVERIFY(m_document->comparisonComplete());
  const auto comparison = m_document->comparison();

  AngleChoices choices = m_document->choices();
  choices.models = {*angle::parseModelName("linear:16")};
  choices.selected = *angle::parseModelName("lut:128");
  m_document->setChoices(choices, "choose models");
  waitUntilIdle();
  QCOMPARE(m_document->run()->result.models.size(), 2U); // the chosen ones and the selected one
  QCOMPARE(m_document->run()->result.models[1].name.text(), "lut:128");
  QCOMPARE(m_document->comparison(), comparison); // the curve is the same: nothing to compare anew

  choices.bits = 8;
  m_document->setChoices(choices, "bits");
  waitUntilIdle();
  QVERIFY(m_document->comparison() != comparison);
  QVERIFY(m_document->comparisonComplete());
}

void AngleDocumentTest::verificationFollowsTheLimit() {
  QVERIFY(m_document->createScratch());
  m_document->setSweep(exampleSweep(), "import");
  m_document->setVerificationSweep(exampleSweep());
  waitUntilIdle();
  QVERIFY(m_document->verification().has_value());
  QVERIFY(m_document->verification()->met); // harmonic:4 leaves 0.39° of the limit of 1°
  AngleChoices choices = m_document->choices();
  choices.limitDeg = 0.1;
  m_document->setChoices(choices, "limit");
  waitUntilIdle();
  QVERIFY(!m_document->verification()->met);
  m_document->setVerificationSweep({});
  waitUntilIdle();
  QVERIFY(!m_document->verification().has_value());
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::AngleDocumentTest)
#include "angle_document_test.moc"
