#include "app/gui/steps/capture_words.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace straightedge::gui {

namespace {
QString sayDuration(const char* text) { return QCoreApplication::translate("CaptureWords", text); }
} // namespace

QString durationText(double seconds) {
  if (seconds < 1.0) {
    return sayDuration("less than 1 s");
  }
  const qint64 whole = std::llround(seconds);
  if (whole < 60) {
    return sayDuration("%1 s").arg(whole);
  }
  if (whole < 3600) {
    return sayDuration("%1 min %2 s").arg(whole / 60).arg(whole % 60);
  }
  return sayDuration("%1 h %2 min").arg(whole / 3600).arg(whole % 3600 / 60);
}

QString countText(qint64 count) {
  return QLocale(QLocale::English).toString(count).replace(QLatin1Char(','), QChar(0x202f));
}

} // namespace straightedge::gui
