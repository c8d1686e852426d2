// The column beside the plots of a step Capture, of every kind of calibration.
#pragma once

#include <QList>
#include <QScrollArea>

#include <cstdint>

namespace straightedge::gui {

/// Boxes one below the other, which scroll where the window is low; as wide as `form`, one of them, needs. Height that
/// is left goes to the last one, or stays empty.
class CaptureColumn : public QScrollArea {
public:
  enum class Rest : std::uint8_t { Empty, ToLastBox };
  CaptureColumn(const QList<QWidget*>& boxes, const QWidget& form, Rest rest, QWidget* parent = nullptr);
};

} // namespace straightedge::gui
