// Whole campaigns of the simulated teslameter at once, without a capture thread: for tests that want thousands of them.
#pragma once

#include "core/field/campaign.h"
#include "devices/simulated/hall_probe.h"

#include <cstdint>
#include <vector>

namespace straightedge::devices {

/// A sweep of temperature at one field: rows over one or several cycles between two temperatures.
struct HallSweep {
  double lowC = 17.0;
  double highC = 31.0;
  int cycles = 1;
  int rows = 240; ///< per field
};

/// Defaults give a campaign shaped like the paper's, of about 13,000 rows. A stage without fields or rows is left out.
struct HallCampaignSettings {
  HallProbeSettings probe;
  std::uint64_t seed = 1;
  bool withTime = true; ///< fill time_s
  double rowS = 1.0;    ///< between rows
  double lagS = 12.0;   ///< first-order lag of the probe behind chamber or Peltier element; 0 = none

  double lockThresholdT = 0.043;  ///< the NMR does not lock on less
  double referenceNoisePpm = 1.5; ///< of the reading; with a floor of 0.3 µT
  double referenceScalePpm = 0.0; ///< common to all readings: what a certificate's uncertainty is about
  double poleDriftPpmPerC = -2.8; ///< of the magnet's field while the probe is swept: its poles warm up too

  std::vector<double> nonlinearityFieldsT; ///< default: the whole scale in steps of 50 mT
  int nonlinearityRows = 9;                ///< locked rows of a plateau, at least; up to 3 more at random
  HallSweep probeTemperature = {.lowC = 14.0, .highC = 34.0, .cycles = 2, .rows = 800};
  HallSweep offset = {.lowC = 19.0, .highC = 37.0, .cycles = 1, .rows = 500};
  std::vector<double> sensitivityFieldsT = {0.3, -0.3, 1.0, -1.0, 1.6, -1.6};
  HallSweep sensitivity;
  HallSweep electronics = {.lowC = 17.0, .highC = 34.0, .cycles = 1, .rows = 400};
  std::vector<double> electronicsFieldsT = {-1.6, -0.3, 0.3, 1.6};
  HallSweep electronicsSensitivity = {.lowC = 17.0, .highC = 34.0, .cycles = 1, .rows = 160};
  std::vector<double> orientationFieldsT = {0.5, 1.0, 1.5};
  int orientationRows = 30;                ///< per field
  std::vector<double> verificationFieldsT; ///< default: the whole scale in steps of 200 mT
  std::vector<double> verificationC = {18.0, 21.0, 24.0, 27.0, 31.0};
  int verificationRows = 6; ///< per field and temperature

  HallCampaignSettings();
};

/// The same settings give the same campaign. In the row of an axis the field lies along that axis of the package.
/// Rows are in the order of field::CampaignStep, numbered as the lines of a CSV file would be.
field::Campaign makeHallCampaign(const HallCampaignSettings& settings);

/// Settings with every parameter of the probe varied by its `seed`: gains, curvature, offsets, sensitivities over both
/// temperatures, tilts to about 1°, noise, PT100, lag. The shape of the campaign stays.
HallCampaignSettings variedHallCampaign(std::uint64_t seed);

/// The same with few rows a stage (about 1,500): a hundred and more of them a second.
HallCampaignSettings quickHallCampaign(std::uint64_t seed);

} // namespace straightedge::devices
