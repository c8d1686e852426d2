#include "devices/capture/field_worker.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace straightedge::devices {

namespace {

/// In the package's axes the field points the other way where the package's minus direction points along it.
double packageSign(const FieldStage& stage) {
  return stage.orientation && static_cast<int>(*stage.orientation) % 2 == 1 ? -1.0 : 1.0;
}

Error noReading(const char* what, const std::string& where) {
  return {ErrorKind::Instrument, what, "see to the instrument and its range, then resume", where};
}

} // namespace

FieldWorker::FieldWorker(FieldBench bench, session::FieldSampleSink& sink, FieldCourse course,
                         FieldCaptureShared& shared)
    : CaptureLoop(*bench.clock, shared, bench.connection, course.plan().retries), m_bench(std::move(bench)),
      m_sink(sink), m_course(std::move(course)), m_shared(shared),
      m_givenUp(static_cast<std::size_t>(m_course.stages()), 0) {}

void FieldWorker::takeRequests() {
  const std::scoped_lock lock(m_shared.mutex);
  for (const auto& [stage, skipped] : m_shared.skipRequests) {
    m_course.skip(stage, skipped);
  }
  for (const int stage : m_shared.redoRequests) {
    m_course.redo(stage);
    if (stage >= 0 && stage < m_course.stages()) {
      m_givenUp[static_cast<std::size_t>(stage)] = 0;
    }
  }
  m_shared.skipRequests.clear();
  m_shared.redoRequests.clear();
}

bool FieldWorker::requestsWait() const { return CaptureLoop::requestsWait() || !m_shared.skipRequests.empty(); }

bool FieldWorker::abandonsPresent() const {
  const std::scoped_lock lock(m_shared.mutex);
  const auto holds = [](const auto& list, const auto& item) { return std::ranges::find(list, item) != list.end(); };
  return holds(m_shared.redoRequests, m_present) || holds(m_shared.skipRequests, std::pair(m_present, true));
}

void FieldWorker::tell(FieldAction action, double target) {
  const std::scoped_lock lock(m_shared.mutex);
  m_shared.action = action;
  m_shared.target = target;
}

void FieldWorker::tellRows(FieldTask task) {
  const std::scoped_lock lock(m_shared.mutex);
  m_shared.rowsTaken = m_course.rowsTaken(task);
}

void FieldWorker::forgetPositions() {
  m_placement.reset();
  m_fieldT.reset();
  m_probeC.reset();
  m_electronicsC.reset();
}

CaptureLoop::Step<void> FieldWorker::measureNext() {
  const FieldTask task = *m_course.next();
  m_present = task.stage;
  {
    const std::scoped_lock lock(m_shared.mutex);
    m_shared.stage = task.stage;
    m_shared.rowsTaken = m_course.rowsTaken(task);
  }
  publishProgress();
  if (auto prepared = prepare(task); !prepared) {
    return prepared;
  }
  auto measured = isSweep(m_course.stage(task.stage)) ? measureSweep(task) : measurePlateau(task);
  if (measured) {
    const std::scoped_lock lock(m_shared.mutex);
    m_shared.rowsTaken = 0; // counted among the points from here on
  }
  publishProgress();
  return measured;
}

CaptureLoop::Step<void> FieldWorker::prepare(FieldTask task) {
  if (auto placed = place(m_course.stage(task.stage)); !placed) {
    return placed;
  }
  // The magnet first: the temperature's settling is the field's, too.
  if (auto set = setField(task); !set) {
    return set;
  }
  return setTemperatures(task);
}

CaptureLoop::Step<void> FieldWorker::place(const FieldStage& stage) {
  const ProbePlacement placement = placementOf(stage);
  if (m_placement == placement) {
    return {};
  }
  tell(FieldAction::Placing);
  auto placed = m_bench.carrier != nullptr ? fromInstrument(m_bench.carrier->place(placement), "probe carrier")
                                           : askFor(placementInstruction(placement));
  if (placed) {
    m_placement = placement;
  }
  return placed;
}

CaptureLoop::Step<void> FieldWorker::setField(FieldTask task) {
  const FieldStage& stage = m_course.stage(task.stage);
  if (!needsReference(stage)) {
    return {};
  }
  const double fieldT = m_course.point(task).fieldT;
  if (m_fieldT == fieldT) {
    return {};
  }
  tell(FieldAction::SettingField, fieldT);
  auto set = m_bench.magnet != nullptr ? fromInstrument(m_bench.magnet->setFieldT(fieldT), "magnet")
                                       : askFor("set the field to " + formatForPeople(fieldT) + " T");
  if (set) {
    set = wait(m_course.plan().settleS);
  }
  if (set) {
    m_fieldT = fieldT;
  }
  return set;
}

