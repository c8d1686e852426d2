#include "app/gui/document/capture_record.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace straightedge::gui {

namespace {

const char* recordName(session::SweepRole role) {
  return role == session::SweepRole::Calibration ? "capture" : "verification-capture";
}

template <typename Plan>
Result<void> writeRecordOf(session::Session& session, session::SweepRole role, const CaptureRecordOf<Plan>& record) {
  // The plan's JSON goes in as text: only devices/capture knows what is in it.
  const QJsonObject object{{QStringLiteral("plan"), QString::fromStdString(devices::planToJson(record.plan))},
                           {QStringLiteral("finished"), record.finished},
                           {QStringLiteral("bench"), record.bench}};
  return session.setDocument(recordName(role), QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString());
}

template <typename Plan>
std::optional<CaptureRecordOf<Plan>> readRecordOf(const session::Session& session, session::SweepRole role,
                                                  Result<Plan> (*planOf)(std::string_view)) {
  const Result<std::string> text = session.document(recordName(role));
  if (!text || text->empty()) {
    return std::nullopt;
  }
  const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  const Result<Plan> plan = planOf(object.value(QStringLiteral("plan")).toString().toStdString());
  if (!plan) {
    return std::nullopt;
  }
  return CaptureRecordOf<Plan>{*plan, object.value(QStringLiteral("finished")).toBool(),
                               object.value(QStringLiteral("bench")).toString()};
}

} // namespace

Result<void> writeCaptureRecord(session::Session& session, session::SweepRole role, const CaptureRecord& record) {
  return writeRecordOf(session, role, record);
}

Result<void> writeCaptureRecord(session::Session& session, session::SweepRole role, const FieldCaptureRecord& record) {
  return writeRecordOf(session, role, record);
}

std::optional<CaptureRecord> readCaptureRecord(const session::Session& session, session::SweepRole role) {
  return readRecordOf<devices::AnglePlan>(session, role, &devices::planFromJson);
}

std::optional<FieldCaptureRecord> readFieldCaptureRecord(const session::Session& session, session::SweepRole role) {
  return readRecordOf<devices::FieldPlan>(session, role, &devices::fieldPlanFromJson);
}

} // namespace straightedge::gui
