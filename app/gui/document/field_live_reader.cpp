#include "app/gui/document/field_live_reader.h"

#include <chrono>
#include <utility>

namespace straightedge::gui {

namespace {

constexpr std::chrono::milliseconds fieldReadingPeriod{100};
constexpr std::chrono::milliseconds fieldFailingPeriod{1000};

/// A role that nothing fills says nothing; a fault of one does not keep the others from being read.
template <typename Role, typename Read>
void askRole(Role* role, Result<void>& outcome, const Read& read) {
  if (role == nullptr) {
    return;
  }
  if (Result<void> said = read(*role); !said && outcome) {
    outcome = std::move(said);
  }
}

template <typename Reading>
Result<void> keepValue(Result<Reading> reading, std::optional<double>& value) {
  if (!reading) {
    return std::unexpected(std::move(reading.error()));
  }
  value = reading->value;
  return {};
}

} // namespace

FieldLiveReader::FieldLiveReader(devices::FieldBench bench, QObject* parent)
    : QObject(parent), m_bench(std::move(bench)), m_thread([this](const std::stop_token& stop) { run(stop); }) {}

FieldLiveReader::~FieldLiveReader() = default;

void FieldLiveReader::setFieldT(double fieldT) {
  {
    const std::scoped_lock lock(m_mutex);
    m_fieldT = fieldT;
  }
  m_wake.notify_one();
}

void FieldLiveReader::placeProbe(devices::ProbePlacement placing) {
  {
    const std::scoped_lock lock(m_mutex);
    m_placing = placing;
  }
  m_wake.notify_one();
}

Result<void> FieldLiveReader::carryOut() {
  std::optional<double> fieldT;
  std::optional<devices::ProbePlacement> placing;
  {
    const std::scoped_lock lock(m_mutex);
    fieldT = std::exchange(m_fieldT, std::nullopt);
    placing = std::exchange(m_placing, std::nullopt);
  }
  if (placing && m_bench.carrier != nullptr) {
    if (Result<void> placed = m_bench.carrier->place(*placing); !placed) {
      return placed;
    }
  }
  return fieldT && m_bench.magnet != nullptr ? m_bench.magnet->setFieldT(*fieldT) : Result<void>();
}

Result<void> FieldLiveReader::readBeside(FieldLiveReading& reading) {
  Result<void> outcome;
  askRole(m_bench.reference, outcome, [&reading](devices::FieldReference& reference) -> Result<void> {
    const Result<devices::FieldReferenceReading> said = reference.readT();
    if (!said) {
      return std::unexpected(said.error());
    }
    reading.locked = said->locked && said->fieldT.has_value();
    reading.referenceT = reading.locked ? said->fieldT : std::nullopt;
    return {};
  });
  askRole(m_bench.pt100, outcome, [&](auto& meter) { return keepValue(meter.readOhm(), reading.pt100Ohm); });
  askRole(m_bench.electronics, outcome, [&](auto& meter) { return keepValue(meter.readC(), reading.electronicsC); });
  askRole(m_bench.probeChamber, outcome, [&](auto& meter) { return keepValue(meter.readC(), reading.probeChamberC); });
  askRole(m_bench.electronicsChamber, outcome,
          [&](auto& meter) { return keepValue(meter.readC(), reading.electronicsChamberC); });
  return outcome;
}

Result<void> FieldLiveReader::readOnce() {
  if (Result<void> done = carryOut(); !done) {
    return done;
  }
  const Result<devices::FieldReading> probe = m_bench.probe->readT();
  if (!probe) {
    return std::unexpected(probe.error());
  }
  FieldLiveReading now;
  now.rawT = probe->rawT;
  now.overRange = probe->overRange;
  now.electronicsC = probe->electronicsC;
  Result<void> outcome = readBeside(now);
  emit reading(now);
  return outcome;
}

void FieldLiveReader::run(const std::stop_token& stop) {
  bool failing = false;
  while (!stop.stop_requested()) {
    const double beforeS = m_bench.clock->nowS();
    const Result<void> read = readOnce();
    if (!read && !failing) {
      emit failed(QString::fromStdString(read.error().message()));
    }
    failing = !read;
    const auto period = failing ? fieldFailingPeriod : fieldReadingPeriod;
    {
      std::unique_lock lock(m_mutex);
      m_wake.wait_for(lock, stop, period, [this] { return m_fieldT || m_placing; });
    }
    // On a virtual clock no time has passed, and a magnet would never reach its field.
    const double periodS = std::chrono::duration<double>(period).count();
    if (!stop.stop_requested() && m_bench.clock->nowS() - beforeS < 0.5 * periodS) {
      m_bench.clock->sleepS(periodS);
    }
  }
}

} // namespace straightedge::gui
