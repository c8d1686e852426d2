#include "app/gui/document/capture_record.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace straightedge::gui {

namespace {

const char* documentName(session::SweepRole role) {
  return role == session::SweepRole::Calibration ? "capture" : "verification-capture";
}

} // namespace

Result<void> writeCaptureRecord(session::Session& session, session::SweepRole role, const CaptureRecord& record) {
  // The plan's JSON goes in as text: only devices/capture knows what is in it.
  const QJsonObject object{{QStringLiteral("plan"), QString::fromStdString(devices::planToJson(record.plan))},
                           {QStringLiteral("finished"), record.finished},
                           {QStringLiteral("bench"), record.bench}};
  return session.setDocument(documentName(role), QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString());
}

std::optional<CaptureRecord> readCaptureRecord(const session::Session& session, session::SweepRole role) {
  const Result<std::string> text = session.document(documentName(role));
  if (!text || text->empty()) {
    return std::nullopt;
  }
  const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  const Result<devices::AnglePlan> plan =
      devices::planFromJson(object.value(QStringLiteral("plan")).toString().toStdString());
  if (!plan) {
    return std::nullopt;
  }
  return CaptureRecord{*plan, object.value(QStringLiteral("finished")).toBool(),
                       object.value(QStringLiteral("bench")).toString()};
}

} // namespace straightedge::gui
