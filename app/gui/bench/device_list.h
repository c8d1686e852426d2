// The devices that are plugged in, as a list from which they are dragged onto a role.
#pragma once

#include "app/gui/bench/bench_presenter.h"

#include <QListWidget>

namespace straightedge::gui {

class DeviceList : public QListWidget {
  Q_OBJECT
public:
  explicit DeviceList(QWidget* parent = nullptr);

  /// One row a device; the selection stays with its device.
  void setDevices(const std::vector<BenchPresenter::DeviceRow>& rows, const QStringList& keys);
  QString keyAt(int row) const;

  /// What a dragged device is known by.
  static QString mimeType() { return QStringLiteral("application/x-straightedge-device"); }

signals:
  void menuWanted(int row, const QPoint& globalPosition); ///< right click, menu key, Enter

protected:
  QStringList mimeTypes() const override { return {mimeType()}; }
  QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  QSize sizeHint() const override;

private:
  void askForMenu(const QPoint* globalPosition);
};

} // namespace straightedge::gui
