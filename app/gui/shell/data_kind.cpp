#include "app/gui/shell/data_kind.h"

#include <QFile>

#include <algorithm>

namespace straightedge::gui {

namespace {

constexpr qint64 beginningBytes = 65536; // comments before the header may be long

bool namesCampaign(QByteArray header) {
  header.replace(';', ',').replace('\t', ',').replace('"', "");
  const auto cells = header.split(',');
  const auto has = [&](const char* name) {
    return std::any_of(cells.begin(), cells.end(),
                       [name](const QByteArray& cell) { return cell.trimmed().toLower() == name; });
  };
  return has("step") && has("raw_x_t");
}

} // namespace

session::SessionKind dataKindOf(const QByteArray& beginning) {
  const auto lines = (beginning.startsWith("\xEF\xBB\xBF") ? beginning.mid(3) : beginning).split('\n');
  const auto header = std::find_if(lines.begin(), lines.end(), [](const QByteArray& line) {
    const QByteArray text = line.trimmed();
    return !text.isEmpty() && !text.startsWith('#');
  });
  return header != lines.end() && namesCampaign(*header) ? session::SessionKind::Field : session::SessionKind::Angle;
}

session::SessionKind dataKindOfFile(const QString& file) {
  QFile opened(file);
  return opened.open(QIODevice::ReadOnly) ? dataKindOf(opened.read(beginningBytes)) : session::SessionKind::Angle;
}

} // namespace straightedge::gui
