// Where unnamed calibrations live until they are saved, so that a crash or "keep for later" loses nothing.
#pragma once

#include "core/base/error.h"

#include <QDateTime>
#include <QList>
#include <QLockFile>
#include <QString>

#include <memory>

namespace straightedge::gui {

/// One folder per user. Each scratch file has a lock beside it while a running Straightedge has it open; a lock left by
/// a program that was killed counts as none.
class ScratchFolder {
public:
  struct Entry {
    QString file;
    QDateTime modified;
  };

  static QString path();
  static bool contains(const QString& file);
  /// A file name that does not exist yet, with its lock taken. Errors: Storage.
  static Result<std::pair<QString, std::unique_ptr<QLockFile>>> newFile();
  /// Takes the lock of a scratch file. Errors: Storage, where another running Straightedge has it open.
  static Result<std::unique_ptr<QLockFile>> lock(const QString& file);
  /// Unsaved calibrations that no running program has open, latest first.
  static QList<Entry> recoverable();
  /// Removes a scratch file and what SQLite keeps beside it.
  static void remove(const QString& file);
};

} // namespace straightedge::gui
