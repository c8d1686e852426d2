#include "core/field/fit_points.h"

#include "core/field/chain_stages.h"
#include "core/field/names.h"
#include "core/field/plateaus.h"

#include <cmath>
#include <map>
#include <utility>

namespace straightedge::field {

namespace {

constexpr double binC = 0.5; ///< temperatures of one point lie within

/// Sums over the rows of one point; squares about the first row's value, so that nothing is lost in them.
struct Sums {
  double raw = 0.0, probe = 0.0, electronics = 0.0, target = 0.0;
  Eigen::Vector3d field = Eigen::Vector3d::Zero();
  double firstError = 0.0, error = 0.0, squares = 0.0;
  double rows = 0.0;
};

/// One axis's columns of a step.
class Columns {
public:
  Columns(const CorrectionChain& chain, Axis axis, const StepRows& rows)
      : m_axis(static_cast<Eigen::Index>(indexOf(axis))), m_rows(rows), m_probeC(probeTemperatureC(chain, rows)),
        m_electronicsC(electronicsTemperatureC(chain, rows)),
        m_valueT(axisValuesT(chain, axis, rows, ChainStage::ElectronicsSensitivity)) {}

  void add(Eigen::Index row, Sums& sums) const;
  /// Points of the rows first to last of one run.
  void addRun(Eigen::Index first, Eigen::Index last, std::size_t run, std::vector<FitPoint>& points) const;

private:
  Eigen::Index m_axis;
  const StepRows& m_rows;
  Eigen::VectorXd m_probeC, m_electronicsC, m_valueT;
};

void Columns::add(Eigen::Index row, Sums& sums) const {
  Eigen::Vector3d field = Eigen::Vector3d::Zero();
  double target = 0.0;
  if (m_rows.step == CampaignStep::Orientation) {
    // Signed along the package axis or along the field: the reading of that axis tells.
    const auto along = static_cast<Eigen::Index>(indexOf(axisOf(m_rows.orientation[static_cast<std::size_t>(row)])));
    field[along] = std::copysign(m_rows.referenceT[row], m_rows.rawT(row, along));
  } else if (m_rows.step != CampaignStep::Offset && m_rows.step != CampaignStep::Electronics) {
    target = m_rows.referenceT[row];
  }
  const double error = m_valueT[row] - target - field[m_axis];
  if (sums.rows == 0.0) {
    sums.firstError = error;
  }
  const double moved = error - sums.firstError;
  sums.raw += m_rows.rawT(row, m_axis);
  sums.probe += m_probeC[row];
  sums.electronics += m_electronicsC[row];
  sums.target += target;
  sums.field += field;
  sums.error += moved;
  sums.squares += moved * moved;
  sums.rows += 1.0;
}

void Columns::addRun(Eigen::Index first, Eigen::Index last, std::size_t run, std::vector<FitPoint>& points) const {
  std::map<std::pair<int, int>, Sums> bins;
  for (Eigen::Index row = first; row < last; ++row) {
    add(row, bins[{static_cast<int>(std::floor(m_probeC[row] / binC + 0.5)),
                   static_cast<int>(std::floor(m_electronicsC[row] / binC + 0.5))}]);
  }
  for (const auto& [bin, sums] : bins) {
    FitPoint point;
    point.step = m_rows.step;
    point.rawT = sums.raw / sums.rows;
    point.probeC = sums.probe / sums.rows;
    point.electronicsC = sums.electronics / sums.rows;
    point.targetT = sums.target / sums.rows;
    point.fieldT = sums.field / sums.rows;
    point.rows = static_cast<std::size_t>(sums.rows);
    point.run = run;
    point.scatterT2 = sums.squares - sums.error * sums.error / sums.rows;
    points.push_back(point);
  }
}

/// The runs of an orientation step also end where the orientation changes.
bool sameOrientation(const StepRows& rows, Eigen::Index a, Eigen::Index b) {
  return rows.orientation.empty() ||
         rows.orientation[static_cast<std::size_t>(a)] == rows.orientation[static_cast<std::size_t>(b)];
}

void addRuns(const CorrectionChain& chain, Axis axis, const StepRows& rows, std::size_t& run,
             std::vector<FitPoint>& points) {
  const Columns columns(chain, axis, rows);
  for (std::size_t k = 0; k < rows.runBegin.size(); ++k) {
    Eigen::Index first = rows.runBegin[k];
    for (Eigen::Index row = first + 1; row <= rows.runEnd(k); ++row) {
      if (row == rows.runEnd(k) || !sameOrientation(rows, first, row)) {
        columns.addRun(first, row, run++, points);
        first = row;
      }
    }
  }
}

} // namespace

FitPoints fitPoints(const CampaignParts& parts, const CorrectionChain& chain) {
  FitPoints all;
  for (const Axis axis : allAxes) {
    std::vector<FitPoint>& points = all.axes[indexOf(axis)];
    std::size_t run = 0;
    const StepRows& rows = parts.of(CampaignStep::Nonlinearity, axis);
    const AxisPlateaus plateaus = findPlateaus(rows, chain.fullScaleT);
    const Columns columns(chain, axis, rows);
    for (const Plateau& plateau : plateaus.plateaus) {
      columns.addRun(plateau.first, plateau.first + plateaus.rowsEach, run++, points);
    }
    addRuns(chain, axis, parts.of(CampaignStep::Offset), run, points);
    addRuns(chain, axis, parts.of(CampaignStep::Sensitivity, axis), run, points);
    addRuns(chain, axis, parts.of(CampaignStep::Electronics), run, points);
    addRuns(chain, axis, parts.of(CampaignStep::ElectronicsSensitivity, axis), run, points);
    addRuns(chain, axis, parts.of(CampaignStep::Orientation), run, points);
  }
  return all;
}

} // namespace straightedge::field
