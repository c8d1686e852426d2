#include "devices/bench/bench_stream.h"

#include <utility>

namespace straightedge::devices {

std::unique_ptr<BenchStream> BenchStream::make(BenchSeat* reference, BenchSeat* sensor, const BenchClock& clock) {
  if (reference == nullptr || sensor == nullptr) {
    return nullptr;
  }
  const bool oneLine = reference == sensor && reference->angleStream() != nullptr;
  const bool two = reference != sensor && reference->angleReadings(InstrumentRole::AngleReference) != nullptr &&
                   sensor->angleReadings(InstrumentRole::AngleSensor) != nullptr;
  if (!oneLine && !two) {
    return nullptr;
  }
  return std::unique_ptr<BenchStream>(new BenchStream(*reference, *sensor, clock, oneLine));
}

Result<void> BenchStream::start(const StreamRequest& request) {
  m_pairing = ReadingPairing({PairingKind::Interpolate, request.pairing.maxAgeS});
  m_unpairedBefore = 0;
  m_fault.reset();
  m_reference.seat->forgetFault(); // of a try before this one
  m_sensor.seat->forgetFault();
  if (m_oneLine) {
    AngleStream* stream = m_reference.seat->angleStream();
    if (stream == nullptr) {
      return m_reference.seat->absent();
    }
    if (auto started = stream->start(request); !started) {
      return m_reference.seat->streamFault(std::move(started.error()));
    }
    m_reference.heardS = m_clock.nowS();
    return {};
  }
  for (Source* source : {&m_sensor, &m_reference}) { // the sensor first: its readings are to lie around the encoder's
    ReadingStream* stream = source->seat->angleReadings(source->role);
    if (stream == nullptr) {
      return source->seat->absent();
    }
    if (auto started = stream->start(); !started) {
      return source->seat->streamFault(std::move(started.error()));
    }
    source->heardS = m_clock.nowS();
  }
  return {};
}

Result<void> BenchStream::checkSilence(Source& source, bool heard) {
  const double nowS = m_clock.nowS();
  if (heard) {
    source.heardS = nowS;
  }
  return nowS - source.heardS > longestSilenceS ? source.seat->silent(longestSilenceS) : Result<void>{};
}

Result<StreamBlock> BenchStream::readOneLine() {
  AngleStream* stream = m_reference.seat->angleStream();
  if (stream == nullptr) {
    return m_reference.seat->absent();
  }
  auto block = stream->read();
  if (!block) {
    return m_reference.seat->streamFault(std::move(block.error()));
  }
  if (auto well = checkSilence(m_reference, !block->samples.empty()); !well) {
    return std::unexpected(std::move(well.error()));
  }
  for (StreamedAngle& sample : block->samples) {
    sample.timeS -= m_reference.seat->wanted().latencyS;
  }
  return block;
}

Result<ReadingBlock> BenchStream::readSource(Source& source) {
  ReadingStream* stream = source.seat->angleReadings(source.role);
  if (stream == nullptr) {
    return source.seat->absent();
  }
  auto block = stream->read();
  if (!block) {
    return source.seat->streamFault(std::move(block.error()));
  }
  if (auto well = checkSilence(source, !block->readings.empty()); !well) {
    return std::unexpected(std::move(well.error()));
  }
  for (TimedReading& reading : block->readings) {
    reading.timeS -= source.seat->wanted().latencyS;
  }
  return block;
}

Result<StreamBlock> BenchStream::read() {
  if (auto fault = std::exchange(m_fault, std::nullopt)) {
    return std::unexpected(*std::move(fault));
  }
  if (m_oneLine) {
    return readOneLine();
  }
  StreamBlock block;
  auto references = readSource(m_reference);
  if (references) {
    for (const TimedReading& reading : references->readings) {
      m_pairing.addReference(reading);
    }
    block.lost = references->lost;
    block.rejected = references->rejected;
  }
  auto sensors = readSource(m_sensor);
  if (sensors) {
    for (const TimedReading& reading : sensors->readings) {
      m_pairing.addSensor(reading);
    }
  }
  block.samples = m_pairing.takePairs();
  block.unpaired = m_pairing.rejected() - std::exchange(m_unpairedBefore, m_pairing.rejected());
  if (references && sensors) {
    return block;
  }
  Error fault = std::move(!references ? references.error() : sensors.error());
  if (block.samples.empty()) {
    return std::unexpected(std::move(fault));
  }
  m_fault = std::move(fault);
  return block;
}

Result<void> BenchStream::stop() {
  Result<void> outcome;
  const auto stopOne = [&outcome](BenchSeat& seat, auto* stream) {
    if (stream == nullptr) {
      return; // unplugged: it streams no more
    }
    if (auto stopped = stream->stop(); !stopped && outcome) {
      outcome = seat.streamFault(std::move(stopped.error()));
    }
  };
  if (m_oneLine) {
    stopOne(*m_reference.seat, m_reference.seat->angleStream());
  } else {
    stopOne(*m_reference.seat, m_reference.seat->angleReadings(m_reference.role));
    stopOne(*m_sensor.seat, m_sensor.seat->angleReadings(m_sensor.role));
  }
  return outcome;
}

} // namespace straightedge::devices
