// Replies and stream lines of a US Digital QSB, whatever its EOR register (0x15) makes them look like.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace straightedge::devices {

struct QsbReply {
  char kind = 'r';      ///< r read, w written, s streamed, e and x: refused
  std::uint8_t reg = 0; ///< register
  std::uint32_t data = 0;
  std::optional<std::uint32_t> stamp; ///< ticks of the QSB's own clock
};

/// "s 0E FFFFFC18 00000FF1 !" with or without blanks, stamp and line ends; up to and including the '!'. Nothing where
/// the text is no such reply. Source: qsb-commands-list.pdf v1.28 in tmtsoftware/m1cs-qsb-linear-encoder-reader.
std::optional<QsbReply> parseQsbReply(std::string_view text);

} // namespace straightedge::devices
