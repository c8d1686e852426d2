#include "app/gui/figures/model_figures.h"

#include "app/gui/figures/figure_parts.h"
#include "core/angle/angles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace straightedge::gui {

using angle::FitMethod;
using angle::ModelKind;
using angle::ModelName;

namespace {

/// Smooth models are drawn with this many points a turn: a tenth of a degree of the eleventh harmonic is 1/3 pixel.
constexpr int drawnPoints = 1440;

PlotSeries curveSeries(const angle::CorrectionCurve& curve) {
  PlotSeries line;
  line.name = QStringLiteral("Correction curve");
  line.color = SeriesColor::Reference;
  line.x.reserve(angle::gridSize + 1);
  for (int i = 0; i <= angle::gridSize; ++i) {
    line.x.append(i * 360.0 / angle::gridSize);
  }
  line.y = toList(curve.gridDeg);
  line.y.append(curve.gridDeg[0]);
  return line;
}

PlotSpec correctionSpec(const QString& title, angle::SensorDirection direction) {
  PlotSpec spec;
  spec.title = title;
  spec.x = turnAxis(readingTitle(direction));
  spec.y.title = QStringLiteral("Correction (°)");
  return spec;
}

/// Error that remains at every recorded point, sorted by encoder angle.
PlotSeries remainingAtPoints(const angle::Model& model, const angle::AlignedSweep& aligned) {
  std::vector<std::pair<double, double>> points;
  points.reserve(static_cast<std::size_t>(aligned.readingDeg.size()));
  for (Eigen::Index i = 0; i < aligned.readingDeg.size(); ++i) {
    points.emplace_back(aligned.encoderDeg[i],
                        angle::wrap180(model.correctionDeg(aligned.readingDeg[i]) - aligned.correctionDeg[i]));
  }
  std::ranges::sort(points);
  PlotSeries series;
  series.name = modelTitle(model.name);
  series.style = points.size() > 200 ? SeriesStyle::Points : SeriesStyle::LineAndPoints;
  for (const auto& [encoderDeg, errorDeg] : points) {
    series.x.append(encoderDeg);
    series.y.append(errorDeg);
  }
  return series;
}

} // namespace

PlotSeries modelSeries(const angle::Model& model, SeriesColor color) {
  PlotSeries series;
  series.name = modelTitle(model.name);
  series.color = color;
  const auto addValues = [&series](const Eigen::VectorXd& values) {
    for (Eigen::Index k = 0; k <= values.size(); ++k) {
      series.x.append(static_cast<double>(k) * 360.0 / static_cast<double>(values.size()));
      series.y.append(values[k % values.size()]);
    }
  };
  if (const auto* linear = std::get_if<angle::LinearModel>(&model.body)) {
    addValues(linear->valuesDeg);
  } else if (const auto* table = std::get_if<angle::LookupTableModel>(&model.body)) {
    addValues(table->valuesDeg);
    series.y.back() = table->valuesDeg[table->valuesDeg.size() - 1]; // the last entry serves up to 360°
    series.style = SeriesStyle::Steps;
  } else {
    for (int i = 0; i <= drawnPoints; ++i) {
      series.x.append(i * 360.0 / drawnPoints);
      series.y.append(model.correctionDeg(series.x.back()));
    }
  }
  return series;
}

PlotSpec curveWithModelsFigure(const std::vector<angle::Model>& models, const angle::AlignedSweep* aligned,
                               const angle::CorrectionCurve* curve, angle::SensorDirection direction) {
  PlotSpec spec = correctionSpec(QStringLiteral("Correction curve and models"), direction);
  if (aligned != nullptr) {
    PlotSeries points;
    points.name = QStringLiteral("Recorded points");
    points.style = SeriesStyle::Points;
    points.color = SeriesColor::Muted;
    points.x = toList(aligned->readingDeg);
    points.y = toList(aligned->correctionDeg);
    spec.series.append(points);
  }
  if (curve != nullptr) {
    spec.series.append(curveSeries(*curve));
    spec.note = QStringLiteral("Leave-one-out error of the curve: %1 rms, %2 at most")
                    .arg(degrees(curve->leaveOneOutRmsDeg, 3), degrees(curve->leaveOneOutMaxDeg, 3));
  }
  for (std::size_t i = 0; i < models.size(); ++i) {
    spec.series.append(modelSeries(models[i], seriesColor(static_cast<int>(i))));
  }
  return spec;
}

PlotSpec residualFigure(const std::vector<angle::Model>& models, const angle::CorrectionCurve& curve,
                        angle::SensorDirection direction) {
  PlotSpec spec;
  spec.title = QStringLiteral("Residual: model minus curve");
  spec.x = turnAxis(readingTitle(direction));
  spec.y.title = QStringLiteral("Residual (°)");
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Eigen::VectorXd residual = models[i].correctionOnGrid() - curve.gridDeg;
    PlotSeries series;
    series.name = modelTitle(models[i].name);
    series.color = seriesColor(static_cast<int>(i));
    series.x.reserve(residual.size());
    for (Eigen::Index k = 0; k < residual.size(); ++k) {
      series.x.append(static_cast<double>(k) * 360.0 / angle::gridSize);
    }
    series.y = toList(residual);
    spec.series.append(series);
  }
  return spec;
}

