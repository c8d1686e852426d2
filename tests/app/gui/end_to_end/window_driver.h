// Works the real window as a person would: by mouse and keyboard, finding things by their names.
#pragma once

#include "app/gui/plots/plot_view.h"
#include "app/gui/shell/main_window.h"

#include <QAbstractButton>
#include <QPointF>
#include <QString>

namespace straightedge::gui {

class WindowDriver {
public:
  explicit WindowDriver(MainWindow& window) : m_window(window) {}

  /// The visible child of that name; ends the program with its name where there is none.
  template <typename T>
  T* find(const QString& name) const {
    for (T* child : m_window.findChildren<T*>(name)) {
      if (child->isVisible()) {
        return child;
      }
    }
    qFatal("no visible %s", qPrintable(name));
    return nullptr;
  }
  bool isShown(const QString& name) const;

  void click(const QString& buttonName);
  void step(const QString& title); ///< by the rail at the left
  void typeNumber(const QString& boxName, const QString& text);
  void typeText(const QString& fieldName, const QString& text);
  /// Picks the entry by keyboard; ends the program where there is none.
  void choose(const QString& comboName, const QString& entry);
  void undo(); ///< Ctrl+Z

  /// Clicks a plotted point.
  void clickPoint(PlotView& plot, int series, int index);
  /// Drags a horizontal guide to a value.
  void dragGuide(PlotView& plot, const QString& id, double toValue);

private:
  MainWindow& m_window;
};

} // namespace straightedge::gui
