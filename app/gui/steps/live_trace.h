// Samples as they arrive -> plots that stay light however many there are: single points first, then the smallest and
// largest of each of 1,024 columns of the turn.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/session/sample_sink.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace straightedge::gui {

/// Degrees. One thread.
class LiveTrace {
public:
  static constexpr int columns = 1024;
  /// Above this many samples points would only cover each other.
  static constexpr std::size_t mostPoints = 3000;

  void clear();
  /// `all` are the samples of the capture so far, those from `firstNew` on are new since the last call.
  void add(std::span<const session::AngleSample> all, std::size_t firstNew);

  PlotSpec sensorPlot() const; ///< sensor over encoder angle of the turn; series 0 rising, 1 falling
  PlotSpec errorPlot() const;  ///< reading − encoder, continuous; reading is 360 − sensor for a decreasing sensor
  /// Plan point of a plotted point; nothing where columns are shown.
  std::optional<int> planPoint(int series, int index) const;
  bool dense() const { return m_dense; }
  bool decreasing() const { return m_decreasing.value_or(false); }
  std::optional<double> errorDeg(const session::AngleSample& sample) const; ///< as in errorPlot()

private:
  struct Point {
    int point = 0;
    double encoderDeg = 0.0, sensorDeg = 0.0, errorDeg = 0.0;
  };
  struct Extremes {
    double least = 0.0, most = 0.0;
    bool filled = false;
    void take(double value);
  };
  struct Column {
    Extremes sensor, error;
  };

  void rebuild(std::span<const session::AngleSample> all);
  void addOne(const session::AngleSample& sample);
  bool findDirection(std::span<const session::AngleSample> all);
  PlotSeries pointSeries(std::size_t direction, bool error) const;
  PlotSeries columnSeries(std::size_t direction, bool error) const;
  QList<PlotSeries> series(bool error) const;
  void describe(PlotSpec& spec) const;

  std::optional<bool> m_decreasing; ///< unknown until the shaft has moved
  std::optional<double> m_firstError;
  bool m_dense = false;
  std::array<std::vector<Point>, 2> m_points; ///< rising, falling
  std::array<std::vector<Column>, 2> m_columns;
  std::vector<int> m_attempts; ///< latest attempt per plan point
};

} // namespace straightedge::gui
