#include "tests/app/gui/end_to_end/window_driver.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QTest>

namespace straightedge::gui {

bool WindowDriver::isShown(const QString& name) const {
  const auto children = m_window.findChildren<QWidget*>(name);
  return std::any_of(children.begin(), children.end(), [](const QWidget* child) { return child->isVisible(); });
}

void WindowDriver::click(const QString& buttonName) {
  auto* button = find<QAbstractButton>(buttonName);
  if (!button->isEnabled()) {
    qFatal("%s is not enabled", qPrintable(buttonName));
  }
  QTest::mouseClick(button, Qt::LeftButton);
}

void WindowDriver::step(const QString& title) { click(QStringLiteral("step") + title); }

void WindowDriver::typeNumber(const QString& boxName, const QString& text) {
  auto* box = find<QAbstractSpinBox>(boxName);
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, text);
  QTest::keyClick(box, Qt::Key_Return);
}

void WindowDriver::typeText(const QString& fieldName, const QString& text) {
  auto* field = find<QLineEdit>(fieldName);
  QTest::mouseClick(field, Qt::LeftButton);
  field->selectAll();
  QTest::keyClicks(field, text);
  QTest::keyClick(field, Qt::Key_Return);
}

void WindowDriver::choose(const QString& comboName, const QString& entry) {
  auto* combo = find<QComboBox>(comboName);
  const int wanted = combo->findText(entry, Qt::MatchStartsWith);
  if (wanted < 0) {
    qFatal("%s has no entry %s", qPrintable(comboName), qPrintable(entry));
  }
  combo->setFocus();
  QTest::keyClick(combo, Qt::Key_Home);
  for (int i = 0; i < wanted; ++i) {
    QTest::keyClick(combo, Qt::Key_Down);
  }
}

void WindowDriver::undo() { QTest::keyClick(&m_window, Qt::Key_Z, Qt::ControlModifier); }

void WindowDriver::clickPoint(PlotView& plot, int series, int index) {
  const PlotSeries& shown = plot.spec().series[series];
  const QPoint at = plot.toPixels(shown.x[index], shown.y[index]).toPoint();
  QTest::mouseMove(&plot, at);
  QTest::mouseClick(&plot, Qt::LeftButton, {}, at);
}

void WindowDriver::dragGuide(PlotView& plot, const QString& id, double toValue) {
  for (const PlotGuide& guide : plot.spec().guides) {
    if (guide.id != id) {
      continue;
    }
    const double x = plot.width() * 0.6; // anywhere along the line
    const double unused = plot.toData(QPointF(x, plot.height() * 0.5)).x();
    const QPoint from(static_cast<int>(x), qRound(plot.toPixels(unused, guide.value).y()));
    const QPoint to(static_cast<int>(x), qRound(plot.toPixels(unused, toValue).y()));
    QTest::mouseMove(&plot, from);
    QTest::mousePress(&plot, Qt::LeftButton, {}, from);
    QTest::mouseMove(&plot, (from + to) / 2);
    QTest::mouseMove(&plot, to);
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, to);
    return;
  }
  qFatal("no guide %s", qPrintable(id));
}

} // namespace straightedge::gui
