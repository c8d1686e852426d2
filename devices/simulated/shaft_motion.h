// Where the simulated shaft stands at any time.
#pragma once

namespace straightedge::devices {

/// A ramp at constant speed that the shaft follows with a first-order lag: when the ramp ends, and the stage says it is
/// there, the shaft still creeps in. It never overshoots, so that what hysteresis is seen is the sensor's alone.
class ShaftMotion {
public:
  static constexpr double lagS = 0.004; ///< time constant of the lag

  explicit ShaftMotion(double speedDegPerS);

  void moveTo(double targetDeg, double nowS);
  void halt(double nowS) { moveTo(commandedDeg(nowS), nowS); }
  bool isMoving(double nowS) const { return nowS < m_startS + m_durationS; }
  double arrivalS() const { return m_startS + m_durationS; }
  double positionDeg(double timeS) const; ///< of the shaft

private:
  double commandedDeg(double timeS) const;

  double m_speedDegPerS;
  double m_fromDeg = 0.0;
  double m_toDeg = 0.0;
  double m_startS = 0.0;
  double m_durationS = 0.0;
  double m_initialLagDeg = 0.0; ///< commanded minus shaft when the ramp began
};

} // namespace straightedge::devices
