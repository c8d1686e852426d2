#include "app/gui/field_steps/field_live_trace.h"

#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/figure_parts.h"
#include "core/field/names.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace straightedge::gui {

namespace {

QString sayTrace(const char* text) { return QCoreApplication::translate("FieldLiveTrace", text); }

constexpr double millisPerTesla = 1e3;
constexpr double microsPerTesla = 1e6;

std::optional<std::size_t> axisAlongField(const devices::FieldStage& stage) {
  if (stage.orientation) {
    return field::indexOf(field::axisOf(*stage.orientation));
  }
  return stage.axis ? std::optional(field::indexOf(*stage.axis)) : std::nullopt;
}

double orNaN(const std::optional<double>& value) { return value.value_or(std::numeric_limits<double>::quiet_NaN()); }

/// From the beginning on the whole range that the plateaus will cover, so that one sees how far they are.
void spanPlateaus(const devices::FieldStage& stage, PlotAxis& axis) {
  const double sign = stage.orientation && field::isMinus(*stage.orientation) ? -1.0 : 1.0;
  double low = 0.0;
  double high = 0.0;
  for (const double fieldT : stage.fieldsT) {
    low = std::min(low, sign * fieldT);
    high = std::max(high, sign * fieldT);
  }
  const double margin = 0.05 * (high - low);
  if (margin > 0.0) {
    axis.minimum = low - margin;
    axis.maximum = high + margin;
  }
}

/// No legend entry for what is not there.
PlotSeries namedIfFilled(PlotSeries series) {
  if (series.x.isEmpty()) {
    series.name.clear();
  }
  return series;
}

} // namespace

void FieldLiveTrace::setStage(const devices::FieldStage& stage, int number) {
  clear();
  m_stage = stage;
  m_number = number;
}

void FieldLiveTrace::clear() { *this = FieldLiveTrace(); }

bool FieldLiveTrace::inField() const { return devices::needsReference(m_stage); }

bool FieldLiveTrace::overElectronics() const { return devices::isElectronicsSweep(m_stage); }

void FieldLiveTrace::add(std::span<const session::FieldSample> samples) {
  for (const session::FieldSample& sample : samples) {
    if (m_number && sample.stage == *m_number && sample.attempt >= m_attempt) {
      addOne(sample);
    }
  }
}

void FieldLiveTrace::addOne(const session::FieldSample& sample) {
  if (sample.attempt > m_attempt) { // measured again: what was before does not count any more
    const devices::FieldStage stage = m_stage;
    setStage(stage, sample.stage);
    m_attempt = sample.attempt;
  }
  if (!m_firstTimeS) {
    m_firstTimeS = sample.timeS;
  }
  Row row;
  row.timeS = sample.timeS - *m_firstTimeS;
  row.locked = sample.locked || !inField();
  row.reading = sample.rawT;
  row.temperature = orNaN(overElectronics() ? sample.electronicsC : sample.pt100Ohm);
  row.chamberC = orNaN(sample.chamberC);
  row.over = devices::isSweep(m_stage) ? row.temperature : orNaN(sample.referenceT);
  if (const auto along = axisAlongField(m_stage); along && row.locked && sample.referenceT) {
    row.reading[*along] -= *sample.referenceT;
    row.moved = row.reading[*along] - m_firstOfPoint.try_emplace(sample.point, row.reading[*along]).first->second;
  }
  m_unlocked += row.locked ? 0U : 1U;
  if (m_count++ % m_stride == 0) {
    keep(row);
  }
}

void FieldLiveTrace::keep(const Row& row) {
  m_rows.push_back(row);
  if (m_rows.size() <= mostRows) {
    return;
  }
  for (std::size_t i = 0; 2 * i < m_rows.size(); ++i) {
    m_rows[i] = m_rows[2 * i];
  }
  m_rows.resize((m_rows.size() + 1) / 2);
  m_stride *= 2;
}

QString FieldLiveTrace::temperatureTitle() const {
  return overElectronics() ? electronicsTitle() : sayTrace("PT100 resistance (Ω)");
}

