// Records what goes over a transport, for a console and for a file.
#pragma once

#include "devices/transport/dialogue.h"

#include <chrono>
#include <fstream>
#include <functional>
#include <memory>

namespace straightedge::devices {

/// Called in the transport's thread, after each exchange.
using DialogueListener = std::function<void(const DialogueEntry&)>;

/// Owns the transport that it passes everything on to. Adds nothing and keeps nothing back.
class RecordingTransport : public Transport {
public:
  RecordingTransport(std::unique_ptr<Transport> inner, DialogueListener listener);

  std::string name() const override { return m_inner->name(); }
  bool hasMessages() const override { return m_inner->hasMessages(); }
  TransportResult<void> write(std::string_view bytes, Milliseconds deadline) override;
  TransportResult<std::string> read(Milliseconds deadline) override;
  TransportResult<std::string> readUntil(std::string_view end, Milliseconds deadline) override;
  TransportResult<void> clear() override;
  TransportResult<std::uint8_t> statusByte(Milliseconds deadline) override;

private:
  void tell(DialogueMark mark, std::string bytes);
  void tell(DialogueMark mark, const TransportError& fault);

  std::unique_ptr<Transport> m_inner;
  DialogueListener m_listener;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// A dialogue as a file, complete up to the last exchange whatever becomes of the program. A disk that fills up stops
/// the recording and not the capture: problem() says so. One thread.
class DialogueFile {
public:
  /// A new file, begun with the transport's header. Errors (Storage): cannot be written, exists already.
  static Result<DialogueFile> create(const std::string& path, const Transport& transport);

  void add(const DialogueEntry& entry);
  const std::optional<Error>& problem() const { return m_problem; }

private:
  DialogueFile(std::string path, std::ofstream file) : m_path(std::move(path)), m_file(std::move(file)) {}

  std::string m_path;
  std::ofstream m_file;
  std::optional<Error> m_problem;
};

} // namespace straightedge::devices
