#include "app/gui/plots/plot_view.h"

#include "app/gui/plots/guides.h"
#include "app/gui/plots/hover_card.h"
#include "app/gui/plots/plot_data_text.h"
#include "app/gui/plots/plot_export.h"
#include "app/gui/plots/plot_painting.h"
#include "app/gui/plots/plot_view_impl.h"
#include "app/gui/plots/theme.h"

#include <QClipboard>
#include <QFileDialog>
#include <QGuiApplication>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace straightedge::gui {

void PlotView::Impl::dataChanged() {
  m_whole.reset();
  windowChanged();
}

void PlotView::Impl::windowChanged() {
  m_layout.reset();
  repaintAll();
}

void PlotView::Impl::repaintAll() {
  m_pictureValid = false;
  view.update();
}

const PlotWindow& PlotView::Impl::whole() {
  if (!m_whole) {
    m_whole = wholeWindow(spec);
  }
  return *m_whole;
}

const PlotWindow& PlotView::Impl::window() { return zoom ? *zoom : whole(); }

const PlotLayout& PlotView::Impl::layout() {
  if (!m_layout || m_layoutSize != view.size()) {
    const QRectF area(QPointF(0.0, 0.0), QSizeF(view.size()));
    m_layout = spec.polar ? layOutFrame(spec, area, PlotFonts::standard())
                          : layOut(spec, window(), area, PlotFonts::standard());
    m_layoutSize = view.size();
    m_pictureValid = false;
  }
  return *m_layout;
}

const QImage& PlotView::Impl::picture(double devicePixelRatio) {
  const PlotLayout& place = layout();
  if (!m_pictureValid || m_picture.devicePixelRatio() != devicePixelRatio) {
    m_picture = paintToImage(view.size(), devicePixelRatio, [&](QPainter& painter, const QRectF& /*area*/) {
      paintFrame(painter, m_scene, spec, window(), place, view.theme(), GuidePainting::LeaveOut);
    });
    m_pictureValid = true;
  }
  return m_picture;
}

void PlotView::Impl::paintOverlay(QPainter& painter) {
  const PlotLayout& place = layout();
  const PlotTheme theme = view.theme();
  if (!spec.polar) {
    paintGuides(painter, spec, window(), place, theme, interaction.hoveredGuide());
    if (magnifier && interaction.pointerInside() && place.plot.contains(interaction.pointer())) {
      paintMagnifier(painter, m_scene, spec, window(), place, interaction.pointer(), theme);
    }
  }
  const QRectF band = interaction.rubberBand();
  if (!band.isEmpty()) {
    paintRubberBand(painter, band, theme);
  }
  if (marked && marked.series < spec.series.size() && spec.series[marked.series].visible) {
    paintHoverCard(painter, marked.pixels, hoverLines(spec, window(), marked),
                   QRectF(view.rect()).adjusted(4, 4, -4, -4),
                   PlotColors::series(spec.series[marked.series].color, theme), theme);
  }
  if (view.hasFocus()) {
    QColor frame = PlotColors::of(theme).selection;
    frame.setAlpha(200);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(frame, 1.0));
    painter.drawRect(view.rect().adjusted(0, 0, -1, -1));
  }
}

void PlotView::Impl::setZoom(const std::optional<PlotWindow>& wanted) {
  const PlotWindow before = window();
  zoom = wanted;
  if (window() == before) {
    return;
  }
  marked = {};
  windowChanged();
  emit view.visibleRangeChanged(view.visibleRange());
}

void PlotView::Impl::mark(const PickedPoint& point) {
  if (point.series == marked.series && point.index == marked.index) {
    return;
  }
  marked = point;
  view.update();
  emit view.pointHovered(marked.series, marked.index);
}

void PlotView::Impl::describeForAccessibility() {
  const QString y = nameAndUnit(spec.y.title).first;
  const QString x = nameAndUnit(spec.x.title).first;
  view.setAccessibleName(!spec.title.isEmpty() ? spec.title
                         : y.isEmpty()         ? PlotView::tr("Plot")
                                               : PlotView::tr("Plot of %1 over %2").arg(y, x));
  QStringList names;
  for (const PlotSeries& series : spec.series) {
    if (!series.name.isEmpty()) {
      names << series.name;
    }
  }
  view.setAccessibleDescription(PlotView::tr("Horizontal: %1. Vertical: %2. Shown: %3.")
                                    .arg(spec.x.title, spec.y.title, names.join(QStringLiteral(", "))));
}

PlotView::PlotView(QWidget* parent) : QWidget(parent), m_impl(std::make_unique<Impl>(*this)) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(120, 90);
  m_impl->describeForAccessibility();
}

PlotView::~PlotView() = default;

