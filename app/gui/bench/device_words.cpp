#include "app/gui/bench/device_words.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace straightedge::gui {

namespace {

QString deviceText(const char* text) { return QCoreApplication::translate("DeviceWords", text); }

QString capital(QString sentence) {
  if (!sentence.isEmpty()) {
    sentence[0] = sentence[0].toUpper();
  }
  return sentence;
}

} // namespace

QString deviceTitle(const devices::ListedDevice& device) {
  return QString::fromStdString(device.instrumentName.empty() ? device.name : device.instrumentName);
}

QString deviceWhere(const devices::ListedDevice& device) {
  QStringList parts;
  if (device.ids) {
    parts << QString::fromStdString(devices::hexId(device.ids->vendor) + ":" + devices::hexId(device.ids->product));
  }
  if (!device.serial.empty()) {
    parts << deviceText("serial %1").arg(QString::fromStdString(device.serial));
  }
  if (device.port) {
    const QString path = QString::fromStdString(device.port->path);
    if (path != deviceTitle(device)) {
      parts << path;
    }
  }
  return parts.join(QStringLiteral(", "));
}

QString deviceKey(const devices::ListedDevice& device) {
  const QString plug = device.usb ? QString::fromStdString(device.usb->port) : QString();
  return plug + QLatin1Char('|') + deviceWhere(device);
}

QString deviceUse(const devices::ListedDevice& device, const std::vector<RoleSlot>& roles) {
  QStringList fits;
  for (const RoleSlot& slot : roles) {
    if (std::ranges::find(device.roles, slot.role) != device.roles.end()) {
      fits << slot.title;
    }
  }
  if (fits.isEmpty()) {
    return device.roles.empty() ? deviceText("Not an instrument that Straightedge knows")
                                : deviceText("Of no use for this kind of calibration");
  }
  const QString list = fits.join(QStringLiteral(", "));
  return (device.instrument.empty() ? deviceText("May be: %1") : deviceText("Is used as: %1")).arg(list);
}

QString instrumentTitle(const std::string& id, const devices::ProfileSet& profiles) {
  if (const devices::KnownInstrument* known = devices::knownInstrument(id)) {
    return QString::fromUtf8(known->name.data(), static_cast<qsizetype>(known->name.size()));
  }
  const devices::Profile* profile = devices::findProfile(profiles, id);
  return QString::fromStdString(profile != nullptr ? profile->name : id);
}

QString instrumentCaution(const std::string& id, const devices::ProfileSet& profiles) {
  bool notTried = false;
  std::string unconfirmed;
  if (const devices::KnownInstrument* known = devices::knownInstrument(id)) {
    notTried = known->notYetTried;
    unconfirmed = std::string(known->unconfirmed);
  } else if (const devices::Profile* profile = devices::findProfile(profiles, id)) {
    notTried = profile->notYetTried;
    unconfirmed = profile->unconfirmed;
  }
  QStringList sentences;
  if (notTried) {
    sentences << deviceText("Not yet tried on hardware.");
  }
  if (!unconfirmed.empty()) {
    sentences << deviceText("Not confirmed: %1.").arg(QString::fromStdString(unconfirmed));
  }
  return sentences.join(QLatin1Char(' '));
}

std::optional<QString> commandIn(const QString& remedy) {
  const QString mark = QStringLiteral("run: ");
  const qsizetype begin = remedy.indexOf(mark);
  if (begin < 0) {
    return std::nullopt;
  }
  const QString command = remedy.mid(begin + mark.size());
  return command.left(command.indexOf(QStringLiteral(", then "))).trimmed();
}

QString plainMessage(const Error& error) {
  QString text = capital(QString::fromStdString(error.what));
  if (!error.remedy.empty()) {
    text += QStringLiteral("; ") + QString::fromStdString(error.remedy);
  }
  return error.where.empty() ? text : QString::fromStdString(error.where) + QStringLiteral(": ") + text;
}

} // namespace straightedge::gui
