#include "app/gui/document/capture_link.h"

#include <QStringList>

namespace straightedge::gui {

namespace {

QString identityLine(const BenchInstrument& instrument) {
  QString line = instrument.role + QStringLiteral(": ") + QString::fromStdString(instrument.identity.model);
  if (!instrument.identity.serial.empty()) {
    line += QStringLiteral(", serial ") + QString::fromStdString(instrument.identity.serial);
  }
  return line;
}

} // namespace

QString CaptureLink::describe() const {
  QStringList lines;
  for (const BenchInstrument& instrument : m_instruments) {
    lines << identityLine(instrument);
  }
  return lines.join(QLatin1Char('\n'));
}

} // namespace straightedge::gui
