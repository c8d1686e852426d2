// How an angle document begins, moves and ends.
#include "app/gui/document/angle_document.h"
#include "app/gui/document/angle_document_state.h"
#include "app/gui/document/scratch_folder.h"

#include <QFile>
#include <QFileInfo>

#include <filesystem>
#include <system_error>

namespace straightedge::gui {

namespace {
std::filesystem::path pathOf(const QString& file) { return std::filesystem::path(file.toStdU16String()); }
} // namespace

Result<void> AngleDocument::createScratch() {
  auto place = ScratchFolder::newFile();
  if (!place) {
    return std::unexpected(std::move(place.error()));
  }
  auto session = session::Session::create(pathOf(place->first), session::SessionKind::Angle);
  if (!session) {
    return std::unexpected(std::move(session.error()));
  }
  if (auto closed = close(); !closed) {
    return closed;
  }
  m_impl->adopt(std::move(*session), place->first, std::move(place->second));
  return {};
}

namespace {

struct OpenedSession {
  std::unique_ptr<QLockFile> lock; ///< of a scratch file
  std::unique_ptr<session::Session> session;
};

Result<OpenedSession> openAngleSession(const QString& absolute) {
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
  if ((*session)->kind() != session::SessionKind::Angle) {
    return fail(ErrorKind::Input, "this session is not an angle calibration", "open a session of an angle calibration",
                absolute.toStdString());
  }
  result.session = std::move(*session);
  return result;
}

} // namespace

Result<void> AngleDocument::probe(const QString& file) {
  auto opened = openAngleSession(QFileInfo(file).absoluteFilePath());
  if (!opened) {
    return std::unexpected(std::move(opened.error()));
  }
  return opened->session->close();
}

Result<void> AngleDocument::open(const QString& file) {
  const QString absolute = QFileInfo(file).absoluteFilePath();
  if (isOpen() && absolute == m_impl->file) {
    return {};
  }
  auto opened = openAngleSession(absolute);
  if (!opened) {
    return std::unexpected(std::move(opened.error()));
  }
  if (auto closed = close(); !closed) {
    return closed; // the one that is open could not be written: better to keep it in sight
  }
  m_impl->adopt(std::move(opened->session), absolute, std::move(opened->lock));
  return {};
}

Result<void> AngleDocument::saveAs(const QString& file) {
  const QString target = QFileInfo(file).absoluteFilePath();
  auto* current = m_impl->binding.session();
  if (current == nullptr) {
    return fail(ErrorKind::Usage, "no calibration is open", "open one or start a new one first");
  }
  if (auto written = m_impl->binding.flush(); !written) {
    return written;
  }
  if (target == m_impl->file) {
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
  auto pendingOnReadOnly = m_impl->binding.takePending();
  const QString former = m_impl->file;
  const bool wasScratch = isScratch();
  static_cast<void>(m_impl->binding.close()); // everything it held is in the copy
  if (wasScratch) {
    ScratchFolder::remove(former);
    m_impl->scratchLock.reset();
  }
  m_impl->binding.attach(std::move(*copy));
  m_impl->binding.putPending(std::move(pendingOnReadOnly));
  m_impl->file = target;
  emit titleChanged();
  return m_impl->binding.flush();
}

Result<void> AngleDocument::close() {
  if (!isOpen()) {
    return {};
  }
  if (isScratch() && !hasContent()) {
    return discard();
  }
  if (auto written = m_impl->binding.flush(); !written) {
    return written; // stays open: what could not be written is still here
  }
  auto closed = m_impl->binding.close();
  m_impl->reset();
  return closed;
}

Result<void> AngleDocument::abandon() {
  m_impl->binding.dropPending();
  auto closed = m_impl->binding.close();
  m_impl->reset();
  return closed;
}

Result<void> AngleDocument::discard() {
  const bool scratch = isScratch();
  const QString former = m_impl->file;
  m_impl->binding.dropPending();
  auto closed = m_impl->binding.close();
  if (scratch) {
    ScratchFolder::remove(former); // while its lock is still held
  }
  m_impl->reset();
  return closed;
}

bool AngleDocument::hasContent() const {
  if (m_impl->calibration.sweep->size() > 0 || m_impl->verification->size() > 0 || m_impl->undo.count() > 0 ||
      !m_impl->choicesAreDefault()) {
    return true;
  }
  const auto* session = m_impl->binding.session();
  if (session == nullptr) {
    return false;
  }
  // A count that cannot be read is no proof of emptiness.
  const auto samples = session->angleSampleCount(session::SweepRole::Calibration);
  const auto fresh = session->angleSampleCount(session::SweepRole::Verification);
  return !samples || !fresh || *samples > 0 || *fresh > 0;
}

bool AngleDocument::hasUnsavedState() const {
  if (!isOpen()) {
    return false;
  }
  return m_impl->binding.hasFailed() || m_impl->binding.hasPending() || (isScratch() && hasContent());
}

bool AngleDocument::isReadOnly() const {
  const auto* session = m_impl->binding.session();
  return session != nullptr && session->readOnly();
}

QString AngleDocument::displayName() const {
  if (!isOpen() || isScratch()) {
    return tr("Untitled");
  }
  return QFileInfo(m_impl->file).completeBaseName();
}

} // namespace straightedge::gui
