// What a person at the bench is to do: asked for on standard error, confirmed with Enter on standard input.
#pragma once

#include <cstdint>
#include <string>

namespace straightedge::cli {

/// Standard input may be a terminal or a pipe; each line of it confirms one instruction. Never blocks.
class PersonPrompt {
public:
  enum class Answer : std::uint8_t { NotYet, Done, NobodyThere };

  /// `confirmsAll`: every instruction is taken as done at once, and nothing is read.
  explicit PersonPrompt(bool confirmsAll) : m_confirmsAll(confirmsAll) {}

  /// Shows the instruction when it is new, and looks for the answer. NobodyThere: standard input is at its end.
  Answer ask(const std::string& instruction);
  void withdraw() { m_asked.clear(); } ///< nothing is asked for now

private:
  bool m_confirmsAll;
  std::string m_asked;
};

} // namespace straightedge::cli
