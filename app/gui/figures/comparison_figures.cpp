#include "app/gui/figures/comparison_figures.h"

#include "app/gui/figures/figure_parts.h"

#include <algorithm>
#include <cmath>

namespace straightedge::gui {

namespace {

/// Below this an error is numerical dust (a curve that is itself a sum of harmonics): it would squeeze the plot.
constexpr double smallestErrorShownDeg = 1e-4;
constexpr double bytesPerFloat = 4.0;

bool sameMethod(const angle::ModelName& a, const angle::ModelName& b) {
  return a.kind == b.kind && a.method == b.method;
}

PlotGuide guide(const char* id, const QString& label, bool vertical, double value, SeriesColor color,
                const QString& unit) {
  PlotGuide line;
  line.id = QString::fromLatin1(id);
  line.label = label;
  line.vertical = vertical;
  line.value = value;
  line.draggable = true;
  line.color = color;
  line.unit = unit;
  return line;
}

/// Three digits: the leave-one-out error is not known better.
double rounded(double valueDeg) {
  const double unit = std::pow(10.0, std::floor(std::log10(valueDeg)) - 2.0);
  return std::round(valueDeg / unit) * unit;
}

void addGuides(PlotSpec& spec, const ComparisonFigureOptions& options) {
  if (options.leaveOneOutDeg && *options.leaveOneOutDeg >= smallestErrorShownDeg) {
    PlotGuide data = guide("data", QStringLiteral("Data support"), false, rounded(*options.leaveOneOutDeg),
                           SeriesColor::Muted, QStringLiteral("°"));
    data.draggable = false;
    spec.guides.append(data);
  }
  if (options.targetErrorDeg) {
    spec.guides.append(guide(targetGuide, QStringLiteral("Target"), false, *options.targetErrorDeg, SeriesColor::Good,
                             QStringLiteral("°")));
  }
  if (options.budgetEntries) {
    const bool bytes = options.storage == StorageMeasure::Bytes;
    spec.guides.append(guide(budgetGuide, QStringLiteral("Budget"), true,
                             budgetOnAxis(*options.budgetEntries, options.storage, options.bits), SeriesColor::Bad,
                             bytes ? QStringLiteral("bytes") : QStringLiteral("entries")));
  }
}

void setRange(PlotSpec& spec, double smallest, double largest, double mostStorage,
              const ComparisonFigureOptions& options) {
  // the target line must be reachable even where every model is better or worse
  const double low = std::min(smallest, options.targetErrorDeg.value_or(smallest));
  const double high = std::max(largest, options.targetErrorDeg.value_or(largest));
  spec.y.minimum = std::max(low / 1.5, smallestErrorShownDeg);
  spec.y.maximum = high * 1.5;
  const double least = options.storage == StorageMeasure::Bytes ? 2.0 : 1.0;
  spec.x.minimum = least * 0.85;
  spec.x.maximum = mostStorage * 1.15;
}

} // namespace

ComparisonFigure comparisonFigure(const angle::Comparison& comparison, const ComparisonFigureOptions& options) {
  ComparisonFigure figure;
  const bool maximum = options.error == ErrorMeasure::Maximum;
  const bool bytes = options.storage == StorageMeasure::Bytes;
  figure.spec.title = QStringLiteral("Residual error over storage");
  figure.spec.x.title = bytes ? QStringLiteral("Storage (bytes)") : QStringLiteral("Storage (entries)");
  figure.spec.x.logarithmic = true;
  figure.spec.y.title = maximum ? QStringLiteral("Maximum error (°)") : QStringLiteral("Rms error (°)");
  figure.spec.y.logarithmic = true;
  double smallest = 1e300;
  double largest = 0.0;
  double mostStorage = 4.0;
  std::size_t hidden = 0;
  const std::vector<angle::ComparisonRow>& rows = comparison.rows;
  for (std::size_t first = 0; first < rows.size();) {
    PlotSeries series;
    series.name = methodTitle(rows[first].name.kind, rows[first].name.method);
    series.color = methodColor(rows[first].name.kind, rows[first].name.method);
    series.dashed =
        rows[first].name.method == angle::FitMethod::OnCurve || rows[first].name.method == angle::FitMethod::MidRange;
    std::vector<std::size_t> rowOf;
    std::size_t last = first;
    for (; last < rows.size() && sameMethod(rows[last].name, rows[first].name); ++last) {
      const angle::ComparisonRow& row = rows[last];
      const double error = maximum ? row.maxErrorFineDeg.value_or(row.maxErrorDeg) : row.rmsErrorDeg;
      if (error < smallestErrorShownDeg) {
        ++hidden;
      } else {
        smallest = std::min(smallest, error);
        largest = std::max(largest, error);
      }
      series.x.append(bytes ? row.bytes : row.storageEntries);
      series.y.append(error);
      series.emphasised.append(options.selected && row.name == *options.selected);
      series.pointLabels.append(modelTitle(row.name));
      rowOf.push_back(last);
      mostStorage = std::max(mostStorage, series.x.back());
    }
    // steps of a hundred sizes need no markers; a few powers of two do
    series.style = series.x.size() > 100 ? SeriesStyle::Line : SeriesStyle::LineAndPoints;
    if (!series.emphasised.contains(true)) {
      series.emphasised.clear();
    }
    figure.spec.series.append(series);
    figure.rows.push_back(std::move(rowOf));
    first = last;
  }
  if (!rows.empty()) {
    setRange(figure.spec, std::min(smallest, largest), std::max(largest, smallestErrorShownDeg * 10.0), mostStorage,
             options);
  }
  addGuides(figure.spec, options);
  if (hidden > 0) {
    figure.spec.note = QStringLiteral("%1 models leave less than %2 and lie below the plot")
                           .arg(hidden)
                           .arg(degrees(smallestErrorShownDeg, 1));
  }
  return figure;
}

double budgetOnAxis(int entries, StorageMeasure storage, std::optional<int> bits) {
  if (storage == StorageMeasure::Entries) {
    return entries;
  }
  return bits ? std::ceil(entries * *bits / 8.0) : entries * bytesPerFloat;
}

int budgetFromAxis(double value, StorageMeasure storage, std::optional<int> bits) {
  const double perEntry = storage == StorageMeasure::Entries ? 1.0 : bits ? *bits / 8.0 : bytesPerFloat;
  // a budget is kept, never exceeded: whole entries that fit below the line
  constexpr double rounding = 1e-9;
  return std::max(1, static_cast<int>(std::floor(std::clamp(value / perEntry + rounding, 1.0, 1e6))));
}

} // namespace straightedge::gui
