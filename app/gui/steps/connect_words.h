// What the steps Connect of both kinds say alike: the bench's instruments, and traceability, which is taken over from
// them.
#pragma once

#include "core/base/traceability.h"
#include "devices/instruments/angle_instruments.h"

#include <QList>
#include <QString>

#include <optional>

namespace straightedge::gui {

class CaptureLink;

/// One role of the connected bench and who fills it.
struct ConnectedInstrument {
  QString role, model, serial;
};
QList<ConnectedInstrument> connectedInstruments(const CaptureLink& bench);

/// What is under calibration and its reference, as the connected bench tells them.
struct BenchIdentities {
  devices::InstrumentIdentity device;
  std::optional<devices::InstrumentIdentity> reference;
};

/// Lines of text; says what is not stated yet. `unit` follows the reference's uncertainty: "°", " T".
QString traceabilityLines(const Traceability& stated, const QString& unit);

/// The bench tells model or serial that is not stated, or stated otherwise.
bool tellsMore(const BenchIdentities& bench, const Traceability& stated);
Traceability withIdentities(Traceability stated, const BenchIdentities& bench);

} // namespace straightedge::gui
