#include "core/field/probe_temperature.h"

#include "core/field/messages.h"
#include "core/field/names.h"
#include "core/field/probe_lag.h"
#include "core/field/residuals.h"
#include "core/field/span_checks.h"
#include "core/numerics/polynomial.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace straightedge::field {

namespace {

/// A PT100 has 0.385 Ω/°C; one that moves less than a tenth of that is not in the chamber.
constexpr double leastOhmPerC = 0.0385;

/// +1 heating, −1 cooling, 0 not known: by the chamber some rows before and after.
std::vector<int> directions(const Eigen::VectorXd& chamberC) {
  const Eigen::Index rows = chamberC.size();
  const Eigen::Index reach = std::max<Eigen::Index>(1, rows / 200);
  const double least = 1e-4 * (chamberC.maxCoeff() - chamberC.minCoeff());
  std::vector<int> result(static_cast<std::size_t>(rows), 0);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double change = chamberC[std::min(i + reach, rows - 1)] - chamberC[std::max<Eigen::Index>(i - reach, 0)];
    result[static_cast<std::size_t>(i)] = change > least ? 1 : change < -least ? -1 : 0;
  }
  return result;
}

struct Loop {
  double mean = 0.0, largest = 0.0;
};

/// Heating less cooling at equal resistance, over ten parts of the range. Nothing without both directions.
std::optional<Loop> loopOf(const Eigen::VectorXd& ohm, const std::vector<int>& direction,
                           const Eigen::VectorXd& residualC) {
  constexpr std::size_t parts = 10;
  constexpr int leastEach = 2;
  struct Side {
    double sum = 0.0;
    int count = 0;
  };
  std::array<std::array<Side, 2>, parts> sides{};
  const double from = ohm.minCoeff();
  const double width = (ohm.maxCoeff() - from) / static_cast<double>(parts);
  for (Eigen::Index i = 0; i < ohm.size(); ++i) {
    const int heading = direction[static_cast<std::size_t>(i)];
    if (heading == 0) {
      continue;
    }
    const auto part = std::min(parts - 1, static_cast<std::size_t>((ohm[i] - from) / width));
    Side& side = sides[part][heading > 0 ? 0 : 1];
    side.sum += residualC[i];
    ++side.count;
  }
  Loop loop;
  int known = 0;
  for (const auto& [heating, cooling] : sides) {
    if (heating.count < leastEach || cooling.count < leastEach) {
      continue;
    }
    const double gap = heating.sum / heating.count - cooling.sum / cooling.count;
    loop.mean += gap;
    loop.largest = std::abs(gap) > std::abs(loop.largest) ? gap : loop.largest;
    ++known;
  }
  if (known == 0) {
    return std::nullopt;
  }
  loop.mean /= known;
  return loop;
}

bool timesRise(const Eigen::VectorXd& timeS) {
  for (Eigen::Index i = 1; i < timeS.size(); ++i) {
    if (timeS[i] < timeS[i - 1]) {
      return false;
    }
  }
  return true;
}

Result<void> checkResponse(const StepRows& rows, const std::string& name) {
  if (auto enough = checkRowCount(rows, name); !enough) {
    return enough;
  }
  const std::string step(stepName(rows.step));
  if (auto moves = checkSpan(rows.chamberC, "chamber", step, name); !moves) {
    return moves;
  }
  const double ohms = rows.pt100Ohm.maxCoeff() - rows.pt100Ohm.minCoeff();
  const double span = rows.chamberC.maxCoeff() - rows.chamberC.minCoeff();
  if (ohms < leastOhmPerC * span) {
    return campaignFault(name, 0,
                         "the PT100 does not follow the chamber in the step " + step + ": it moves by " +
                             formatForPeople(ohms, 3) + " Ω over " + celsiusText(span),
                         "check that the probe is in the chamber and its PT100 is connected");
  }
  return {};
}