void PlotView::setSpec(const PlotSpec& spec) {
  Impl& d = *m_impl;
  const bool sameAxes = spec.x.title == d.spec.x.title && spec.y.title == d.spec.y.title;
  double dragged = 0.0;
  for (const PlotGuide& guide : std::as_const(d.spec.guides)) {
    dragged = guide.id == d.draggedGuide ? guide.value : dragged;
  }
  d.spec = spec;
  if (!sameAxes) {
    d.zoom.reset();
    d.switched.clear();
  }
  for (PlotSeries& series : d.spec.series) {
    series.visible = d.switched.value(series.name, series.visible);
  }
  for (PlotGuide& guide : d.spec.guides) {
    if (!d.draggedGuide.isEmpty() && guide.id == d.draggedGuide) {
      guide.value = dragged;
    }
  }
  d.marked = {};
  d.describeForAccessibility();
  d.dataChanged();
}

const PlotSpec& PlotView::spec() const { return m_impl->spec; }

void PlotView::appendPoints(int index, const QList<double>& x, const QList<double>& y) {
  if (index < 0 || index >= m_impl->spec.series.size() || x.size() != y.size()) {
    return;
  }
  PlotSeries& series = m_impl->spec.series[index];
  series.x.append(x);
  series.y.append(y);
  m_impl->dataChanged();
}

void PlotView::setGuideValue(const QString& id, double value) {
  for (PlotGuide& guide : m_impl->spec.guides) {
    if (guide.id == id && id != m_impl->draggedGuide) {
      guide.value = value;
    }
  }
  update();
}

QRectF PlotView::visibleRange() const {
  const PlotWindow& window = m_impl->window();
  return {window.x.minimum, window.y.minimum, window.x.span(), window.y.span()};
}

void PlotView::setVisibleRange(const QRectF& range) {
  PlotWindow window = m_impl->whole();
  const auto usable = [](double low, double high, const AxisScale& scale) {
    return low < high && (!scale.logarithmic || low > 0.0);
  };
  if (!usable(range.left(), range.right(), window.x) || !usable(range.top(), range.bottom(), window.y)) {
    return;
  }
  // The right axis follows the left one.
  const AxisScale left = window.y;
  window.right = window.right.part(left.toUnit(range.top()), left.toUnit(range.bottom()));
  window.x = AxisScale{range.left(), range.right(), window.x.logarithmic};
  window.y = AxisScale{range.top(), range.bottom(), window.y.logarithmic};
  m_impl->setZoom(window);
}

void PlotView::resetZoom() { m_impl->setZoom(std::nullopt); }

void PlotView::setTheme(std::optional<PlotTheme> theme) {
  m_impl->chosenTheme = theme;
  m_impl->repaintAll();
}

PlotTheme PlotView::theme() const {
  if (m_impl->chosenTheme) {
    return *m_impl->chosenTheme;
  }
  return palette().color(QPalette::Window).lightness() < 128 ? PlotTheme::Dark : PlotTheme::Light;
}

void PlotView::setMagnifier(bool on) {
  m_impl->magnifier = on;
  update();
}

bool PlotView::magnifier() const { return m_impl->magnifier; }

QPointF PlotView::toPixels(double x, double y) const { return m_impl->layout().toPixels(m_impl->window(), x, y); }

QPointF PlotView::toData(const QPointF& pixels) const { return m_impl->layout().toData(m_impl->window(), pixels); }

QRectF PlotView::plotArea() const { return m_impl->layout().plot; }

QRectF PlotView::legendEntryRect(int series) const {
  for (const LegendEntry& entry : m_impl->layout().legend) {
    if (entry.series == series) {
      return entry.rect;
    }
  }
  return {};
}

QStringList PlotView::hoverText() const { return hoverLines(m_impl->spec, m_impl->window(), m_impl->marked); }

void PlotView::setSeriesVisible(int series, bool visible) {
  if (series < 0 || series >= m_impl->spec.series.size() || m_impl->spec.series[series].visible == visible) {
    return;
  }
  m_impl->spec.series[series].visible = visible;
  m_impl->switched[m_impl->spec.series[series].name] = visible;
  m_impl->marked = {};
  m_impl->dataChanged();
  emit seriesToggled(series, visible);
}

QImage PlotView::picture(const QSize& size, double scale) const {
  const auto paint = [this](QPainter& painter, const QRectF& area) {
    ChartScene scene;
    const PlotSpec& spec = m_impl->spec;
    const PlotWindow& window = m_impl->window();
    const PlotFonts fonts = PlotFonts::standard();
    const PlotLayout layout = spec.polar ? layOutFrame(spec, area, fonts) : layOut(spec, window, area, fonts);
    paintFrame(painter, scene, spec, window, layout, theme(), GuidePainting::Include);
  };
  return paintToImage(size, scale, paint);
}

