#include "app/gui/shell/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace straightedge::gui {

namespace {
const QString filesKey = QStringLiteral("recentFiles");

void store(const QStringList& files) {
  QSettings settings;
  settings.setValue(filesKey, files);
}
} // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {}

QStringList RecentFiles::files() const { return QSettings().value(filesKey).toStringList(); }

void RecentFiles::add(const QString& file) {
  const QString absolute = QFileInfo(file).absoluteFilePath();
  QStringList list = files();
  list.removeAll(absolute);
  list.prepend(absolute);
  store(list.mid(0, maximum));
  emit changed();
}

void RecentFiles::remove(const QString& file) {
  QStringList list = files();
  if (list.removeAll(file) > 0) {
    store(list);
    emit changed();
  }
}

} // namespace straightedge::gui
