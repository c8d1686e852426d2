#include "app/gui/shell/line_icon.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

#include <utility>

namespace straightedge::gui {

namespace {

class LineIconEngine : public QIconEngine {
public:
  explicit LineIconEngine(QString name) : m_name(std::move(name)) {}

  void paint(QPainter* painter, const QRect& area, QIcon::Mode mode, QIcon::State) override {
    const QPalette palette = QApplication::palette();
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText;
    paintLineIcon(*painter, area, m_name, palette.color(group, role));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return picture;
  }
  QIconEngine* clone() const override { return new LineIconEngine(m_name); }
  QString key() const override { return QStringLiteral("straightedge-line"); }

private:
  QString m_name;
};

} // namespace

QIcon lineIcon(const QString& name) { return QIcon(new LineIconEngine(name)); }

void paintLineIcon(QPainter& painter, const QRectF& area, const QString& name, const QColor& color) {
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) {
    return;
  }
  QByteArray drawing = file.readAll();
  drawing.replace("#000", color.name().toLatin1());
  QSvgRenderer renderer(drawing);
  renderer.setAspectRatioMode(Qt::KeepAspectRatio);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  renderer.render(&painter, area);
  painter.restore();
}

} // namespace straightedge::gui
