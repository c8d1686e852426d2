// Rows of one stage as they arrive -> two plots that stay light however many there are.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "core/session/sample_sink.h"
#include "devices/capture/field_plan.h"

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace straightedge::gui {

/// Shows one stage's latest attempt. Above mostRows every second row is left out of the plots, and again. One thread.
class FieldLiveTrace {
public:
  static constexpr std::size_t mostRows = 3000;

  /// Begins anew with this stage, whose number in the plan is `number`.
  void setStage(const devices::FieldStage& stage, int number);
  void clear();
  /// Those of the stage are taken in.
  void add(std::span<const session::FieldSample> samples);

  /// What is measured over what it depends on: reading less reference over the field, or over a temperature.
  PlotSpec mainPlot() const;
  /// Over time: how the reading moves on each plateau or sweep, and where the reference was not locked; in the
  /// zero-field chamber the temperature.
  PlotSpec timePlot() const;
  std::size_t rows() const { return m_count; } ///< of the latest attempt
  std::size_t unlocked() const { return m_unlocked; }

private:
  struct Row {
    double timeS = 0.0;
    double over = 0.0;                         ///< field or temperature, of the main plot
    std::array<double, 3> reading = {0, 0, 0}; ///< less the reference along the field, tesla
    double moved = 0.0;                        ///< along the field, since the first row of the plateau or sweep
    double temperature = 0.0;                  ///< time plot of the zero-field chamber: ohms or °C
    double chamberC = 0.0;
    bool locked = false;
  };
  bool inField() const;
  bool overElectronics() const;
  QString temperatureTitle() const;
  void addOne(const session::FieldSample& sample);
  void keep(const Row& row);

  devices::FieldStage m_stage;
  std::optional<int> m_number;
  int m_attempt = 0;
  std::size_t m_count = 0;
  std::size_t m_unlocked = 0;
  std::size_t m_stride = 1;
  std::vector<Row> m_rows;
  std::optional<double> m_firstTimeS;
  std::map<int, double> m_firstOfPoint; ///< reading along the field, less the reference
};

} // namespace straightedge::gui