/// Of the line itself where it is least sure: at the ends of the sweep.
double lineUncertainty(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& ohm) {
  double largest = 0.0;
  for (const double at : {ohm.minCoeff(), ohm.maxCoeff()}) {
    const Eigen::Vector2d by(at, 1.0); // slope first
    largest = std::max(largest, by.dot(covariance * by));
  }
  return std::sqrt(largest);
}

std::string wideLoopText(const ProbeTemperatureReport& report) {
  if (!report.hysteresisC || std::abs(*report.hysteresisC) < wideLoop * report.spanC) {
    return {};
  }
  return "; the loop is as wide as " + formatForPeople(100.0 * std::abs(*report.hysteresisC) / report.spanC, 2) +
         " % of the sweep: sweep the chamber more slowly";
}

void findLag(const StepRows& rows, const Eigen::VectorXd& aboveC, ProbeTemperatureReport& report) {
  if (!rows.timeS.allFinite()) {
    report.lagText = "no times: lag not estimated";
    return;
  }
  if (!timesRise(rows.timeS)) {
    report.lagText = "the times do not rise: lag not estimated";
    return;
  }
  const auto lag = fitLag(rows.timeS, aboveC, rows.pt100Ohm);
  if (!lag) {
    report.lagText = "no lag found: the line fits as well without one";
    return;
  }
  report.lagS = lag->lagS;
  report.lagText = "the probe trails the chamber with a time constant of " + formatForPeople(lag->lagS, 3) +
                   " s; the line is fitted to the temperature as the probe felt it";
  report.line = {lag->slope, lag->intercept};
  report.block.covariance = lag->covariance.reverse(); // slope first
  report.block.residuals = residualsOf(lag->residuals, 4);
  report.feltC = lag->laggedC;
  if (const auto left = loopOf(rows.pt100Ohm, report.directions, lag->residuals)) {
    report.loopLeftC = left->mean;
  }
}

} // namespace

Result<ProbeTemperatureReport> fitProbeTemperature(const StepRows& rows, double referenceTemperatureC,
                                                   const std::string& name) {
  if (auto responds = checkResponse(rows, name); !responds) {
    return std::unexpected(std::move(responds.error()));
  }
  const Eigen::VectorXd aboveC = rows.chamberC.array() - referenceTemperatureC;
  const auto fit = numerics::fitPolynomial(rows.pt100Ohm, aboveC, 1, numerics::PolynomialDetail::WithoutInfluence);
  if (!fit || fit->coefficients[1] <= 0.0) {
    return campaignFault(name, 0, "the resistance of the PT100 falls as the chamber warms up",
                         "check the columns chamber_C and pt100_ohm");
  }
  ProbeTemperatureReport report;
  report.plainLine = {fit->coefficients[1], fit->coefficients[0]};
  report.line = report.plainLine;
  report.spanC = rows.chamberC.maxCoeff() - rows.chamberC.minCoeff();
  report.block.covariance = fit->covariance.reverse(); // slope first
  report.block.residuals = residualsOf(fit->residuals, 2);
  report.feltC = aboveC;
  report.directions = directions(rows.chamberC);
  if (const auto loop = loopOf(rows.pt100Ohm, report.directions, fit->residuals)) {
    report.hysteresisC = loop->mean;
    report.largestHysteresisC = loop->largest;
  }
  findLag(rows, aboveC, report);
  report.lagText += wideLoopText(report);
  report.standardUncertaintyC =
      std::hypot(report.block.residuals.sigma, lineUncertainty(report.block.covariance, rows.pt100Ohm));
  report.block.rows = rowsOf(rows);
  report.block.how = "line through " + counted(report.block.rows.used, "row") +
                     " of chamber temperature over resistance, " + celsiusText(rows.chamberC.minCoeff()) + " to " +
                     celsiusText(rows.chamberC.maxCoeff()) + "; " + report.lagText;
  report.ohm = rows.pt100Ohm;
  report.chamberC = aboveC;
  report.lineC = rows.pt100Ohm.array() * report.line.slopeCPerOhm + report.line.interceptC;
  return report;
}

} // namespace straightedge::field
