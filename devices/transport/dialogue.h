// What was said between the program and an instrument: as entries for a console, and as a text file that replay plays
// and a bug report carries.
//
//   straightedge-dialogue 1
//   transport USBTMC 1bfa:0498 serial 0123
//   messages yes
//   0.000000 > *IDN?\n
//   0.001250 < Metrolab Technology SA,THM1176-MF,0123,el-A1-K1\n
//   0.502000 !< timed-out: no answer within the time allowed; check the cable
//   0.502100 x
//
// One exchange a line: seconds, mark, bytes. Bytes that are not printable ASCII are written \n \r \t \\ or \xHH; a
// blank at the end is \x20. Lines that begin with # are comments.
#pragma once

#include "devices/transport/transport.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::devices {

enum class DialogueMark : std::uint8_t {
  Sent,            ///< ">"  bytes were to be sent
  Received,        ///< "<"  bytes came
  Cleared,         ///< "x"  both sides threw away what was on its way
  Status,          ///< "s"  the status byte, one byte
  SendingFailed,   ///< "!>" how the sending in the line before ended
  ReceivingFailed, ///< "!<"
  ClearingFailed,  ///< "!x"
  StatusFailed,    ///< "!s"
};

struct DialogueEntry {
  double timeS = 0.0; ///< since the dialogue began
  DialogueMark mark = DialogueMark::Sent;
  std::string bytes;    ///< of Sent, Received, Status
  TransportError fault; ///< of the marks that say failed; `where` is not written
  int line = 0;         ///< of the file it was read from; 0 where there is none
};

struct Dialogue {
  std::string transportName;
  bool hasMessages = false;
  std::vector<DialogueEntry> entries;
};

/// Bytes as one line of printable ASCII, and back. unescaped() gives nothing where the text is no such line.
std::string escaped(std::string_view bytes);
std::optional<std::string> unescaped(std::string_view text);

std::string_view markText(DialogueMark mark);           ///< ">"
std::string dialogueHeader(const Transport& transport); ///< the first lines of a file
std::string dialogueLine(const DialogueEntry& entry);   ///< with its newline

/// `name` is the file's, for messages. Errors (Input): FILE:LINE, what the line should be.
Result<Dialogue> parseDialogue(std::string_view text, const std::string& name);
Result<Dialogue> readDialogue(const std::string& path);

} // namespace straightedge::devices