CaptureLoop::Step<void> FieldWorker::setTemperatures(FieldTask task) {
  const FieldStage& stage = m_course.stage(task.stage);
  const double roomC = m_course.plan().referenceTemperatureC;
  const double startsC = isSweep(stage) ? sweepC(stage, m_course.rowsTaken(task)) : roomC;
  if (isProbeSweep(stage)) { // starts anew with every field, wherever the one before ended
    m_probeC.reset();
  } else if (isElectronicsSweep(stage)) {
    m_electronicsC.reset();
  }
  const double probeC = isProbeSweep(stage) ? startsC : m_course.point(task).probeC.value_or(roomC);
  if (auto set = setTemperature(m_bench.probeChamber, m_probeC, probeC, true); !set) {
    return set;
  }
  return setTemperature(m_bench.electronicsChamber, m_electronicsC,
                        isElectronicsSweep(stage) ? startsC : m_course.point(task).electronicsC.value_or(roomC), false);
}

CaptureLoop::Step<void> FieldWorker::setTemperature(TemperatureChamber* chamber, std::optional<double>& at,
                                                    double targetC, bool ofProbe) {
  if (at == targetC) {
    return {};
  }
  tell(ofProbe ? FieldAction::SettlingProbe : FieldAction::SettlingElectronics, targetC);
  Step<void> set;
  if (chamber != nullptr) {
    set = fromInstrument(chamber->setC(targetC), "chamber");
  } else if (targetC != m_course.plan().referenceTemperatureC) {
    set = askFor("bring " + std::string(ofProbe ? "the probe" : "the electronics") + " to " + formatForPeople(targetC) +
                 " °C");
  }
  if (set && (chamber != nullptr || targetC != m_course.plan().referenceTemperatureC)) {
    set = wait(m_course.plan().temperatureSettleS);
  }
  if (set) {
    at = targetC;
  }
  return set;
}

CaptureLoop::Step<void> FieldWorker::askFor(const std::string& instruction) {
  if (auto committed = commit(); !committed) {
    return committed;
  }
  publishProgress();
  std::unique_lock lock(m_shared.mutex);
  m_shared.waitingFor = instruction;
  m_shared.confirmed = false;
  m_shared.changed.notify_all();
  m_shared.changed.wait(lock, stopToken(),
                        [this] { return m_shared.confirmed || m_shared.pauseRequested || requestsWait(); });
  m_shared.waitingFor.clear();
  if (std::exchange(m_shared.confirmed, false)) {
    return {};
  }
  const bool asked = requestsWait() && !m_shared.pauseRequested;
  Interruption why;
  why.lookAgain = asked && !stopToken().stop_requested();
  return std::unexpected(std::move(why));
}

CaptureLoop::Step<void> FieldWorker::measurePlateau(FieldTask task) {
  const FieldStage& stage = m_course.stage(task.stage);
  const double fieldT = m_course.point(task).fieldT;
  double unlockedS = 0.0;
  tell(FieldAction::WaitingForLock, fieldT);
  while (m_course.rowsTaken(task) < stage.rows) {
    const auto locked = takeRow(task);
    if (!locked) {
      return std::unexpected(locked.error());
    }
    if (*locked) {
      m_course.rowTaken(task);
      tellRows(task);
      unlockedS = 0.0;
    } else {
      unlockedS += stage.rowS;
    }
    tell(*locked ? FieldAction::TakingRows : FieldAction::WaitingForLock, fieldT);
    if (unlockedS >= m_course.plan().lockTimeoutS) {
      m_course.giveUp(task);
      ++m_givenUp[static_cast<std::size_t>(task.stage)];
      break;
    }
    if (m_course.rowsTaken(task) < stage.rows) {
      if (auto waited = wait(stage.rowS); !waited) {
        return waited;
      }
    }
  }
  if (m_course.pointsDone(task.stage) == m_course.pointsPlanned(task.stage) && !m_course.everLocked(task.stage)) {
    return std::unexpected(Interruption{
        .fault = Error{ErrorKind::Instrument, "the reference never locked in stage '" + stageTitle(stage) + "'",
                       "see to its probe and range, then measure the stage again; resuming leaves it as it is",
                       "reference"}});
  }
  return {};
}

CaptureLoop::Step<void> FieldWorker::measureSweep(FieldTask task) {
  const FieldStage& stage = m_course.stage(task.stage);
  const bool ofProbe = isProbeSweep(stage);
  TemperatureChamber* chamber = ofProbe ? m_bench.probeChamber : m_bench.electronicsChamber;
  if (chamber == nullptr) {
    if (auto begun = askFor("begin to sweep " + std::string(ofProbe ? "the probe" : "the electronics") + " from " +
                            formatForPeople(stage.lowC) + " to " + formatForPeople(stage.highC) + " °C and back, " +
                            (stage.cycles == 1 ? "once" : std::to_string(stage.cycles) + " times"));
        !begun) {
      return begun;
    }
  }
  std::optional<double>& at = ofProbe ? m_probeC : m_electronicsC;
  at.reset(); // on its way from here on
  while (m_course.rowsTaken(task) < stage.rows) {
    if (chamber != nullptr) {
      const double targetC = sweepC(stage, m_course.rowsTaken(task));
      tell(ofProbe ? FieldAction::SweepingProbe : FieldAction::SweepingElectronics, targetC);
      if (auto sent = fromInstrument(chamber->setC(targetC), "chamber"); !sent) {
        return sent;
      }
    }
    if (auto waited = wait(stage.rowS); !waited) {
      return waited;
    }
    if (const auto taken = takeRow(task); !taken) {
      return std::unexpected(taken.error());
    }
    m_course.rowTaken(task);
    tellRows(task);
  }
  return {};
}

