#include "app/gui/document/field_bench_link.h"

#include "app/gui/document/document_json.h"
#include "app/gui/document/field_document.h"
#include "devices/capture/field_course.h"

#include <string>

namespace straightedge::gui {

namespace {

/// As the command line names it.
constexpr const char* simulatedBenchDocument = "simulated-bench";
// The noise of a campaign that is gone on with, and of a fresh one, is not the noise from its first row on again.
constexpr std::uint64_t seedPerSample = 0x9E3779B97F4A7C15ULL;
constexpr std::uint64_t seedOfVerification = 0xD1B54A32D192ED03ULL;

bool hasStage(const devices::FieldPlan& plan, int stage) {
  return stage >= 0 && static_cast<std::size_t>(stage) < plan.stages.size();
}

void setSkipped(devices::FieldPlan& plan, int stage, bool skipped) {
  plan.stages[static_cast<std::size_t>(stage)].skipped = skipped;
}

} // namespace

FieldBenchLink::FieldBenchLink(FieldDocument& document, QObject* parent)
    : BenchLinkOf(document, parent), m_document(document) {
  m_settings.realTime = false; // a campaign takes hours
  connect(&document, &FieldDocument::opened, this, &FieldBenchLink::useSettingsOfSession);
}

FieldBenchLink::~FieldBenchLink() { finishLife(); }

void FieldBenchLink::useSettingsOfSession() {
  const session::Session* session = std::as_const(m_document).session();
  if (isConnected() || session == nullptr) {
    return;
  }
  const Result<std::string> stored = session->document(simulatedBenchDocument);
  if (!stored || stored->empty()) {
    return;
  }
  if (const auto settings = devices::simulatedFieldSettingsFromJson(*stored)) {
    const bool realTime = m_settings.realTime;
    m_settings = *settings;
    m_settings.realTime = realTime;
    emit connectionChanged();
  }
}

Result<void> FieldBenchLink::connectSimulated(const devices::SimulatedFieldSettings& settings) {
  if (Result<void> isFree = checkFree(); !isFree) {
    return isFree;
  }
  auto simulated = std::make_shared<devices::SimulatedFieldBench>(settings);
  m_settings = settings;
  m_simulated = simulated; // before connectionChanged()
  const devices::FieldBench bench = simulated->bench();
  return connectBench(bench, std::move(simulated));
}

Result<void> FieldBenchLink::connectBench(devices::FieldBench bench, std::shared_ptr<void> owner) {
  if (Result<void> isFree = checkFree(); !isFree) {
    return isFree;
  }
  if (bench.probe == nullptr || bench.clock == nullptr) {
    return fail(ErrorKind::Usage, "the bench has no teslameter", "choose an instrument for it");
  }
  if (m_simulated.lock() != owner) {
    m_simulated.reset();
  }
  std::vector<BenchInstrument> instruments = {{tr("Teslameter under calibration"), bench.probe->identity()}};
  const auto add = [&instruments](const QString& role, const auto* instrument) {
    if (instrument != nullptr) {
      instruments.push_back({role, instrument->identity()});
    }
  };
  add(tr("Reference field"), bench.reference);
  add(tr("PT100"), bench.pt100);
  add(tr("Magnet"), bench.magnet);
  add(tr("Probe chamber"), bench.probeChamber);
  add(tr("Electronics chamber"), bench.electronicsChamber);
  take(bench, std::move(owner), std::move(instruments));
  return {};
}

void FieldBenchLink::connectReader(const FieldLiveReader& reader) {
  connect(&reader, &FieldLiveReader::reading, this, &FieldBenchLink::liveReading);
  connect(&reader, &FieldLiveReader::failed, this, &FieldBenchLink::failed);
}

bool FieldBenchLink::canSetField() const { return reader() != nullptr && m_bench.magnet != nullptr; }

void FieldBenchLink::setFieldT(double fieldT) {
  if (canSetField()) {
    reader()->setFieldT(fieldT);
  }
}

bool FieldBenchLink::canPlaceProbe() const { return reader() != nullptr && m_bench.carrier != nullptr; }

void FieldBenchLink::placeProbe(devices::ProbePlacement placing) {
  if (canPlaceProbe()) {
    reader()->placeProbe(placing);
  }
}

Result<void> FieldBenchLink::prepareCapture(session::Session& session, bool resume, std::size_t samplesAlready) {
  if (captureRole() == session::SweepRole::Calibration) {
    if (Result<void> kept = session.setDocument(planDocument, devices::planToJson(m_plan)); !kept) {
      return kept;
    }
  }
  return renewSimulated(session, resume, samplesAlready);
}

/// A capture begins on a new simulated bench, so that the same seed gives the same campaign whatever was read before;
/// one that goes on has the settings that it was begun with.
Result<void> FieldBenchLink::renewSimulated(session::Session& session, bool resume, std::size_t samplesAlready) {
  const bool ofCalibration = captureRole() == session::SweepRole::Calibration;
  devices::SimulatedFieldSettings settings = m_settings;
  if (resume && ofCalibration) {
    const Result<std::string> stored = session.document(simulatedBenchDocument);
    if (!stored) {
      return std::unexpected(stored.error());
    }
    if (stored->empty() == isSimulated()) {
      return isSimulated()
                 ? fail(ErrorKind::Usage, "this campaign was begun on instruments, not on the simulated bench",
                        "connect them in the step Connect, or start over")
                 : fail(ErrorKind::Usage, "this campaign was begun on the simulated bench",
                        "connect that in the step Connect, or start over");
    }
    if (isSimulated()) {
      const auto begunWith = devices::simulatedFieldSettingsFromJson(*stored);
      if (!begunWith) {
        return std::unexpected(begunWith.error());
      }
      settings = *begunWith;
      settings.realTime = m_settings.realTime;
      settings.byHand = m_settings.byHand;
    }
  } else if (ofCalibration) {
    if (Result<void> kept = session.setDocument(
            simulatedBenchDocument, isSimulated() ? devices::simulatedFieldSettingsToJson(settings) : std::string());
        !kept) {
      return kept;
    }
  } else {
    settings.seed += seedOfVerification;
  }
  if (isSimulated()) {
    settings.seed += seedPerSample * samplesAlready;
    auto simulated = std::make_shared<devices::SimulatedFieldBench>(settings);
    m_bench = simulated->bench();
    m_simulated = simulated;
    m_owner = std::move(simulated);
  }
  return {};
}

void FieldBenchLink::confirm() {
  if (!m_capture) {
    return;
  }
  const devices::FieldCaptureProgress now = m_capture->progress();
  const auto simulated = m_simulated.lock();
  // The hand that lays the simulated probe. The capture thread waits meanwhile.
  if (simulated && !now.waitingFor.empty() && hasStage(m_plan, now.stage)) {
    const auto placing = devices::placementOf(m_plan.stages[static_cast<std::size_t>(now.stage)]);
    if (now.waitingFor == devices::placementInstruction(placing)) {
      simulated->placeByHand(placing);
    }
  }
  m_capture->confirm();
}

void FieldBenchLink::redoStage(int stage) {
  if (isCapturing()) {
    if (hasStage(m_plan, stage)) {
      setSkipped(m_plan, stage, false); // a stage that is wanted again is not left out
      m_capture->redo(stage);
    }
    return;
  }
  const session::Session* session = std::as_const(m_document).session();
  auto record = session == nullptr ? std::nullopt : readFieldCaptureRecord(*session, session::SweepRole::Calibration);
  if (!record || !hasStage(record->plan, stage)) {
    emit failed(tr("This campaign was not captured on a bench; a single stage cannot be measured again."));
    return;
  }
  setSkipped(record->plan, stage, false);
  if (const Result<void> begun = beginCapture(record->plan, session::SweepRole::Calibration, true, stage); !begun) {
    emit failed(QString::fromStdString(begun.error().message()));
  }
}

void FieldBenchLink::skipStage(int stage, bool skipped) {
  session::Session* session = m_document.session();
  if (session == nullptr) {
    return;
  }
  if (isCapturing()) {
    if (hasStage(m_plan, stage)) {
      setSkipped(m_plan, stage, skipped);
      m_capture->skip(stage, skipped);
      skipInSession(*session, {m_plan, false, describe()}, stage, skipped);
    }
    return;
  }
  auto record = readFieldCaptureRecord(*session, session::SweepRole::Calibration);
  if (record && session->fieldSampleCount(session::SweepRole::Calibration).value_or(0) > 0) {
    if (hasStage(record->plan, stage)) {
      skipInSession(*session, std::move(*record), stage, skipped);
    }
    return;
  }
  devices::FieldPlan plan = m_document.plan();
  if (hasStage(plan, stage)) {
    setSkipped(plan, stage, skipped);
    // A step of its own: undone alone, however the plan was edited before and after.
    m_document.undoStack().beginMacro(skipped ? tr("leave out a stage") : tr("take a stage back in"));
    m_document.setPlan(plan);
    m_document.undoStack().endMacro();
  }
}

void FieldBenchLink::skipInSession(session::Session& session, FieldCaptureRecord record, int stage, bool skipped) {
  const bool capturing = isCapturing();
  const auto role = capturing ? captureRole() : session::SweepRole::Calibration;
  setSkipped(record.plan, stage, skipped);
  if (!capturing) {
    const auto samples = session.fieldSamples(role);
    const auto course = samples ? devices::FieldCourse::make(record.plan, *samples)
                                : Result<devices::FieldCourse>(std::unexpected(samples.error()));
    if (!course) { // every stage is left out: there has to be something to go on with
      emit failed(QString::fromStdString(course.error().message()));
      return;
    }
    // Plateaus that were given up stay so: what was finished is finished unless something unmeasured comes in.
    record.finished = record.finished ? skipped || course->pointsDone(stage) == course->pointsPlanned(stage)
                                      : !course->next().has_value();
  }
  Result<void> kept = writeCaptureRecord(session, role, record);
  if (kept && role == session::SweepRole::Calibration) {
    kept = session.setDocument(planDocument, devices::planToJson(record.plan));
  }
  if (!kept) {
    emit failed(QString::fromStdString(kept.error().message()));
  }
  emit progressChanged();
}

void FieldBenchLink::takeSamplesIn(session::SweepRole role) {
  if (role == session::SweepRole::Calibration) {
    m_document.reloadCampaignFromSession();
  } else {
    m_document.reloadVerificationFromSession();
  }
}

} // namespace straightedge::gui
