#include "core/field/storage.h"

#include "core/field/chain_stages.h"
#include "core/field/closest_fit.h"
#include "core/field/names.h"
#include "core/field/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace straightedge::field {

namespace {

template <typename Coefficients>
std::size_t countOf(const Coefficients& coefficients) {
  return static_cast<std::size_t>(
      std::count_if(coefficients.begin(), coefficients.end(), [](double value) { return value != 0.0; }));
}

/// Multiplications of Horner's rule: the highest power that is there.
template <typename Coefficients>
std::size_t degreeOf(const Coefficients& coefficients) {
  std::size_t degree = coefficients.size();
  while (degree > 0 && coefficients[degree - 1] == 0.0) {
    --degree;
  }
  return degree > 0 ? degree - 1 : 0;
}

/// A polynomial; `times` more multiplications of its value.
template <typename Coefficients>
void add(ChainSize& size, const std::optional<Coefficients>& block, std::size_t times) {
  if (block && countOf(*block) > 0) {
    size.coefficients += countOf(*block);
    size.multiplications += degreeOf(*block) + times;
  }
}

int orderOf(const CorrectionChain& chain) {
  std::size_t terms = 1;
  for (const AxisChain& axis : chain.axes) {
    terms = std::max(terms, axis.nonlinearity.size());
  }
  return static_cast<int>(terms) - 1;
}

int slopeOrderOf(const CorrectionChain& chain) {
  std::size_t terms = 1;
  for (const AxisChain& axis : chain.axes) {
    terms = std::max(terms, axis.sensitivitySlope ? axis.sensitivitySlope->size() : 1);
  }
  return static_cast<int>(terms) - 1;
}

CorrectionChain withOrders(CorrectionChain chain, int order, int slopeOrder) {
  for (AxisChain& axis : chain.axes) {
    axis.nonlinearity.resize(static_cast<std::size_t>(order) + 1, 0.0);
    if (axis.sensitivitySlope) {
      axis.sensitivitySlope->resize(static_cast<std::size_t>(slopeOrder) + 1, 0.0);
    }
  }
  return chain;
}

/// False if the block is off already.
bool switchOff(CorrectionChain& chain, Block block) {
  bool wasOn = false;
  for (AxisChain& axis : chain.axes) {
    if (block == Block::Offset) {
      wasOn = std::exchange(axis.offsetT, std::nullopt).has_value() || wasOn;
    } else if (block == Block::Sensitivity) {
      wasOn = std::exchange(axis.sensitivitySlope, std::nullopt).has_value() || wasOn;
      axis.sensitivityIntercept.reset();
    } else if (block == Block::Electronics) {
      wasOn = std::exchange(axis.electronicsT, std::nullopt).has_value() || wasOn;
    } else if (block == Block::ElectronicsSensitivity) {
      wasOn = std::exchange(axis.electronicsSensitivity, std::nullopt).has_value() || wasOn;
    }
  }
  return wasOn;
}

const char* nameOf(Block block) {
  switch (block) {
  case Block::Offset:
    return "without offset";
  case Block::Sensitivity:
    return "without sensitivity";
  case Block::Electronics:
    return "without electronics";
  default:
    return "without electronics sensitivity";
  }
}

/// What all choices share, and the way from a chain to its figures.
class Comparison {
public:
  explicit Comparison(const FieldRun& run)
      : m_run(run), m_points(fitPoints(run.parts, run.result.chain)), m_start(run.result.chain),
        m_step(run.parts.recorded(CampaignStep::Verification) > 0 ? CampaignStep::Verification
                                                                  : CampaignStep::Nonlinearity) {
    if (const auto closest = fitClosely(m_points, m_start, m_run.result.source.file)) {
      m_start.axisMatrix = m_start.axisMatrix ? closest->chain.axisMatrix : std::nullopt;
    }
  }
  const CorrectionChain& start() const { return m_start; }
  const char* measuredWith() const { return m_step == CampaignStep::Verification ? "verification" : "plateaus"; }
  /// Adds the choice if the data determine it.
  void add(StorageChoice choice, std::vector<StorageChoice>& choices) const;

private:
  void measure(StorageChoice& choice) const;

