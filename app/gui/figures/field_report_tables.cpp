#include "app/gui/figures/field_report_tables.h"

#include "app/gui/figures/field_axis_figures.h"
#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/field_words.h"
#include "app/gui/figures/figure_parts.h"
#include "core/field/block_names.h"
#include "core/field/names.h"

#include <algorithm>
#include <utility>

namespace straightedge::gui {

namespace {

QString leftBy(const field::BlockSummary& summary, double value) {
  return summary.block == field::Block::ProbeTemperature ? peopleNumber(value) + QStringLiteral(" °C")
                                                         : microteslaText(value);
}

QString orNone(const std::optional<double>& percent) { return percent ? peopleNumber(*percent) : QStringLiteral("–"); }

} // namespace

ReportTable campaignTable(const FieldResults& results) {
  ReportTable table;
  table.caption = QStringLiteral("Campaign: rows of each step");
  table.header = {QStringLiteral("Step"), QStringLiteral("Recorded"), QStringLiteral("Used"),
                  QStringLiteral("Not locked"), QStringLiteral("Incomplete")};
  for (const field::CampaignStep step : field::allSteps) {
    const field::CampaignParts& parts = results.run->parts;
    std::size_t used = 0;
    std::size_t unlocked = 0;
    std::size_t incomplete = 0;
    const auto count = [&](const field::StepRows& rows) {
      used += static_cast<std::size_t>(rows.size());
      unlocked += rows.unlocked;
      incomplete += rows.incomplete;
    };
    if (field::needsOf(step).axis) {
      for (const field::Axis axis : field::allAxes) {
        count(parts.of(step, axis));
      }
    } else {
      count(parts.of(step));
    }
    table.rows.append({stepTitle(step), QString::number(parts.recorded(step)), QString::number(used),
                       QString::number(unlocked), QString::number(incomplete)});
  }
  return table;
}

ReportTable blocksTable(const field::FieldCalibration& calibration) {
  ReportTable table;
  table.caption = QStringLiteral("Blocks of the correction: what they were fitted to and what they leave");
  table.header = {QStringLiteral("Block"),    QStringLiteral("Axis"),         QStringLiteral("Rows"),
                  QStringLiteral("Left out"), QStringLiteral("Coefficients"), QStringLiteral("Residual (1σ)"),
                  QStringLiteral("Largest")};
  table.firstNumericColumn = 2;
  for (const auto& [block, word] : field::blockWords) {
    bool on = false;
    for (const field::BlockSummary& summary : calibration.blocks) {
      if (summary.block == block) {
        on = true;
        table.rows.append({blockTitle(block), summary.axis ? axisLetter(*summary.axis) : QStringLiteral("all"),
                           QString::number(summary.rowsUsed), QString::number(summary.rowsLeftOut),
                           QString::number(summary.coefficients), leftBy(summary, summary.residualSigma),
                           leftBy(summary, summary.residualLargest)});
      }
    }
    if (!on) {
      table.rows.append({blockTitle(block), QStringLiteral("all"), QStringLiteral("off"), {}, {}, {}, {}});
    }
  }
  return table;
}

ReportTable ordersTable(const field::FieldCalibration& calibration) {
  ReportTable table;
  table.caption =
      QStringLiteral("Nonlinearity: largest error of each order in percent of full scale; CV: cross-validated");
  table.header = {QStringLiteral("Order")};
  std::vector<field::Axis> axes;
  for (const field::Axis axis : field::allAxes) {
    if (std::ranges::find(calibration.orders, axis, &field::OrderError::axis) != calibration.orders.end()) {
      axes.push_back(axis);
      table.header << axisLetter(axis) << axisLetter(axis) + QStringLiteral(", CV")
                   << axisLetter(axis) + QStringLiteral(", CV rms");
    }
  }
  for (int order = field::lowestOrder; order <= field::highestOrder; ++order) {
    QStringList row{order == calibration.order ? QStringLiteral("%1 (chosen)").arg(order) : QString::number(order)};
    bool known = false;
    for (const field::Axis axis : axes) {
      const auto found = std::ranges::find_if(
          calibration.orders, [&](const field::OrderError& each) { return each.axis == axis && each.order == order; });
      if (found == calibration.orders.end()) {
        row << QStringLiteral("–") << QStringLiteral("–") << QStringLiteral("–");
      } else {
        known = true;
        row << peopleNumber(found->maxErrorPercent) << orNone(found->crossMaxPercent) << orNone(found->crossRmsPercent);
      }
    }
    if (known) {
      table.rows.append(row);
    }
  }
  return table;
}

ReportTable fieldVerificationTable(const std::vector<field::VerificationRow>& rows, field::PercentOf of) {
  ReportTable table;
  table.caption = of == field::PercentOf::FullScale
                      ? QStringLiteral("Verification before and after each block, in percent of full scale")
                      : QStringLiteral("Verification in percent of the reading, over readings in at least %1 % of "
                                       "full scale")
                            .arg(peopleNumber(100.0 * field::leastOfReading, 1));
  table.header = {QStringLiteral("Axis"),  QStringLiteral("Blocks up to"), QStringLiteral("Mean"),
                  QStringLiteral("Sigma"), QStringLiteral("Peak"),         QStringLiteral("Readings")};
  table.firstNumericColumn = 2;
  for (const field::VerificationRow& row : rows) {
    const std::optional<field::ErrorFigures> figures =
        of == field::PercentOf::FullScale ? std::optional(row.ofFullScale) : row.ofReading;
    if (figures) {
      table.rows.append({axisLetter(row.axis), stateTitle(row.state), peopleNumber(figures->mean),
                         peopleNumber(figures->sigma), peopleNumber(figures->peak),
                         row.points > 0 ? QString::number(row.points) : QStringLiteral("–")});
    }
  }
  return table;
}

ReportTable fieldUncertaintyTable(const field::UncertaintySummary& summary) {
  ReportTable table;
  table.caption = QStringLiteral("Uncertainty of one component of a corrected reading, where each contribution is "
                                 "largest over field and temperature");
  table.header = {QStringLiteral("Contribution"), QStringLiteral("Standard (µT)"), QStringLiteral("Basis")};
  table.lastNumericColumn = 1;
  for (const field::UncertaintyShare& share : summary.shares) {
    table.rows.append({fromText(share.name), peopleNumber(share.largestT / teslaPerMicrotesla), fromText(share.basis)});
  }
  const QString probability = peopleNumber(100.0 * summary.probability, 2);
  table.rows.append({QStringLiteral("expanded, %1 %: largest").arg(probability),
                     peopleNumber(summary.largestT / teslaPerMicrotesla),
                     QStringLiteral("over the full scale and the temperatures of the campaign")});
  table.rows.append({QStringLiteral("expanded, %1 %: median").arg(probability),
                     peopleNumber(summary.medianT / teslaPerMicrotesla), QStringLiteral("over the same")});
  return table;
}

ReportTable storageTable(const field::StorageComparison& comparison) {
  ReportTable table;
  table.caption = QStringLiteral("Coefficients and multiplications against the error that remains, in percent of full "
                                 "scale over the %1; best: nothing smaller is as good")
                      .arg(fromText(comparison.measuredWith));
  table.header = {QStringLiteral("Choice"), QStringLiteral("Coefficients"), QStringLiteral("Multiplications"),
                  QStringLiteral("Peak x"), QStringLiteral("Peak y"),       QStringLiteral("Peak z"),
                  QStringLiteral("Best")};
  for (const field::StorageChoice& choice : comparison.choices) {
    table.rows.append({fromText(choice.name), QString::number(choice.size.coefficients),
                       QString::number(choice.size.multiplications), peopleNumber(choice.peakPercent[0]),
                       peopleNumber(choice.peakPercent[1]), peopleNumber(choice.peakPercent[2]),
                       choice.isBest ? QStringLiteral("best") : QString()});
  }
  return table;
}

namespace {

constexpr int coefficientDigits = 9;

/// A row per power; blocks that are off on every axis are left out.
template <typename Coefficients>
void addCoefficients(ReportTable& table, const field::CorrectionChain& chain, const QString& name,
                     Coefficients coefficients) {
  std::size_t most = 0;
  for (const field::AxisChain& axis : chain.axes) {
    most = std::max(most, coefficients(axis).size());
  }
  for (std::size_t power = 0; power < most; ++power) {
    QStringList row{QStringLiteral("%1 [%2]").arg(name).arg(power)};
    for (const field::AxisChain& axis : chain.axes) {
      const std::vector<double> values = coefficients(axis);
      row << (power < values.size() ? peopleNumber(values[power], coefficientDigits) : QStringLiteral("off"));
    }
    table.rows.append(row);
  }
}

template <typename Values>
std::vector<double> coefficientsOf(const std::optional<Values>& values) {
  return values ? std::vector<double>(values->begin(), values->end()) : std::vector<double>();
}

} // namespace

ReportTable chainTable(const field::CorrectionChain& chain) {
  using field::AxisChain;
  ReportTable table;
  table.caption = QStringLiteral("Coefficients in ascending powers, tesla and °C; the file has all their digits");
  table.header = {QStringLiteral("Coefficient"), QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  addCoefficients(table, chain, QStringLiteral("Nonlinearity"), [](const AxisChain& a) { return a.nonlinearity; });
  addCoefficients(table, chain, QStringLiteral("Offset"), [](const AxisChain& a) { return coefficientsOf(a.offsetT); });
  addCoefficients(table, chain, QStringLiteral("Sensitivity, slope K"),
                  [](const AxisChain& a) { return coefficientsOf(a.sensitivitySlope); });
  addCoefficients(table, chain, QStringLiteral("Sensitivity, intercept C"),
                  [](const AxisChain& a) { return coefficientsOf(a.sensitivityIntercept); });
  addCoefficients(table, chain, QStringLiteral("Electronics"),
                  [](const AxisChain& a) { return coefficientsOf(a.electronicsT); });
  addCoefficients(table, chain, QStringLiteral("Electronics sensitivity"),
                  [](const AxisChain& a) { return coefficientsOf(a.electronicsSensitivity); });
  return table;
}

ReportTable axisMatrixTable(const Eigen::Matrix3d& matrix) {
  ReportTable table;
  table.caption = QStringLiteral("Axis matrix S: rows are axes of the probe, columns of the package");
  table.header = {QStringLiteral("Axis"), QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  for (const field::Axis axis : field::allAxes) {
    const auto row = static_cast<Eigen::Index>(field::indexOf(axis));
    table.rows.append({axisLetter(axis), peopleNumber(matrix(row, 0), coefficientDigits),
                       peopleNumber(matrix(row, 1), coefficientDigits),
                       peopleNumber(matrix(row, 2), coefficientDigits)});
  }
  return table;
}

ReportTable axisAnglesTable(const Eigen::Matrix3d& matrix) {
  ReportTable table;
  table.caption = QStringLiteral("Angles of the axes in degrees");
  table.header = {QStringLiteral("Between"), QStringLiteral("Angle"), QStringLiteral("Probe axis against package"),
                  QStringLiteral("Tilt")};
  const Eigen::Vector3d between = anglesBetweenAxesDeg(matrix);
  const Eigen::Vector3d tilts = axisTiltsDeg(matrix);
  const std::array<QString, 3> pairs = {QStringLiteral("x and y"), QStringLiteral("x and z"),
                                        QStringLiteral("y and z")};
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto place = static_cast<std::size_t>(i);
    table.rows.append({pairs.at(place), peopleNumber(between[i], 6), axisLetter(field::allAxes.at(place)),
                       peopleNumber(tilts[i], 4)});
  }
  return table;
}

QString fieldVerdictSentence(const field::LimitReport& report) {
  return QStringLiteral("%1: largest error %2 of %3 (axis %4, %5 before correction) %6 the limit of %7.")
      .arg(report.met ? QStringLiteral("Passed") : QStringLiteral("Failed"), percentText(report.peakPercent),
           report.of == field::PercentOf::FullScale ? QStringLiteral("full scale") : QStringLiteral("the reading"),
           axisLetter(report.worstAxis), percentText(report.peakBeforePercent),
           report.met ? QStringLiteral("is within") : QStringLiteral("exceeds"), percentText(report.limitPercent));
}

} // namespace straightedge::gui
