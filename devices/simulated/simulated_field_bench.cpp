#include "devices/simulated/simulated_field_bench.h"

#include "devices/simulated/hall_world.h"

namespace straightedge::devices {

namespace {

class SimulatedTeslameter : public FieldProbe {
public:
  explicit SimulatedTeslameter(HallWorld& world) : m_world(world) {}
  InstrumentIdentity identity() const override { return {"Simulated Hall teslameter", "SIM-H", STRAIGHTEDGE_VERSION}; }
  Result<FieldReading> readT() override { return m_world.readProbe(); }
  bool measuresElectronics() const override { return true; }

private:
  HallWorld& m_world;
};

class SimulatedNmr : public FieldReference {
public:
  explicit SimulatedNmr(HallWorld& world) : m_world(world) {}
  InstrumentIdentity identity() const override { return {"Simulated NMR teslameter", "SIM-N", STRAIGHTEDGE_VERSION}; }
  Result<FieldReferenceReading> readT() override { return m_world.readReference(); }

private:
  HallWorld& m_world;
};

class SimulatedPt100 : public ResistanceMeter {
public:
  explicit SimulatedPt100(HallWorld& world) : m_world(world) {}
  InstrumentIdentity identity() const override { return {"Simulated ohmmeter", "SIM-O", STRAIGHTEDGE_VERSION}; }
  Result<TimedReading> readOhm() override {
    const double ohm = m_world.pt100Ohm();
    return TimedReading{ohm, m_world.clock().nowS()};
  }

private:
  HallWorld& m_world;
};

class SimulatedMagnet : public FieldMagnet {
public:
  explicit SimulatedMagnet(HallWorld& world) : m_world(world) {}
  InstrumentIdentity identity() const override { return {"Simulated electromagnet", "SIM-M", STRAIGHTEDGE_VERSION}; }
  Result<void> setFieldT(double fieldT) override {
    m_world.setFieldT(fieldT);
    return {};
  }

private:
  HallWorld& m_world;
};

class SimulatedCarrier : public ProbeCarrier {
public:
  explicit SimulatedCarrier(HallWorld& world) : m_world(world) {}
  Result<void> place(ProbePlacement placement) override {
    m_world.place(placement);
    return {};
  }

private:
  HallWorld& m_world;
};

class SimulatedProbeChamber : public TemperatureChamber {
public:
  explicit SimulatedProbeChamber(HallWorld& world) : m_world(world) {}
  InstrumentIdentity identity() const override { return {"Simulated probe chamber", "SIM-C", STRAIGHTEDGE_VERSION}; }
  Result<void> setC(double temperatureC) override {
    m_world.setProbeChamberC(temperatureC);
    return {};
  }
  Result<TimedReading> readC() override { return TimedReading{m_world.probeChamberC(), m_world.clock().nowS()}; }

private:
  HallWorld& m_world;
};

class SimulatedElectronicsChamber : public TemperatureChamber {
public:
  explicit SimulatedElectronicsChamber(HallWorld& world) : m_world(world) {}
  InstrumentIdentity identity() const override { return {"Simulated climate chamber", "SIM-E", STRAIGHTEDGE_VERSION}; }
  Result<void> setC(double temperatureC) override {
    m_world.setElectronicsChamberC(temperatureC);
    return {};
  }
  Result<TimedReading> readC() override { return TimedReading{m_world.electronicsChamberC(), m_world.clock().nowS()}; }

private:
  HallWorld& m_world;
};

} // namespace

struct SimulatedFieldBench::Impl {
  explicit Impl(const SimulatedFieldSettings& given)
      : settings(given), world(given), teslameter(world), nmr(world), pt100(world), magnet(world), carrier(world),
        probeChamber(world), electronicsChamber(world) {}

  SimulatedFieldSettings settings;
  HallWorld world;
  SimulatedTeslameter teslameter;
  SimulatedNmr nmr;
  SimulatedPt100 pt100;
  SimulatedMagnet magnet;
  SimulatedCarrier carrier;
  SimulatedProbeChamber probeChamber;
  SimulatedElectronicsChamber electronicsChamber;
};

SimulatedFieldBench::SimulatedFieldBench(const SimulatedFieldSettings& settings)
    : m_impl(std::make_unique<Impl>(settings)) {}

SimulatedFieldBench::~SimulatedFieldBench() = default;

FieldBench SimulatedFieldBench::bench() {
  return {.name = "Simulated bench",
          .probe = &m_impl->teslameter,
          .reference = &m_impl->nmr,
          .pt100 = &m_impl->pt100,
          .electronics = nullptr, // the teslameter measures its own
          .magnet = &m_impl->magnet,
          .carrier = m_impl->settings.byHand ? nullptr : &m_impl->carrier,
          .probeChamber = &m_impl->probeChamber,
          .electronicsChamber = &m_impl->electronicsChamber,
          .clock = &m_impl->world.clock()};
}

const SimulatedFieldSettings& SimulatedFieldBench::settings() const { return m_impl->settings; }
void SimulatedFieldBench::placeByHand(ProbePlacement placement) { m_impl->world.place(placement); }
const HallProbe& SimulatedFieldBench::truth() const { return m_impl->world.probe(); }

} // namespace straightedge::devices
