// How a document takes its parts out of a session: what cannot be read is said, the rest is taken.
#pragma once

#include "core/session/session.h"

#include <QString>
#include <QStringList>

#include <string>
#include <utility>

namespace straightedge::gui {

/// Reads the named document and, where there is one, hands parse(text) to `take`. What is wrong with it is appended to
/// `problems`, as a sentence.
template <typename Parse, typename Take>
void readDocument(const session::Session& session, const char* name, QStringList& problems, Parse parse, Take take) {
  const auto text = session.document(name);
  if (!text) {
    problems.append(QString::fromStdString(text.error().message()));
  } else if (!text->empty()) {
    if (auto value = parse(*text)) {
      take(std::move(*value));
    } else {
      problems.append(QString::fromStdString(value.error().message()));
    }
  }
}

/// For documents that are kept as the text they are.
inline Result<std::string> asItIs(const std::string& text) { return text; }

} // namespace straightedge::gui
