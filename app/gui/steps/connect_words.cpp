#include "app/gui/steps/connect_words.h"

#include "app/gui/document/capture_link.h"
#include "core/base/number_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace straightedge::gui {

namespace {

QString sayTraceability(const char* text) { return QCoreApplication::translate("Traceability", text); }

QString orNotStated(const std::string& text) {
  return text.empty() ? sayTraceability("not stated") : QString::fromStdString(text);
}

/// "MODEL, serial SERIAL", as much of it as is stated.
QString joined(const std::string& first, const QString& word, const std::string& second) {
  const QString tail = second.empty() ? QString() : word + QLatin1Char(' ') + QString::fromStdString(second);
  return first.empty() && !second.empty()
             ? tail
             : orNotStated(first) + (tail.isEmpty() ? QString() : QStringLiteral(", ") + tail);
}

} // namespace

QList<ConnectedInstrument> connectedInstruments(const CaptureLink& bench) {
  QList<ConnectedInstrument> list;
  for (const BenchInstrument& instrument : bench.instruments()) {
    list.append({instrument.role, QString::fromStdString(instrument.identity.model),
                 QString::fromStdString(instrument.identity.serial)});
  }
  return list;
}

QString traceabilityLines(const Traceability& stated, const QString& unit) {
  const ReferenceInstrument& reference = stated.reference;
  const QString serial = sayTraceability("serial");
  QStringList lines;
  lines << sayTraceability("Device: %1").arg(joined(stated.deviceModel, serial, stated.deviceSerial));
  lines << sayTraceability("Reference: %1").arg(joined(reference.model, serial, reference.serial));
  lines << sayTraceability("Certificate: %1").arg(joined(reference.certificate, sayTraceability("due"), reference.due));
  lines << (reference.uncertainty > 0.0 ? sayTraceability("Reference uncertainty: %1%2 (k = 2)")
                                              .arg(QString::fromStdString(formatForPeople(reference.uncertainty)), unit)
                                        : sayTraceability("Reference uncertainty: not stated, so it counts as zero"));
  lines << sayTraceability("Operator: %1").arg(orNotStated(stated.operatorName));
  if (stated.ambientC) {
    lines
        << sayTraceability("Ambient temperature: %1 °C").arg(QString::fromStdString(formatForPeople(*stated.ambientC)));
  }
  return lines.join(QLatin1Char('\n'));
}

bool tellsMore(const BenchIdentities& bench, const Traceability& stated) {
  return stated.deviceModel != bench.device.model || stated.deviceSerial != bench.device.serial ||
         (bench.reference &&
          (stated.reference.model != bench.reference->model || stated.reference.serial != bench.reference->serial));
}

Traceability withIdentities(Traceability stated, const BenchIdentities& bench) {
  stated.deviceModel = bench.device.model;
  stated.deviceSerial = bench.device.serial;
  if (bench.reference) {
    stated.reference.model = bench.reference->model;
    stated.reference.serial = bench.reference->serial;
  }
  return stated;
}

} // namespace straightedge::gui
