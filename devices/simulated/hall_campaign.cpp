#include "devices/simulated/hall_campaign.h"

#include "devices/simulated/quantised.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace straightedge::devices {

namespace {

using field::Axis;
using field::CampaignRow;
using field::CampaignStep;
using field::Orientation;

constexpr double referenceFloorT = 0.3e-6;

std::vector<double> wholeScale(double fullScaleT, double stepT) {
  std::vector<double> fields;
  const int steps = static_cast<int>(std::lround(fullScaleT / stepT));
  for (int i = -steps; i <= steps; ++i) {
    fields.push_back(fullScaleT * i / steps);
  }
  return fields;
}

Eigen::Vector3d along(Axis axis) { return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis)); }

/// Up and down again, smoothly: where a chamber is sent that must not overshoot.
double chamberC(const HallSweep& sweep, int row) {
  const double turn = 2.0 * std::numbers::pi * sweep.cycles * row / sweep.rows;
  return sweep.lowC + (sweep.highC - sweep.lowC) * 0.5 * (1.0 - std::cos(turn));
}

/// First-order lag behind a chamber that moves straight from row to row, started in the state that repeats with every
/// cycle. A chamber that stood still between rows would lead the one that is recorded by half a row, which a fit of the
/// lag takes for a longer lag and a steeper PT100.
class LaggingProbe {
public:
  LaggingProbe(const HallSweep& sweep, double lagS, double rowS)
      : m_lagRows(lagS / rowS), m_chamberC(sweep.lowC), m_probeC(sweep.lowC) {
    const int rowsOfCycle = sweep.rows / std::max(1, sweep.cycles);
    for (int row = 0; row < settlingCycles * rowsOfCycle; ++row) {
      next(chamberC(sweep, row));
    }
  }
  double next(double chamber) {
    if (m_lagRows > 0.0) {
      const double rate = chamber - m_chamberC; // of a row
      m_probeC = chamber - m_lagRows * rate + (m_probeC - m_chamberC + m_lagRows * rate) * std::exp(-1.0 / m_lagRows);
    } else {
      m_probeC = chamber;
    }
    m_chamberC = chamber;
    return m_probeC;
  }

private:
  static constexpr int settlingCycles = 3;
  double m_lagRows;
  double m_chamberC;
  double m_probeC;
};

class CampaignMaker {
public:
  explicit CampaignMaker(const HallCampaignSettings& settings)
      : m_settings(settings), m_probe(settings.probe), m_noise(settings.seed) {}

  field::Campaign make() {
    nonlinearity();
    temperatureSweep(CampaignStep::ProbeTemperature, m_settings.probeTemperature);
    temperatureSweep(CampaignStep::Offset, m_settings.offset);
    for (const Axis axis : field::allAxes) {
      for (const double fieldT : m_settings.sensitivityFieldsT) {
        sensitivity(axis, fieldT);
      }
    }
    electronicsSweep(CampaignStep::Electronics, std::nullopt, 0.0, m_settings.electronics);
    for (const Axis axis : field::allAxes) {
      for (const double fieldT : m_settings.electronicsFieldsT) {
        electronicsSweep(CampaignStep::ElectronicsSensitivity, axis, fieldT, m_settings.electronicsSensitivity);
      }
    }
    orientations();
    verification();
    return std::move(m_campaign);
  }

private:
  double referenceC() const { return m_settings.probe.referenceTemperatureC; }

  CampaignRow& add(CampaignStep step, const Eigen::Vector3d& fieldT, double probeC, double electronicsC) {
    CampaignRow& row = m_campaign.rows.emplace_back();
    row.step = step;
    row.locked = true;
    row.pt100Ohm = m_probe.pt100Ohm(probeC, m_noise);
    row.electronicsC = m_probe.electronicsReadingC(electronicsC, m_noise);
    const Eigen::Vector3d raw = m_probe.readingT(fieldT, probeC, electronicsC, m_noise);
    row.rawT = {raw.x(), raw.y(), raw.z()};
    row.timeS = m_settings.withTime ? m_timeS : field::emptyCell;
    row.line = static_cast<std::int64_t>(m_campaign.rows.size()) + 1;
    m_timeS += m_settings.rowS;
    return row;
  }

