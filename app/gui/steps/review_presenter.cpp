#include "app/gui/steps/review_presenter.h"

#include "app/gui/document/angle_document.h"
#include "app/gui/figures/figure_parts.h"
#include "app/gui/jobs/job_runner.h"
#include "core/angle/angles.h"

#include <algorithm>
#include <cmath>

namespace straightedge::gui {

namespace {

// More marked points than this would hide the data.
constexpr std::size_t mostMarked = 5000;
const QString jobKey = QStringLiteral("review");
const std::vector<std::size_t> noRows;

QString optionalDegrees(const std::optional<double>& value, const QString& otherwise) {
  return value ? degrees(*value) : otherwise;
}

} // namespace

ReviewPresenter::ReviewPresenter(AngleDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs) {
  connect(&document, &AngleDocument::opened, this, &ReviewPresenter::refresh);
  connect(&document, &AngleDocument::sweepChanged, this, &ReviewPresenter::refresh);
  connect(&document, &AngleDocument::runChanged, this, &ReviewPresenter::startAnalysis);
  connect(&m_table, &ReviewTableModel::enableRequested, this,
          [this](std::size_t row, bool enabled) { setEnabled({row}, enabled); });
  refresh();
}

bool ReviewPresenter::hasSweep() const { return m_document.sweep().size() > 0; }

QString ReviewPresenter::missing() const {
  return hasSweep() ? QString() : tr("There is no sweep yet. Capture one, or import a CSV file with recorded angles.");
}

void ReviewPresenter::refresh() {
  m_figureView.reset();
  m_table.setSweep(m_document.sweep());
  std::erase_if(m_selection, [this](std::size_t row) { return row >= m_document.sweep().size(); });
  startAnalysis();
  emit missingChanged();
  emit analysisChanged();
}

void ReviewPresenter::startAnalysis() {
  auto sweep = std::make_shared<const angle::Sweep>(m_document.sweep());
  auto run = m_document.run();
  m_jobs.run<ReviewAnalysis>(
      jobKey, tr("Reviewing the sweep"),
      [sweep, run](const JobControl& job) { return analyseForReview(*sweep, run.get(), job); },
      [this](Result<ReviewAnalysis> result) {
        if (!result) {
          return; // cancelled: a newer one is under way
        }
        m_analysis = std::make_shared<const ReviewAnalysis>(std::move(*result));
        m_figureView.reset();
        m_table.setAnalysis(m_analysis);
        emit analysisChanged();
      });
}

const std::vector<std::size_t>& ReviewPresenter::outliers() const { return m_analysis ? m_analysis->outliers : noRows; }

std::size_t ReviewPresenter::switchedOff() const {
  return static_cast<std::size_t>(std::ranges::count(m_document.sweep().enabled, false));
}

void ReviewPresenter::switchAllOn() {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < m_document.sweep().size(); ++row) {
    if (!m_document.sweep().isEnabled(row)) {
      rows.push_back(row);
    }
  }
  setEnabled(rows, true);
}

void ReviewPresenter::setEnabled(const std::vector<std::size_t>& rows, bool enabled) {
  std::vector<std::size_t> changing;
  std::ranges::copy_if(rows, std::back_inserter(changing),
                       [&](std::size_t row) { return m_document.sweep().isEnabled(row) != enabled; });
  if (!changing.empty()) {
    m_document.setPointsEnabled(changing, enabled);
  }
}

void ReviewPresenter::toggle(const std::vector<std::size_t>& rows) {
  const bool anyOn = std::ranges::any_of(rows, [this](std::size_t row) { return m_document.sweep().isEnabled(row); });
  setEnabled(rows, !anyOn);
}

void ReviewPresenter::setSelection(std::vector<std::size_t> rows) {
  if (rows != m_selection) {
    m_selection = std::move(rows);
    emit plotsChanged();
  }
}

