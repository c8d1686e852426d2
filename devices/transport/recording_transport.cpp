#include "devices/transport/recording_transport.h"

#include <filesystem>
#include <utility>

namespace straightedge::devices {

RecordingTransport::RecordingTransport(std::unique_ptr<Transport> inner, DialogueListener listener)
    : m_inner(std::move(inner)), m_listener(std::move(listener)) {}

void RecordingTransport::tell(DialogueMark mark, std::string bytes) {
  if (m_listener) {
    const double timeS = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    m_listener({.timeS = timeS, .mark = mark, .bytes = std::move(bytes), .fault = {}, .line = 0});
  }
}

void RecordingTransport::tell(DialogueMark mark, const TransportError& fault) {
  if (m_listener) {
    const double timeS = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    m_listener({.timeS = timeS, .mark = mark, .bytes = {}, .fault = fault, .line = 0});
  }
}

TransportResult<void> RecordingTransport::write(std::string_view bytes, Milliseconds deadline) {
  tell(DialogueMark::Sent, std::string(bytes));
  auto sent = m_inner->write(bytes, deadline);
  if (!sent) {
    tell(DialogueMark::SendingFailed, sent.error());
  }
  return sent;
}

TransportResult<std::string> RecordingTransport::read(Milliseconds deadline) {
  auto came = m_inner->read(deadline);
  came ? tell(DialogueMark::Received, *came) : tell(DialogueMark::ReceivingFailed, came.error());
  return came;
}

TransportResult<std::string> RecordingTransport::readUntil(std::string_view end, Milliseconds deadline) {
  auto came = m_inner->readUntil(end, deadline);
  came ? tell(DialogueMark::Received, *came) : tell(DialogueMark::ReceivingFailed, came.error());
  return came;
}

TransportResult<void> RecordingTransport::clear() {
  auto cleared = m_inner->clear();
  cleared ? tell(DialogueMark::Cleared, std::string()) : tell(DialogueMark::ClearingFailed, cleared.error());
  return cleared;
}

TransportResult<std::uint8_t> RecordingTransport::statusByte(Milliseconds deadline) {
  auto status = m_inner->statusByte(deadline);
  status ? tell(DialogueMark::Status, std::string(1, static_cast<char>(*status)))
         : tell(DialogueMark::StatusFailed, status.error());
  return status;
}

Result<DialogueFile> DialogueFile::create(const std::string& path, const Transport& transport) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) {
    return fail(ErrorKind::Storage, "the file exists already", "choose another name", path);
  }
  std::ofstream file(path, std::ios::binary);
  file << dialogueHeader(transport) << std::flush;
  if (!file) {
    return fail(ErrorKind::Storage, "the dialogue cannot be written here", "choose another folder", path);
  }
  return DialogueFile(path, std::move(file));
}

void DialogueFile::add(const DialogueEntry& entry) {
  if (m_problem) {
    return;
  }
  m_file << dialogueLine(entry) << std::flush;
  if (!m_file) {
    m_problem = Error{ErrorKind::Storage, "the dialogue is recorded no further: the file cannot be written",
                      "make room on the disk and record anew", m_path};
  }
}

} // namespace straightedge::devices