  void addReference(CampaignRow& row, double fieldT) {
    row.locked = std::abs(fieldT) >= m_settings.lockThresholdT;
    if (row.locked) {
      const double sigma = std::max(referenceFloorT, 1e-6 * m_settings.referenceNoisePpm * std::abs(fieldT));
      const double shown = fieldT * (1.0 + 1e-6 * m_settings.referenceScalePpm) + sigma * m_noise.standardNormal();
      row.referenceT = quantised(shown, referenceStepT);
    }
  }

  int extraRows() { return std::clamp(static_cast<int>(1.5 + m_noise.standardNormal()), 0, 3); }

  void nonlinearity() {
    for (const Axis axis : field::allAxes) {
      for (const double fieldT : m_settings.nonlinearityFieldsT) {
        const int locked = m_settings.nonlinearityRows + extraRows();
        const int unlocked = extraRows() / 2; // until the NMR has found the field
        for (int i = -unlocked; i < locked; ++i) {
          CampaignRow& row = add(CampaignStep::Nonlinearity, fieldT * along(axis), referenceC(), referenceC());
          row.axis = axis;
          row.locked = false;
          if (i >= 0) {
            addReference(row, fieldT);
          }
        }
      }
    }
  }

  void temperatureSweep(CampaignStep step, const HallSweep& sweep) {
    LaggingProbe probe(sweep, m_settings.lagS, m_settings.rowS);
    for (int i = 0; i < sweep.rows; ++i) {
      const double chamber = chamberC(sweep, i);
      CampaignRow& row = add(step, Eigen::Vector3d::Zero(), probe.next(chamber), referenceC());
      row.locked = false; // there is no NMR in the zero-field chamber
      if (step == CampaignStep::ProbeTemperature) {
        row.chamberC = quantised(chamber, chamberStepC);
      }
    }
  }

  void sensitivity(Axis axis, double fieldT) {
    LaggingProbe probe(m_settings.sensitivity, m_settings.lagS, m_settings.rowS);
    for (int i = 0; i < m_settings.sensitivity.rows; ++i) {
      const double probeC = probe.next(chamberC(m_settings.sensitivity, i));
      const double drifted = fieldT * (1.0 + 1e-6 * m_settings.poleDriftPpmPerC * (probeC - referenceC()));
      CampaignRow& row = add(CampaignStep::Sensitivity, drifted * along(axis), probeC, referenceC());
      row.axis = axis;
      addReference(row, drifted);
    }
  }

  void electronicsSweep(CampaignStep step, std::optional<Axis> axis, double fieldT, const HallSweep& sweep) {
    for (int i = 0; i < sweep.rows; ++i) {
      const Eigen::Vector3d vector = axis ? Eigen::Vector3d(fieldT * along(*axis)) : Eigen::Vector3d::Zero();
      CampaignRow& row = add(step, vector, referenceC(), chamberC(sweep, i));
      row.axis = axis;
      row.locked = false;
      if (axis) {
        addReference(row, fieldT);
      }
    }
  }

  void orientations() {
    for (int o = 0; o < 6; ++o) {
      const auto axis = static_cast<Axis>(o / 2);
      const double sign = o % 2 == 0 ? 1.0 : -1.0;
      for (const double fieldT : m_settings.orientationFieldsT) {
        for (int i = 0; i < m_settings.orientationRows; ++i) {
          CampaignRow& row = add(CampaignStep::Orientation, sign * fieldT * along(axis), referenceC(), referenceC());
          row.orientation = static_cast<Orientation>(o);
          addReference(row, sign * fieldT);
        }
      }
    }
  }