QList<ReviewPresenter::Fact> ReviewPresenter::facts() const {
  const std::size_t all = m_document.sweep().size();
  QList<Fact> facts;
  const std::size_t off = switchedOff();
  facts << Fact{tr("Readings"),
                off == 0 ? QString::number(all) : tr("%1 of %2").arg(QString::number(all - off), QString::number(all)),
                tr("Switched on, of all recorded")};
  const auto run = m_document.run();
  if (!run || m_document.runError()) {
    return facts;
  }
  const angle::AlignedSweep& aligned = run->aligned;
  const QString notMeasured = QStringLiteral("–");
  facts << Fact{tr("Distinct angles"), QString::number(aligned.distinctAngles),
                tr("Different encoder angles on the turn")}
        << Fact{tr("Largest gap"), degrees(aligned.largestGapDeg, 3),
                tr("Between neighbouring readings; the median is %1").arg(degrees(aligned.medianGapDeg, 3))}
        << Fact{tr("Noise (1 σ)"), optionalDegrees(aligned.passes.noiseDeg, notMeasured),
                tr("Of one reading; needs several readings at each point")}
        << Fact{tr("Hysteresis"), optionalDegrees(aligned.passes.hysteresisMaxDeg, notMeasured),
                tr("Largest half difference of both directions; needs a sweep in both")}
        << Fact{tr("Repeatability (1 σ)"), optionalDegrees(aligned.passes.repeatabilityDeg, notMeasured),
                tr("Between turns at the same angle; needs several turns")}
        << Fact{tr("Leave-one-out error"), degrees(run->curve.leaveOneOutRmsDeg, 3),
                tr("How well each point is foretold by the others, rms; at most %1")
                    .arg(degrees(run->curve.leaveOneOutMaxDeg, 3))};
  if (m_analysis) {
    facts << Fact{
        tr("Outliers"), QString::number(m_analysis->outliers.size()),
        m_analysis->outlierLimitDeg > 0.0
            ? tr("Farther than %1 from what the other points foretell").arg(degrees(m_analysis->outlierLimitDeg, 3))
            : QString()};
  }
  return facts;
}

QList<Notice> ReviewPresenter::notices() const {
  QList<Notice> notices;
  if (!hasSweep()) {
    return notices;
  }
  if (const std::optional<Error>& error = m_document.runError()) {
    notices << Notice{Notice::Level::Problem,
                      tr("This sweep cannot be calibrated: %1").arg(QString::fromStdString(error->message()))};
    return notices;
  }
  if (const auto run = m_document.run()) {
    for (const angle::Warning& warning : run->aligned.warnings) {
      const bool information = warning.topic == angle::Warning::Topic::SensorRunsBackwards;
      notices << Notice{information ? Notice::Level::Information : Notice::Level::Warning,
                        QString::fromStdString(warning.text)};
    }
  }
  return notices;
}

RowFigure ReviewPresenter::residualFigure() const {
  RowFigure figure;
  figure.spec.title = tr("Residual over encoder angle");
  figure.spec.x = turnAxis(tr("Encoder angle (°)"));
  figure.spec.y = dataAxis(tr("Residual (°)"));
  const angle::Sweep& sweep = m_document.sweep();
  if (!m_analysis || m_analysis->rows.size() != sweep.size() || m_analysis->outlierLimitDeg <= 0.0) {
    figure.spec.note = tr("Residuals appear once a correction curve is fitted.");
    return figure;
  }
  PlotSeries points;
  points.name = tr("Readings");
  points.style = SeriesStyle::Points;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < sweep.size(); ++row) {
    const double residual = m_analysis->rows[row].residualDeg;
    if (!std::isfinite(residual)) {
      continue;
    }
    points.x.append(angle::wrap360(sweep.encoderDeg[row]));
    points.y.append(residual);
    points.emphasised.append(!sweep.isEnabled(row));
    rows.push_back(row);
  }
  figure.spec.series.append(points);
  figure.rows.push_back(std::move(rows));
  for (const double side : {1.0, -1.0}) {
    figure.spec.guides.append({.id = side > 0 ? QStringLiteral("upper") : QStringLiteral("lower"),
                               .label = side > 0 ? tr("outlier") : QString(),
                               .value = side * m_analysis->outlierLimitDeg,
                               .color = SeriesColor::Bad,
                               .unit = QStringLiteral("°")});
  }
  figure.spec.note = m_analysis->fromNeighbours ? tr("Each point against the cubic through its four neighbours")
                                                : tr("Each point against the fitted correction curve");
  return figure;
}