PlotSpec pointResidualFigure(const std::vector<angle::Model>& models, const angle::AlignedSweep& aligned) {
  PlotSpec spec;
  spec.title = QStringLiteral("Error that remains at the recorded points");
  spec.x = turnAxis(QStringLiteral("Encoder angle (°)"));
  spec.y.title = QStringLiteral("Error after correction (°)");
  for (std::size_t i = 0; i < models.size(); ++i) {
    PlotSeries series = remainingAtPoints(models[i], aligned);
    series.color = seriesColor(static_cast<int>(i));
    spec.series.append(series);
  }
  return spec;
}

std::vector<ModelName> growingFamily(GrowingFamily family, const angle::CorrectionCurve& curve) {
  std::vector<ModelName> names;
  const auto add = [&names](ModelKind kind, std::initializer_list<int> sizes) {
    for (const int size : sizes) {
      names.push_back({.kind = kind, .size = size, .method = angle::defaultMethod(kind), .bits = {}});
    }
  };
  switch (family) {
  case GrowingFamily::Harmonics:
    add(ModelKind::Harmonic, {1, 2, 4, 8, 16});
    std::erase_if(names, [&curve](const ModelName& name) { return name.size > curve.resolvableHarmonics; });
    break;
  case GrowingFamily::Segments:
    add(ModelKind::Linear, {8, 16, 32, 64});
    break;
  case GrowingFamily::TableEntries:
    add(ModelKind::LookupTable, {32, 64, 128, 256});
    break;
  }
  return names;
}

PlotSpec growingFamilyFigure(GrowingFamily family, const angle::AlignedSweep& aligned,
                             const angle::CorrectionCurve& curve) {
  static const std::array titles{QStringLiteral("Error that remains with a growing number of harmonics"),
                                 QStringLiteral("Error that remains with a growing number of segments"),
                                 QStringLiteral("Error that remains with a growing number of table entries")};
  PlotSpec spec;
  spec.title = titles.at(static_cast<std::size_t>(family));
  spec.x = turnAxis(QStringLiteral("Encoder angle (°)"));
  spec.y.title = QStringLiteral("Error after correction (°)");
  QStringList maxima;
  for (const ModelName& name : growingFamily(family, curve)) {
    const Result<angle::Model> model = angle::fitModel(curve, name);
    if (!model) {
      continue; // a size the data do not carry is left out of the family
    }
    PlotSeries series = remainingAtPoints(*model, aligned);
    series.color = seriesColor(static_cast<int>(spec.series.size()));
    double largest = 0.0;
    for (const double value : series.y) {
      largest = std::max(largest, std::abs(value));
    }
    maxima.append(QStringLiteral("%1: %2").arg(name.size).arg(degrees(largest, 3)));
    spec.series.append(series);
  }
  spec.note = QStringLiteral("Largest error at the points by size: ") + maxima.join(QStringLiteral(", "));
  return spec;
}

PlotSpec linearMethodsFigure(const angle::CorrectionCurve& curve, int segments, angle::SensorDirection direction) {
  PlotSpec spec = correctionSpec(QStringLiteral("Linear interpolation with %1 segments").arg(segments), direction);
  spec.series.append(curveSeries(curve));
  QStringList maxima;
  for (const FitMethod method : {FitMethod::OnCurve, FitMethod::LeastSquares, FitMethod::Minimax}) {
    const Result<angle::Model> model =
        angle::fitModel(curve, {.kind = ModelKind::Linear, .size = segments, .method = method, .bits = {}});
    if (!model) {
      continue;
    }
    PlotSeries series = modelSeries(*model, methodColor(ModelKind::Linear, method));
    series.style = segments > 128 ? SeriesStyle::Line : SeriesStyle::LineAndPoints;
    series.name = methodTitle(ModelKind::Linear, method);
    maxima.append(QStringLiteral("%1 %2").arg(QString::fromLatin1(angle::methodText(method)),
                                              degrees(model->errors.maxCurveDeg, 3)));
    spec.series.append(series);
  }
  spec.note = QStringLiteral("Largest residual: ") + maxima.join(QStringLiteral(", "));
  return spec;
}

PlotSpec tableStepsFigure(const angle::CorrectionCurve& curve, int entries, angle::SensorDirection direction) {
  PlotSpec spec = correctionSpec(QStringLiteral("Lookup table with %1 entries").arg(entries), direction);
  spec.series.append(curveSeries(curve));
  const Result<angle::Model> model =
      angle::fitModel(curve, {.kind = ModelKind::LookupTable, .size = entries, .method = FitMethod::Mean, .bits = {}});
  if (model) {
    spec.series.append(modelSeries(*model, methodColor(ModelKind::LookupTable, FitMethod::Mean)));
    spec.note = QStringLiteral("Largest residual %1, %2 rms")
                    .arg(degrees(model->errors.maxCurveDeg), degrees(model->errors.rmsCurveDeg));
  }
  return spec;
}

} // namespace straightedge::gui