  void verification() {
    for (const Axis axis : field::allAxes) {
      for (const double probeC : m_settings.verificationC) {
        for (const double fieldT : m_settings.verificationFieldsT) {
          // The electronics stand in the room, and that warms up and cools down again over the day.
          const double electronicsC = referenceC() + 1.0 + 6.0 * std::sin(m_timeS * 1e-3);
          for (int i = 0; i < m_settings.verificationRows; ++i) {
            CampaignRow& row = add(CampaignStep::Verification, fieldT * along(axis), probeC, electronicsC);
            row.axis = axis;
            addReference(row, fieldT);
          }
        }
      }
    }
  }

  const HallCampaignSettings& m_settings;
  HallProbe m_probe;
  NoiseSource m_noise;
  double m_timeS = 0.0;
  field::Campaign m_campaign;
};

} // namespace

HallCampaignSettings::HallCampaignSettings()
    : nonlinearityFieldsT(wholeScale(probe.fullScaleT, 0.05)), verificationFieldsT(wholeScale(probe.fullScaleT, 0.2)) {}

field::Campaign makeHallCampaign(const HallCampaignSettings& settings) {
  field::Campaign campaign = CampaignMaker(settings).make();
  campaign.name = "simulated campaign, seed " + std::to_string(settings.seed);
  return campaign;
}

HallCampaignSettings variedHallCampaign(std::uint64_t seed) {
  HallCampaignSettings settings;
  settings.seed = seed;
  NoiseSource random(seed ^ 0x5EEDF1E1DULL); // not the noise of the readings
  const auto spread = [&random](double sigma) { return sigma * std::clamp(random.standardNormal(), -2.5, 2.5); };
  HallProbeSettings& probe = settings.probe;
  for (HallAxis& axis : probe.axes) {
    axis.rawOverFieldT = {spread(100e-6), 0.953 + spread(0.02),  spread(2e-4), 0.0107 + spread(0.002),
                          spread(2e-5),   6.9e-4 + spread(1e-4), 0.0,          2.1e-4 + spread(2e-5)};
    axis.offsetT = {spread(60e-6), spread(20e-6)};
    axis.sensitivitySlope = {spread(5e-7), -1.5e-4 + spread(4e-5), spread(3e-7), spread(8e-7)};
    axis.sensitivityIntercept = {spread(10e-6), spread(2e-5)};
    axis.electronicsT = {spread(10e-6), spread(8e-6)};
    axis.electronicsSensitivity = {spread(1e-7), spread(2e-5)};
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      probe.axisMatrix(i, j) = (i == j ? 1.0 : 0.0) + spread(i == j ? 0.002 : 0.009); // 0.5° one sigma
    }
  }
  probe.noiseT = 5e-6 * std::exp(spread(0.4));
  probe.pt100OhmAt0C = 100.0 + spread(0.1);
  probe.pt100OhmPerC = 0.3851 + spread(0.0005);
  probe.pt100NoiseOhm = 0.007 * std::exp(spread(0.3));
  probe.electronicsNoiseC = 0.05 * std::exp(spread(0.2));
  settings.lagS = 12.0 * std::exp(spread(0.3));
  settings.referenceNoisePpm = 1.5 * std::exp(spread(0.3));
  settings.referenceScalePpm = spread(2.0);
  settings.poleDriftPpmPerC = -2.8 + spread(1.0);
  return settings;
}

HallCampaignSettings quickHallCampaign(std::uint64_t seed) {
  HallCampaignSettings settings = variedHallCampaign(seed);
  settings.nonlinearityFieldsT = wholeScale(settings.probe.fullScaleT, 0.2);
  settings.nonlinearityRows = 6;
  settings.probeTemperature.rows = 100;
  settings.offset.rows = 60;
  settings.sensitivity.rows = 30;
  settings.electronics.rows = 60;
  settings.electronicsSensitivity.rows = 30;
  settings.orientationRows = 4;
  settings.verificationFieldsT = wholeScale(settings.probe.fullScaleT, 1.0);
  settings.verificationRows = 3;
  settings.verificationC = {18.0, 24.0, 31.0};
  // Fewer rows of the same cycles: what lasts a row lasts longer.
  settings.rowS = 8.0;
  return settings;
}

} // namespace straightedge::devices
