// The files opened last, kept in the user's settings.
#pragma once

#include <QObject>
#include <QStringList>

namespace straightedge::gui {

class RecentFiles : public QObject {
  Q_OBJECT
public:
  static constexpr qsizetype maximum = 12;

  explicit RecentFiles(QObject* parent = nullptr);
  QStringList files() const; ///< absolute, latest first; files that are gone stay listed until removed
  void add(const QString& file);
  void remove(const QString& file);

signals:
  void changed();
};

} // namespace straightedge::gui
