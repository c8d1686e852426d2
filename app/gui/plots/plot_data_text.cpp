#include "app/gui/plots/plot_data_text.h"

#include "core/base/number_text.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {
namespace {

QString cell(const QList<double>& values, qsizetype row) {
  if (row >= values.size() || std::isnan(values[row])) {
    return {};
  }
  return QString::fromStdString(formatDouble(values[row]));
}

QString quoted(const QString& text, QChar separator) {
  if (!text.contains(separator) && !text.contains(u'"') && !text.contains(u'\n')) {
    return text;
  }
  QString inner = text;
  return u'"' + inner.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

/// The same positions, NaN counting as equal to NaN.
bool same(const QList<double>& a, const QList<double>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](double p, double q) {
           return p == q || (std::isnan(p) && std::isnan(q));
         });
}

} // namespace

QString dataAsText(const PlotSpec& spec, QChar separator) {
  QStringList header;
  QList<const QList<double>*> columns;
  const QList<double>* lastX = nullptr;
  for (const PlotSeries& series : spec.series) {
    if (!series.visible) {
      continue;
    }
    if (lastX == nullptr || !same(*lastX, series.x)) {
      header << quoted(spec.x.title, separator);
      columns << &series.x;
      lastX = &series.x;
    }
    const PlotAxis& y = series.rightAxis && spec.right ? *spec.right : spec.y;
    header << quoted(series.name.isEmpty() ? y.title : series.name, separator);
    columns << &series.y;
  }
  qsizetype rows = 0;
  for (const auto* column : columns) {
    rows = std::max(rows, column->size());
  }
  QString text = header.join(separator) + u'\n';
  for (qsizetype row = 0; row < rows; ++row) {
    for (qsizetype c = 0; c < columns.size(); ++c) {
      if (c > 0) {
        text += separator;
      }
      text += cell(*columns[c], row);
    }
    text += u'\n';
  }
  return text;
}

} // namespace straightedge::gui
