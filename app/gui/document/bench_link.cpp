#include "app/gui/document/bench_link.h"

#include "app/gui/document/angle_document.h"
#include "app/gui/document/captured_sweep.h"

namespace straightedge::gui {

namespace {

/// The session has all samples; the live display may have lost some to a full queue.
std::vector<session::AngleSample> committedSamples(const AngleDocument& document, session::SweepRole role,
                                                   const std::vector<session::AngleSample>& live) {
  const session::Session* session = document.session();
  return session == nullptr ? live : session->angleSamples(role).value_or(live);
}

} // namespace

BenchLink::BenchLink(AngleDocument& document, QObject* parent) : BenchLinkOf(document, parent), m_document(document) {}

BenchLink::~BenchLink() { finishLife(); }

Result<void> BenchLink::connectSimulated(const devices::SimulatedAngleSettings& settings) {
  if (Result<void> isFree = checkFree(); !isFree) {
    return isFree;
  }
  auto simulated = std::make_shared<devices::SimulatedAngleBench>(settings);
  const devices::AngleBench bench = simulated->bench();
  m_settings = settings;
  m_simulated = simulated; // before connectionChanged()
  return connectBench(bench, std::move(simulated));
}

Result<void> BenchLink::connectBench(devices::AngleBench bench, std::shared_ptr<void> owner) {
  if (Result<void> isFree = checkFree(); !isFree) {
    return isFree;
  }
  if (bench.sensor == nullptr || bench.reference == nullptr || bench.clock == nullptr) {
    return fail(ErrorKind::Usage, "the bench has no " + std::string(bench.sensor == nullptr ? "sensor" : "reference"),
                "choose an instrument for it");
  }
  if (m_simulated.lock() != owner) {
    m_simulated.reset();
  }
  std::vector<BenchInstrument> instruments = {{tr("Sensor under calibration"), bench.sensor->identity()},
                                              {tr("Reference encoder"), bench.reference->identity()}};
  if (bench.stage != nullptr) {
    instruments.push_back({tr("Rotary stage"), bench.stage->identity()});
  }
  take(bench, std::move(owner), std::move(instruments));
  return {};
}

void BenchLink::connectReader(const LiveReader& reader) {
  connect(&reader, &LiveReader::reading, this, &BenchLink::liveReading);
  connect(&reader, &LiveReader::failed, this, &BenchLink::failed);
}

bool BenchLink::canMoveShaft() const { return reader() != nullptr && m_bench.stage != nullptr; }

void BenchLink::moveShaftTo(double encoderDeg) {
  if (canMoveShaft()) {
    reader()->moveShaftTo(encoderDeg);
  }
}

void BenchLink::redoPoint(int pointIndex) {
  if (isCapturing()) {
    m_capture->redo(pointIndex);
    return;
  }
  const session::Session* session = m_document.session();
  if (session == nullptr) {
    return;
  }
  const std::optional<CaptureRecord> record = readCaptureRecord(*session, session::SweepRole::Calibration);
  if (!record) {
    emit failed(tr("This sweep was not captured on a bench; a single point cannot be measured again."));
    return;
  }
  if (const Result<void> begun = beginCapture(record->plan, session::SweepRole::Calibration, true, pointIndex);
      !begun) {
    emit failed(QString::fromStdString(begun.error().message()));
  }
}

void BenchLink::takeSamplesIn(session::SweepRole role) {
  if (role == session::SweepRole::Calibration) {
    m_document.reloadSweepFromSession();
  } else {
    m_document.setVerificationSweep(capturedSweep(committedSamples(m_document, role, liveSamples())));
  }
}

} // namespace straightedge::gui
