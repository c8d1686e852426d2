// Whether a file that was exported is what its name says.
#pragma once

#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QJsonDocument>

#include <algorithm>

namespace straightedge::gui {

inline bool parses(const QString& file) {
  QFile opened(file);
  if (!opened.open(QIODevice::ReadOnly) || opened.size() == 0) {
    return false;
  }
  const QByteArray bytes = opened.readAll();
  const QString kind = QFileInfo(file).suffix();
  if (kind == QStringLiteral("json")) {
    return !QJsonDocument::fromJson(bytes).isNull();
  }
  if (kind == QStringLiteral("png")) {
    return !QImage::fromData(bytes, "PNG").isNull();
  }
  if (kind == QStringLiteral("pdf")) {
    return bytes.startsWith("%PDF-") && bytes.contains("%%EOF");
  }
  if (kind == QStringLiteral("csv")) {
    const QList<QByteArray> lines = bytes.trimmed().split('\n');
    return lines.size() > 1 && std::all_of(lines.begin(), lines.end(), [&lines](const QByteArray& line) {
             return line.count(',') == lines.front().count(',');
           });
  }
  return kind == QStringLiteral("svg") || kind == QStringLiteral("html") ? bytes.contains('<') : true;
}

} // namespace straightedge::gui