RowFigure ReviewPresenter::figure(View view) const {
  const angle::Sweep& sweep = m_document.sweep();
  const auto run = m_document.runError() ? nullptr : m_document.run();
  switch (view) {
  case View::Error:
    return errorFigure(sweep, run ? run->aligned.direction : angle::SensorDirection::Increasing, ErrorAxis::Encoder,
                       ConstantPart::Kept);
  case View::Unwrapped:
    return run ? unwrappedFigure(run->aligned) : sensorOverEncoderFigure(sweep);
  case View::Residual:
    return residualFigure();
  case View::Hysteresis:
    return {hysteresisFigure(run ? run->aligned.passes : angle::Repeatability{}), {}};
  case View::Noise:
    return {noiseHistogramFigure(run ? run->aligned : angle::AlignedSweep{}, run ? &run->curve : nullptr), {}};
  case View::Coverage: {
    std::vector<double> measured;
    for (std::size_t row = 0; row < sweep.size(); ++row) {
      if (sweep.isEnabled(row)) {
        measured.push_back(sweep.encoderDeg[row]);
      }
    }
    PlotSpec ring = coverageRingFigure({}, measured, run ? run->aligned.gaps : std::vector<angle::CoverageGap>{});
    ring.series.removeIf(
        [](const PlotSeries& series) { return series.x.isEmpty(); }); // no plan: an import may have none
    return {std::move(ring), {}};
  }
  }
  return {};
}

void ReviewPresenter::markRows(RowFigure& figure) const {
  const auto mark = [&figure](const QString& name, const std::vector<std::size_t>& wanted, SeriesColor color) {
    if (wanted.empty() || wanted.size() > mostMarked) {
      return;
    }
    PlotSeries series;
    series.name = name;
    series.style = SeriesStyle::Points;
    series.color = color;
    std::vector<std::size_t> rows;
    for (std::size_t from = 0; from < figure.rows.size(); ++from) {
      for (std::size_t i = 0; i < figure.rows[from].size(); ++i) {
        if (std::ranges::binary_search(wanted, figure.rows[from][i])) {
          const PlotSeries& source = figure.spec.series[static_cast<qsizetype>(from)];
          series.x.append(source.x[static_cast<qsizetype>(i)]);
          series.y.append(source.y[static_cast<qsizetype>(i)]);
          rows.push_back(figure.rows[from][i]);
        }
      }
    }
    figure.spec.series.append(series);
    figure.rows.push_back(std::move(rows));
  };
  const std::vector<std::size_t> outlying = outliers();
  std::vector<std::size_t> selected = m_selection;
  std::ranges::sort(selected);
  mark(tr("Outliers"), outlying, SeriesColor::Bad);
  mark(tr("Selected"), selected, SeriesColor::Reference);
}

PlotSpec ReviewPresenter::plot(View view) const {
  if (m_figureView != view) {
    m_figure = figure(view);
    m_figureView = view;
  }
  RowFigure marked = m_figure;
  if (!marked.rows.empty()) {
    markRows(marked);
  }
  return marked.spec;
}

std::optional<std::size_t> ReviewPresenter::rowAt(View view, int series, int index) const {
  if (m_figureView != view) {
    m_figure = figure(view);
    m_figureView = view;
  }
  RowFigure marked = m_figure;
  markRows(marked);
  if (series < 0 || static_cast<std::size_t>(series) >= marked.rows.size()) {
    return std::nullopt;
  }
  const auto& rows = marked.rows[static_cast<std::size_t>(series)];
  if (index < 0 || static_cast<std::size_t>(index) >= rows.size()) {
    return std::nullopt;
  }
  return rows[static_cast<std::size_t>(index)];
}

} // namespace straightedge::gui
