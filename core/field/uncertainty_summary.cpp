#include "core/field/uncertainty_summary.h"

#include "core/field/field_fit.h"
#include "core/field/uncertainty.h"
#include "core/numerics/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace straightedge::field {

namespace {

constexpr int stepsEachWay = 8; ///< of the field, to full scale

struct Temperatures {
  double probeC;
  double electronicsC;
};

std::vector<Temperatures> temperaturesOf(const FieldUncertainty& uncertainty) {
  const double reference = uncertainty.chain().referenceTemperatureC;
  const TemperatureRange& range = uncertainty.range();
  std::vector<Temperatures> all = {{reference, reference}};
  for (const double probe : {range.probeLowC, range.probeHighC}) {
    if (probe != 0.0) {
      all.push_back({reference + probe, reference});
    }
  }
  for (const double electronics : {range.electronicsLowC, range.electronicsHighC}) {
    if (electronics != 0.0) {
      all.push_back({reference, reference + electronics});
    }
  }
  return all;
}

struct Share {
  const char* name;
  Eigen::Vector3d ReadingUncertainty::* of;
  const char* basis;
};

constexpr std::array<Share, 7> allShares = {{
    {"residual of the chain", &ReadingUncertainty::residualT, "known: chain less closest fit to the campaign"},
    {"repeatability", &ReadingUncertainty::repeatabilityT, "scatter of single raw readings on the plateaus; normal"},
    {"probe temperature", &ReadingUncertainty::probeTemperatureT, "scatter and step of the PT100 reading; normal"},
    {"electronics temperature", &ReadingUncertainty::electronicsTemperatureT,
     "scatter and step of the electronics' sensor; normal"},
    {"coefficients", &ReadingUncertainty::coefficientsT, "covariance of the closest fit; normal"},
    {"model", &ReadingUncertainty::modelT, "what the closest fit leaves beyond noise; normal"},
    {"reference", &ReadingUncertainty::referenceT, "scale of the reference; normal"},
}};

} // namespace

UncertaintySummary summaryOf(const FieldUncertainty& uncertainty) {
  UncertaintySummary summary;
  summary.referenceRelative = uncertainty.inputs().referenceRelative;
  for (const Share& share : allShares) {
    summary.shares.push_back({share.name, 0.0, share.basis});
  }
  std::vector<double> expanded;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Temperatures& at : temperaturesOf(uncertainty)) {
      for (int step = -stepsEachWay; step <= stepsEachWay; ++step) {
        const double fieldT = uncertainty.chain().fullScaleT * step / stepsEachWay;
        const ReadingUncertainty u =
            uncertainty.at(uncertainty.readingFor(Eigen::Vector3d::Unit(axis) * fieldT, at.probeC, at.electronicsC));
        summary.grid.push_back({axis, fieldT, at.probeC, at.electronicsC, u.expandedT[axis]});
        expanded.push_back(u.expandedT[axis]);
        for (std::size_t i = 0; i < allShares.size(); ++i) {
          double& largest = summary.shares[i].largestT;
          largest = std::max(largest, std::abs((u.*allShares[i].of)[axis]));
        }
      }
    }
  }
  summary.largestT = *std::max_element(expanded.begin(), expanded.end());
  summary.medianT = numerics::median(std::move(expanded));
  return summary;
}

Result<UncertaintySummary> uncertaintyOf(const FieldRun& run) {
  FieldUncertaintyInputs inputs;
  if (const double expandedT = run.result.traceability.reference.uncertainty; expandedT > 0.0) {
    inputs.referenceRelative = expandedT / 2.0 / run.result.chain.fullScaleT;
  }
  const auto uncertainty = FieldUncertainty::of(run.parts, run.result.chain, inputs, run.result.source.file);
  if (!uncertainty) {
    return std::unexpected(uncertainty.error());
  }
  return summaryOf(*uncertainty);
}

} // namespace straightedge::field
