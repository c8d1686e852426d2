#include "app/gui/bench/bench_roles.h"

#include <QCoreApplication>
#include <QStringList>

namespace straightedge::gui {

namespace {

using Role = devices::InstrumentRole;

QString roleWords(const char* text) { return QCoreApplication::translate("BenchRoles", text); }

struct RoleUnit {
  int decimals;
  QString unit;
};

RoleUnit unitOf(Role role) {
  switch (role) {
  case Role::AngleSensor:
  case Role::AngleReference:
    return {4, QStringLiteral("°")};
  case Role::FieldProbe:
    return {6, QStringLiteral(" T")};
  case Role::FieldReference:
    return {7, QStringLiteral(" T")};
  case Role::Resistance:
    return {4, QStringLiteral(" Ω")};
  case Role::Temperature:
  case Role::ChamberTemperature:
    return {2, QStringLiteral(" °C")};
  }
  return {3, {}};
}

} // namespace

std::vector<RoleSlot> angleRoleSlots() {
  return {{Role::AngleSensor, roleWords("Sensor under calibration"), true},
          {Role::AngleReference, roleWords("Reference encoder"), true},
          {Role::Temperature, roleWords("Temperature"), false}};
}

std::vector<RoleSlot> fieldRoleSlots() {
  return {{Role::FieldProbe, roleWords("Teslameter under calibration"), true},
          {Role::FieldReference, roleWords("Reference field"), false},
          {Role::Resistance, roleWords("PT100 of the probe"), false},
          {Role::Temperature, roleWords("Temperature of the electronics"), false},
          {Role::ChamberTemperature, roleWords("Temperature of the chamber"), false}};
}

QString roleReadingText(Role role, const devices::RoleReading& reading) {
  if (reading.values.empty()) {
    return QString::fromStdString(reading.note);
  }
  const RoleUnit shown = unitOf(role);
  QStringList numbers;
  for (const double value : reading.values) {
    numbers << QString::number(value, 'f', shown.decimals).replace(QLatin1Char('-'), QChar(0x2212));
  }
  return numbers.join(QStringLiteral("  ")) + shown.unit;
}

} // namespace straightedge::gui
