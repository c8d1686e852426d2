// How a document begins, moves and ends.
#include "app/gui/document/calibration_document.h"
#include "app/gui/document/calibration_document_state.h"
#include "app/gui/document/scratch_folder.h"

#include <QFile>
#include <QFileInfo>

#include <filesystem>
#include <system_error>

namespace straightedge::gui {

namespace {
std::filesystem::path pathOf(const QString& file) { return std::filesystem::path(file.toStdU16String()); }
} // namespace

Result<void> CalibrationDocument::createScratch() {
  auto place = ScratchFolder::newFile();
  if (!place) {
    return std::unexpected(std::move(place.error()));
  }
  auto session = session::Session::create(pathOf(place->first), kind());
  if (!session) {
    return std::unexpected(std::move(session.error()));
  }
  if (auto closed = close(); !closed) {
    return closed;
  }
  adopt(std::move(*session), place->first, std::move(place->second));
  return {};
}

namespace {

struct OpenedSession {
  std::unique_ptr<QLockFile> lock; ///< of a scratch file
  std::unique_ptr<session::Session> session;
};

Result<OpenedSession> openedSession(const QString& absolute) {
  OpenedSession result;
  if (ScratchFolder::contains(absolute)) {
    auto taken = ScratchFolder::lock(absolute);
    if (!taken) {
      return std::unexpected(std::move(taken.error()));
    }
    result.lock = std::move(*taken);
  }
  auto session = session::Session::open(pathOf(absolute));
  if (!session) {
    return std::unexpected(std::move(session.error()));
  }
  result.session = std::move(*session);
  return result;
}

std::unexpected<Error> otherKind(session::SessionKind wanted, const QString& file) {
  const std::string name = wanted == session::SessionKind::Angle ? "an angle" : "a field";
  return fail(ErrorKind::Input, "this session is not " + name + " calibration",
              "open a session of " + name + " calibration", file.toStdString());
}

} // namespace

Result<session::SessionKind> CalibrationDocument::probe(const QString& file) {
  auto opened = openedSession(QFileInfo(file).absoluteFilePath());
  if (!opened) {
    return std::unexpected(std::move(opened.error()));
  }
  const session::SessionKind kind = opened->session->kind();
  if (auto closed = opened->session->close(); !closed) {
    return std::unexpected(std::move(closed.error()));
  }
  return kind;
}

Result<void> CalibrationDocument::open(const QString& file) {
  const QString absolute = QFileInfo(file).absoluteFilePath();
  if (isOpen() && absolute == m_life->file) {
    return {};
  }
  auto opened = openedSession(absolute);
  if (!opened) {
    return std::unexpected(std::move(opened.error()));
  }
  if (opened->session->kind() != kind()) {
    return otherKind(kind(), absolute);
  }
  if (auto closed = close(); !closed) {
    return closed; // the one that is open could not be written: better to keep it in sight
  }
  adopt(std::move(opened->session), absolute, std::move(opened->lock));
  return {};
}

Result<void> CalibrationDocument::saveAs(const QString& file) {
  const QString target = QFileInfo(file).absoluteFilePath();
  auto* current = m_life->binding.session();
  if (current == nullptr) {
    return fail(ErrorKind::Usage, "no calibration is open", "open one or start a new one first");
  }
  if (auto written = m_life->binding.flush(); !written) {
    return written;
  }
  if (target == m_life->file) {
    return {};
  }
  // Copied under another name first: a full disk must not cost the file that is replaced.
  const QString part = target + ".part";
  ScratchFolder::remove(part);
  if (auto copied = current->copyTo(pathOf(part)); !copied) {
    ScratchFolder::remove(part);
    return copied;
  }
  std::error_code problem;
  std::filesystem::rename(pathOf(part), pathOf(target), problem);
  if (problem) {
    ScratchFolder::remove(part);
    return fail(ErrorKind::Storage, "cannot write the file: " + problem.message(),
                "choose another folder or check its permissions", target.toStdString());
  }
  for (const char* suffix : {"-wal", "-shm"}) {
    QFile::remove(target + suffix); // of the file that was replaced
  }
  auto copy = session::Session::open(pathOf(target));
  if (!copy) {
    return std::unexpected(std::move(copy.error()));
  }
  auto pendingOnReadOnly = m_life->binding.takePending();
  const QString former = m_life->file;
  const bool wasScratch = isScratch();
  static_cast<void>(m_life->binding.close()); // everything it held is in the copy
  if (wasScratch) {
    ScratchFolder::remove(former);
    m_life->scratchLock.reset();
  }
  m_life->binding.attach(std::move(*copy));
  m_life->binding.putPending(std::move(pendingOnReadOnly));
  m_life->file = target;
  emit titleChanged();
  return m_life->binding.flush();
}

Result<void> CalibrationDocument::close() {
  if (!isOpen()) {
    return {};
  }
  if (isScratch() && !hasContent()) {
    return discard();
  }
  if (auto written = m_life->binding.flush(); !written) {
    return written; // stays open: what could not be written is still here
  }
  auto closed = m_life->binding.close();
  forget();
  return closed;
}

Result<void> CalibrationDocument::abandon() {
  m_life->binding.dropPending();
  auto closed = m_life->binding.close();
  forget();
  return closed;
}

Result<void> CalibrationDocument::discard() {
  const bool scratch = isScratch();
  const QString former = m_life->file;
  m_life->binding.dropPending();
  auto closed = m_life->binding.close();
  if (scratch) {
    ScratchFolder::remove(former); // while its lock is still held
  }
  forget();
  return closed;
}

bool CalibrationDocument::hasContent() const { return m_life->undo.count() > 0 || holdsContent(); }

bool CalibrationDocument::hasUnsavedState() const {
  if (!isOpen()) {
    return false;
  }
  return m_life->binding.hasFailed() || m_life->binding.hasPending() || (isScratch() && hasContent());
}

bool CalibrationDocument::isReadOnly() const {
  const auto* session = m_life->binding.session();
  return session != nullptr && session->readOnly();
}

QString CalibrationDocument::displayName() const {
  if (!isOpen() || isScratch()) {
    return tr("Untitled");
  }
  return QFileInfo(m_life->file).completeBaseName();
}

} // namespace straightedge::gui
