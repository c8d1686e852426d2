#include "app/gui/document/scratch_folder.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

namespace straightedge::gui {

namespace {
std::unique_ptr<QLockFile> lockOf(const QString& file) {
  auto lock = std::make_unique<QLockFile>(file + ".lock");
  lock->setStaleLockTime(0); // a capture may run for days; only a process that is gone makes a lock stale
  return lock;
}
} // namespace

QString ScratchFolder::path() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/unsaved";
}

bool ScratchFolder::contains(const QString& file) {
  return QFileInfo(file).absolutePath() == QFileInfo(path()).absoluteFilePath();
}

Result<std::pair<QString, std::unique_ptr<QLockFile>>> ScratchFolder::newFile() {
  const QDir folder(path());
  if (!folder.mkpath(".")) {
    return fail(ErrorKind::Storage, "cannot create the folder for unsaved calibrations",
                "check the permissions and the free space of your home folder", path().toStdString());
  }
  const QString stem = QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss");
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const QString name = attempt == 0 ? stem : QString("%1-%2").arg(stem).arg(attempt);
    const QString file = folder.absoluteFilePath(name + ".sedge");
    if (QFile::exists(file)) {
      continue;
    }
    auto lock = lockOf(file);
    if (lock->tryLock(0)) {
      return std::pair{file, std::move(lock)};
    }
    if (lock->error() != QLockFile::LockFailedError) {
      break; // not taken by somebody else: the folder itself does not accept files
    }
  }
  return fail(ErrorKind::Storage, "cannot create a file for an unsaved calibration",
              "check the permissions and the free space of your home folder", path().toStdString());
}

Result<std::unique_ptr<QLockFile>> ScratchFolder::lock(const QString& file) {
  auto lock = lockOf(file);
  if (!lock->tryLock(0)) {
    return fail(ErrorKind::Storage, "this unsaved calibration is open in another window of Straightedge",
                "go on there, or close it first", file.toStdString());
  }
  return lock;
}

QList<ScratchFolder::Entry> ScratchFolder::recoverable() {
  QList<Entry> entries;
  const auto files = QDir(path()).entryInfoList({"*.sedge"}, QDir::Files, QDir::Time);
  for (const QFileInfo& info : files) {
    if (lockOf(info.absoluteFilePath())->tryLock(0)) { // released at once: the list only shows
      entries.append({info.absoluteFilePath(), info.lastModified()});
    }
  }
  return entries;
}

void ScratchFolder::remove(const QString& file) {
  for (const char* suffix : {"", "-wal", "-shm", "-journal"}) {
    QFile::remove(file + suffix);
  }
}

} // namespace straightedge::gui