PlotSpec FieldLiveTrace::mainPlot() const {
  PlotSpec spec;
  const bool calibratesThermometer = m_stage.step == field::CampaignStep::ProbeTemperature;
  spec.x = dataAxis(devices::isSweep(m_stage) ? temperatureTitle() : fieldTitle());
  spec.y = dataAxis(calibratesThermometer ? sayTrace("Chamber temperature (°C)")
                    : inField()           ? sayTrace("Reading − reference (mT)")
                                          : sayTrace("Raw reading (mT)"));
  if (!m_number) {
    spec.note = sayTrace("No stage is chosen");
    return spec;
  }
  spec.title = stageWord(m_stage.step, m_stage.axis, m_stage.orientation);
  if (!devices::isSweep(m_stage)) {
    spanPlateaus(m_stage, spec.x);
  }
  if (calibratesThermometer) {
    PlotSeries series = lineSeries({}, SeriesColor::First);
    for (const Row& row : m_rows) {
      series.x.append(row.over);
      series.y.append(row.chamberC);
    }
    spec.series.append(std::move(series));
  } else {
    for (const field::Axis axis : field::allAxes) {
      // A sweep in a field is about the axis along it; across it a plateau shows how the axes are tilted.
      const bool wanted = !m_stage.axis || !devices::isSweep(m_stage) || *m_stage.axis == axis;
      PlotSeries series = pointSeries(sayTrace("Axis %1").arg(axisLetter(axis)), axisColor(axis));
      for (const Row& row : m_rows) {
        if (wanted && row.locked) {
          series.x.append(row.over);
          series.y.append(millisPerTesla * row.reading.at(field::indexOf(axis)));
        }
      }
      spec.series.append(namedIfFilled(std::move(series)));
    }
  }
  spec.note = m_count == 0 ? sayTrace("No rows yet") : sayTrace("%1 rows").arg(m_count);
  if (m_unlocked > 0) {
    spec.note += sayTrace(", %1 without a locked reference left out").arg(m_unlocked);
  }
  if (m_stride > 1) {
    spec.note += sayTrace("; every %1th is drawn").arg(m_stride);
  }
  return spec;
}

PlotSpec FieldLiveTrace::timePlot() const {
  PlotSpec spec;
  spec.x = dataAxis(sayTrace("Time in this stage (s)"));
  if (!inField()) {
    spec.y = dataAxis(temperatureTitle());
    PlotSeries series = lineSeries(temperatureTitle(), SeriesColor::First);
    PlotSeries chamber = lineSeries(sayTrace("Chamber, right axis"), SeriesColor::Second);
    chamber.rightAxis = true;
    for (const Row& row : m_rows) {
      series.x.append(row.timeS);
      series.y.append(row.temperature);
      if (!std::isnan(row.chamberC)) {
        chamber.x.append(row.timeS);
        chamber.y.append(row.chamberC);
      }
    }
    if (!chamber.x.isEmpty()) {
      spec.right = dataAxis(sayTrace("Chamber temperature (°C)"));
      spec.series.append(std::move(chamber));
    } else {
      series.name.clear();
    }
    spec.series.prepend(std::move(series));
    return spec;
  }
  spec.y = dataAxis(sayTrace("Moved since the first row (µT)"));
  PlotSeries locked = pointSeries(sayTrace("Locked"), SeriesColor::First);
  PlotSeries unlocked = pointSeries(sayTrace("Not locked"), SeriesColor::Bad);
  for (const Row& row : m_rows) {
    PlotSeries& to = row.locked ? locked : unlocked;
    to.x.append(row.timeS);
    to.y.append(row.locked ? microsPerTesla * row.moved : 0.0);
  }
  spec.series.append(namedIfFilled(std::move(locked)));
  spec.series.append(namedIfFilled(std::move(unlocked)));
  spec.note = sayTrace("From the first locked row of each plateau or sweep on");
  return spec;
}

} // namespace straightedge::gui