  const FieldRun& m_run;
  FitPoints m_points;
  CorrectionChain m_start;
  CampaignStep m_step;
};

void Comparison::measure(StorageChoice& choice) const {
  for (const Axis axis : allAxes) {
    const StepRows& rows = m_run.parts.of(m_step, axis);
    if (rows.empty()) {
      continue;
    }
    const Eigen::VectorXd errors =
        (axisValuesT(choice.chain, axis, rows, ChainStage::ElectronicsSensitivity) - rows.referenceT) *
        (100.0 / choice.chain.fullScaleT);
    choice.peakPercent[indexOf(axis)] = errors.cwiseAbs().maxCoeff();
    choice.rmsPercent[indexOf(axis)] = std::sqrt(errors.squaredNorm() / static_cast<double>(errors.size()));
  }
  choice.largestPeakPercent = *std::max_element(choice.peakPercent.begin(), choice.peakPercent.end());
}

void Comparison::add(StorageChoice choice, std::vector<StorageChoice>& choices) const {
  const JointOptions options{.holdAxisMatrix = true};
  auto fitted = fitJointly(m_points, choice.chain, options, m_run.result.source.file);
  if (!fitted) {
    return;
  }
  choice.chain = std::move(fitted->chain);
  choice.size = sizeOf(choice.chain);
  measure(choice);
  choices.push_back(std::move(choice));
}

void markBest(std::vector<StorageChoice>& choices) {
  for (StorageChoice& choice : choices) {
    choice.isBest = std::none_of(choices.begin(), choices.end(), [&](const StorageChoice& other) {
      return other.size.coefficients <= choice.size.coefficients &&
             other.largestPeakPercent < choice.largestPeakPercent;
    });
  }
}

} // namespace

ChainSize sizeOf(const CorrectionChain& chain) {
  ChainSize size;
  bool needsProbe = false;
  for (const AxisChain& axis : chain.axes) {
    size.coefficients += axis.nonlinearity.size();
    size.multiplications += degreeOf(axis.nonlinearity);
    add(size, axis.offsetT, 0);
    add(size, axis.sensitivitySlope, 1);
    add(size, axis.sensitivityIntercept, 0);
    add(size, axis.electronicsT, 0);
    add(size, axis.electronicsSensitivity, 1);
    needsProbe = needsProbe || axis.offsetT || axis.sensitivitySlope;
  }
  if (chain.pt100 && needsProbe) {
    size.coefficients += 2;
    size.multiplications += 1;
  }
  if (chain.axisMatrix) {
    size.coefficients += 9;
    size.multiplications += 9;
  }
  return size;
}

Result<StorageComparison> compareStorage(const FieldRun& run, const JobControl& job) {
  const Comparison comparison(run);
  StorageComparison result;
  result.measuredWith = comparison.measuredWith();
  const bool hasSlope = slopeOrderOf(comparison.start()) > 0;
  for (int order = lowestOrder; order <= highestOrder; ++order) {
    for (int slopeOrder = hasSlope ? 1 : 0; slopeOrder <= (hasSlope ? highestSlopeOrder : 0); ++slopeOrder) {
      if (job.stopRequested()) {
        return fail(ErrorKind::Cancelled, "the comparison was stopped", "");
      }
      StorageChoice choice;
      choice.name = "order " + std::to_string(order) + (hasSlope ? ", slope " + std::to_string(slopeOrder) : "");
      choice.order = order;
      choice.slopeOrder = slopeOrder;
      choice.chain = withOrders(comparison.start(), order, slopeOrder);
      comparison.add(std::move(choice), result.choices);
    }
    job.report(static_cast<double>(order) / (highestOrder + 1));
  }
  for (const Block block : {Block::Offset, Block::Sensitivity, Block::Electronics, Block::ElectronicsSensitivity}) {
    StorageChoice choice;
    choice.name = nameOf(block);
    choice.without = block;
    choice.chain = comparison.start();
    if (switchOff(choice.chain, block)) {
      choice.order = orderOf(choice.chain);
      choice.slopeOrder = slopeOrderOf(choice.chain);
      comparison.add(std::move(choice), result.choices);
    }
  }
  markBest(result.choices);
  job.report(1.0);
  return result;
}

} // namespace straightedge::field
