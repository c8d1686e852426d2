// The one widget that shows a PlotSpec. Only app/gui/plots knows that VTK draws it.
#pragma once

#include "app/gui/plots/plot_spec.h"

#include <QImage>
#include <QRectF>
#include <QStringList>
#include <QWidget>

#include <memory>
#include <optional>

class QMenu;
class QPainter;

namespace straightedge::gui {

enum class PlotTheme : std::uint8_t { Light, Dark };

/// Paints a plot into a rectangle of the painter (screen, QImage, SVG, PDF: the same code). Any thread, one plot at a
/// time each.
void paintPlot(QPainter& painter, const QRectF& area, const PlotSpec& spec, PlotTheme theme);

/// GUI thread only. Hover shows values of the nearest point; wheel zooms at the cursor; left drag pans, Shift or right
/// drag zooms to a rectangle; double click, Home key or the menu resets; a click on a legend entry switches its series;
/// arrow keys step through points, Return clicks the one that is marked, + and − zoom, keys 1 to 9 switch the legend's
/// entries; context menu: copy picture, copy data, save as PNG, SVG or PDF, reset. The wheel over an axis zooms only
/// it.
class PlotView : public QWidget {
  Q_OBJECT
public:
  explicit PlotView(QWidget* parent = nullptr);
  ~PlotView() override;

  /// Replaces what is shown. Keeps the user's zoom and switched-off series (by name) unless the axes' titles change.
  void setSpec(const PlotSpec& spec);
  const PlotSpec& spec() const;
  /// Live data: appends to series `index` without touching the rest; repaints once per frame at most.
  void appendPoints(int index, const QList<double>& x, const QList<double>& y);
  void setGuideValue(const QString& id, double value);

  QRectF visibleRange() const; ///< in data units: left, top = smallest x and y
  void setVisibleRange(const QRectF& range);
  void resetZoom();

  /// Without a value (the default) the widget's palette decides.
  void setTheme(std::optional<PlotTheme> theme);
  PlotTheme theme() const;
  /// A lens beside the pointer that shows its surroundings eight times larger.
  void setMagnifier(bool on);
  bool magnifier() const;

  QPointF toPixels(double x, double y) const; ///< data -> widget coordinates (for tests and overlays)
  QPointF toData(const QPointF& pixels) const;

  QRectF plotArea() const;                  ///< inside the axes, widget coordinates
  QRectF legendEntryRect(int series) const; ///< empty where the series has none
  QStringList hoverText() const;            ///< lines shown beside the marked point; empty when nothing is marked
  void setSeriesVisible(int series, bool visible);

  QImage picture(const QSize& size, double scale) const;
  bool saveAs(const QString& file, QString* problem) const; ///< .png, .svg, .pdf by extension; false with a sentence
  void copyPicture() const;                                 ///< to the clipboard, in twice the resolution
  void copyData() const; ///< visible series to the clipboard, as tab-separated text and as CSV
  QMenu* makeContextMenu(QWidget* parent);

signals:
  void pointHovered(int series, int index); ///< −1, −1 when nothing is near
  void pointClicked(int series, int index);
  void guideDragged(const QString& id, double value); ///< while dragging
  void guideDropped(const QString& id, double value);
  void visibleRangeChanged(const QRectF& range);
  void seriesToggled(int series, bool visible);
  void pointsSelected(int series, const QList<int>& indices); ///< after a rectangle selection (Ctrl + drag)
  void painted();

protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

private:
  struct Impl;
  friend class PlotInteraction;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
