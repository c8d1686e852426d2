#include "app/gui/bench/dialogue_log.h"

#include "core/base/file_output.h"

#include <algorithm>

namespace straightedge::gui {

void DialogueLog::add(const devices::BenchExchange& exchange) {
  Entry entry;
  entry.connection = exchange.connection;
  entry.when = std::chrono::system_clock::now();
  entry.sinceS = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
  entry.entry = exchange.entry;
  const std::lock_guard lock(m_mutex);
  const auto speaker = std::ranges::find(m_speakers, exchange.instrument, &Speaker::name);
  entry.instrument = static_cast<std::size_t>(speaker - m_speakers.begin());
  if (speaker == m_speakers.end()) {
    m_speakers.push_back({exchange.instrument, devices::dialogueHeader(exchange.transport)});
  }
  m_bytes += entry.entry.bytes.size();
  m_entries.push_back(std::move(entry));
  while (m_entries.size() > mostEntries || (m_bytes > mostBytes && m_entries.size() > 1)) {
    m_speakers[m_entries.front().instrument].complete = false;
    m_bytes -= m_entries.front().entry.bytes.size();
    m_entries.pop_front();
    ++m_first;
  }
}

void DialogueLog::clear() {
  const std::lock_guard lock(m_mutex);
  m_first += m_entries.size();
  m_entries.clear();
  m_speakers.clear();
  m_bytes = 0;
}

std::vector<std::string> DialogueLog::instruments() const {
  const std::lock_guard lock(m_mutex);
  std::vector<std::string> names;
  names.reserve(m_speakers.size());
  for (const Speaker& speaker : m_speakers) {
    names.push_back(speaker.name);
  }
  return names;
}

DialogueLog::News DialogueLog::since(std::uint64_t number) const {
  const std::lock_guard lock(m_mutex);
  const std::uint64_t next = m_first + m_entries.size();
  const auto begin = static_cast<std::ptrdiff_t>(std::clamp(number, m_first, next) - m_first);
  return {.entries = {m_entries.begin() + begin, m_entries.end()}, .next = next};
}

Result<void> DialogueLog::save(const std::string& path, std::size_t instrument) const {
  std::string text;
  {
    const std::lock_guard lock(m_mutex);
    if (instrument >= m_speakers.size()) {
      return fail(ErrorKind::Usage, "nothing was said with this instrument yet", "connect it first");
    }
    const Speaker& speaker = m_speakers[instrument];
    text = speaker.header + "# " + speaker.name + "\n";
    if (!speaker.complete) {
      text += "# the beginning is missing: only the last exchanges are kept\n";
    }
    int connection = 0;
    double beginS = 0.0;
    for (const Entry& entry : m_entries) {
      if (entry.instrument != instrument) {
        continue;
      }
      if (connection == 0) {
        beginS = entry.sinceS;
      } else if (entry.connection != connection) {
        text += "# opened again\n";
      }
      connection = entry.connection;
      devices::DialogueEntry line = entry.entry;
      line.timeS = entry.sinceS - beginS; // one clock through all connections
      text += devices::dialogueLine(line);
    }
  }
  return writeFileWhole(path, text);
}

} // namespace straightedge::gui
