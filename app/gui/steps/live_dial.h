// A round dial with two needles: where the shaft stands by the encoder, and what the sensor says.
#pragma once

#include <QWidget>

#include <optional>

namespace straightedge::gui {

/// Degrees clockwise from the top. Without a reading it shows an empty scale.
class LiveDial : public QWidget {
  Q_OBJECT
public:
  explicit LiveDial(QWidget* parent = nullptr);

  void setReading(double encoderDeg, double sensorDeg);
  void clearReading();

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  struct Reading {
    double encoderDeg, sensorDeg;
  };
  std::optional<Reading> m_reading;
};

} // namespace straightedge::gui