CaptureLoop::Step<bool> FieldWorker::takeRow(FieldTask task) {
  const FieldStage& stage = m_course.stage(task.stage);
  session::FieldSample sample;
  sample.stage = task.stage;
  sample.point = task.point;
  sample.attempt = m_course.attempt(task.stage);
  sample.step = static_cast<int>(stage.step);
  sample.axis = stage.axis ? std::optional(static_cast<int>(*stage.axis)) : std::nullopt;
  sample.orientation = stage.orientation ? std::optional(static_cast<int>(*stage.orientation)) : std::nullopt;
  if (needsReference(stage)) {
    const auto reference = fromInstrument(m_bench.reference->readT(), "reference");
    if (!reference) {
      return std::unexpected(reference.error());
    }
    sample.locked = reference->locked && reference->fieldT && std::isfinite(*reference->fieldT);
    if (sample.locked) {
      const double fieldT = m_bench.reference->knowsSign()
                                ? *reference->fieldT
                                : std::copysign(*reference->fieldT, m_course.point(task).fieldT);
      sample.referenceT = packageSign(stage) * fieldT;
    }
  }
  const auto reading = fromInstrument(m_bench.probe->readT(), "teslameter");
  if (!reading) {
    return std::unexpected(reading.error());
  }
  if (reading->overRange ||
      !std::all_of(reading->rawT.begin(), reading->rawT.end(), [](double value) { return std::isfinite(value); })) {
    return std::unexpected(
        Interruption{.fault = noReading(reading->overRange ? "the field is beyond the teslameter's range"
                                                           : "a reading of the teslameter is no number",
                                        "teslameter")});
  }
  sample.rawT = reading->rawT;
  sample.timeS = sampleTimeS(reading->timeS);
  if (auto filled = fillTemperatures(*reading, stage.step == field::CampaignStep::ProbeTemperature, sample); !filled) {
    return std::unexpected(filled.error());
  }
  const bool locked = sample.locked || !needsReference(stage);
  m_course.noteRow(task.stage, locked);
  if (auto stored = store(sample); !stored) {
    return std::unexpected(stored.error());
  }
  return locked;
}

CaptureLoop::Step<void> FieldWorker::fillTemperatures(const FieldReading& reading, bool withChamber,
                                                      session::FieldSample& sample) {
  if (m_bench.pt100 != nullptr) {
    const auto ohm = fromInstrument(m_bench.pt100->readOhm(), "PT100");
    if (!ohm) {
      return std::unexpected(ohm.error());
    }
    if (!(ohm->value > 0.0) || !std::isfinite(ohm->value)) {
      return std::unexpected(Interruption{.fault = noReading("the PT100's resistance is no positive number", "PT100")});
    }
    sample.pt100Ohm = ohm->value;
  }
  sample.electronicsC = reading.electronicsC;
  if (m_bench.electronics != nullptr) {
    const auto electronics = fromInstrument(m_bench.electronics->readC(), "electronics thermometer");
    if (!electronics) {
      return std::unexpected(electronics.error());
    }
    sample.electronicsC = electronics->value;
  }
  if (withChamber && (m_bench.probeChamber != nullptr || m_bench.chamber != nullptr)) {
    const auto chamber = fromInstrument(
        m_bench.probeChamber != nullptr ? m_bench.probeChamber->readC() : m_bench.chamber->readC(), "chamber");
    if (!chamber) {
      return std::unexpected(chamber.error());
    }
    sample.chamberC = chamber->value;
  }
  return {};
}

CaptureLoop::Step<void> FieldWorker::store(session::FieldSample sample) {
  sample.sequence = m_course.nextSequence++;
  const std::vector<session::FieldSample> rows(1, sample);
  if (auto appended = fromSink(m_sink.append(rows)); !appended) {
    return appended;
  }
  samplesAppended();
  ++m_samples;
  m_shared.queue.push(rows);
  return commitIfDue();
}

void FieldWorker::fillProgress(CaptureProgress& progress) {
  progress.pointsDone = m_course.done();
  progress.pointsPlanned = m_course.planned();
  progress.samples = m_samples;
  progress.samplesLost = m_shared.queue.lost();
  progress.remainingS = m_course.remainingS();
  m_shared.stages.resize(static_cast<std::size_t>(m_course.stages()));
  for (int i = 0; i < m_course.stages(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    m_shared.stages[at] = {.pointsDone = m_course.pointsDone(i),
                           .pointsPlanned = m_course.pointsPlanned(i),
                           .attempt = m_course.attempt(i),
                           .skipped = m_course.skipped(i),
                           .pointsGivenUp = m_givenUp[at]};
  }
}

} // namespace straightedge::devices