bool PlotView::saveAs(const QString& file, QString* problem) const {
  // Files are for paper: always the light theme, in the proportions of the screen.
  const auto paint = [this](QPainter& painter, const QRectF& area) {
    ChartScene scene;
    const PlotSpec& spec = m_impl->spec;
    const PlotWindow& window = m_impl->window();
    const PlotFonts fonts = PlotFonts::standard();
    const PlotLayout layout = spec.polar ? layOutFrame(spec, area, fonts) : layOut(spec, window, area, fonts);
    paintFrame(painter, scene, spec, window, layout, PlotTheme::Light, GuidePainting::Include);
  };
  const QSize paper = size().expandedTo({480, 320});
  return paintToFile(file, paper, m_impl->spec.title, paint, problem);
}

void PlotView::copyPicture() const { QGuiApplication::clipboard()->setImage(picture(size(), 2.0)); }

void PlotView::copyData() const {
  auto* table = new QMimeData; // the clipboard takes it
  table->setText(dataAsText(m_impl->spec, u'\t'));
  table->setData(QStringLiteral("text/csv"), dataAsText(m_impl->spec, u',').toUtf8());
  QGuiApplication::clipboard()->setMimeData(table);
}

QMenu* PlotView::makeContextMenu(QWidget* parent) {
  auto* menu = new QMenu(parent);
  const auto add = [menu](const QString& text, const QString& name, auto action) {
    QAction* entry = menu->addAction(text);
    entry->setObjectName(name);
    connect(entry, &QAction::triggered, menu, action);
    return entry;
  };
  add(tr("Copy &picture"), QStringLiteral("copyPicture"), [this] { copyPicture(); });
  add(tr("Copy &data"), QStringLiteral("copyData"), [this] { copyData(); });
  add(tr("&Save as PNG, SVG or PDF…"), QStringLiteral("save"), [this] {
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Save plot"), QString(), tr("PNG picture (*.png);;SVG drawing (*.svg);;PDF document (*.pdf)"));
    QString problem;
    if (!file.isEmpty() && !saveAs(file, &problem)) {
      QMessageBox::warning(this, tr("Save plot"), problem);
    }
  });
  menu->addSeparator();
  add(tr("&Reset zoom"), QStringLiteral("resetZoom"), [this] { resetZoom(); })->setEnabled(m_impl->zoom.has_value());
  QMenu* shown = menu->addMenu(tr("S&how"));
  for (int i = 0; i < m_impl->spec.series.size(); ++i) {
    const PlotSeries& series = m_impl->spec.series[i];
    if (!series.name.isEmpty()) {
      QAction* entry = shown->addAction(QString(series.name).replace(u'&', QStringLiteral("&&")));
      entry->setCheckable(true);
      entry->setChecked(series.visible);
      connect(entry, &QAction::toggled, this, [this, i](bool on) { setSeriesVisible(i, on); });
    }
  }
  shown->menuAction()->setVisible(!shown->isEmpty());
  return menu;
}

void PlotView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.drawImage(QPointF(0.0, 0.0), m_impl->picture(devicePixelRatioF()));
  m_impl->paintOverlay(painter);
  painter.end();
  emit painted();
}

bool PlotView::event(QEvent* event) {
  PlotInteraction& interaction = m_impl->interaction;
  switch (event->type()) {
  case QEvent::MouseButtonPress:
    interaction.press(*static_cast<QMouseEvent*>(event));
    break;
  case QEvent::MouseMove:
    interaction.move(*static_cast<QMouseEvent*>(event));
    break;
  case QEvent::MouseButtonRelease:
    interaction.release(*static_cast<QMouseEvent*>(event));
    break;
  case QEvent::MouseButtonDblClick:
    interaction.doubleClick(*static_cast<QMouseEvent*>(event));
    break;
  case QEvent::Wheel:
    interaction.wheel(*static_cast<QWheelEvent*>(event));
    break;
  case QEvent::KeyPress:
    if (!interaction.key(*static_cast<QKeyEvent*>(event))) {
      return QWidget::event(event);
    }
    break;
  case QEvent::Leave:
    interaction.leave();
    return QWidget::event(event);
  case QEvent::ContextMenu: // the right button is ours; this is for the menu key
    if (static_cast<QContextMenuEvent*>(event)->reason() == QContextMenuEvent::Keyboard) {
      interaction.showMenu(mapToGlobal(rect().center()));
    }
    break;
  case QEvent::FontChange:
  case QEvent::ApplicationFontChange:
  case QEvent::PaletteChange:
  case QEvent::ApplicationPaletteChange:
    m_impl->windowChanged();
    return QWidget::event(event);
  default:
    return QWidget::event(event);
  }
  event->accept();
  return true;
}

} // namespace straightedge::gui
