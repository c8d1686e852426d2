#include "core/export/tables.h"

#include "core/base/number_text.h"

namespace straightedge::exporting {

namespace {

using namespace angle;

std::string harmonicTable(const HarmonicModel& model, const std::optional<StoredIntegers>& stored) {
  std::string text = "order,amplitude_deg,phase_rad";
  text += stored ? ",stored_amplitude,stored_phase\n" : "\n";
  text += "0," + formatDouble(model.offsetDeg) + ",0" + (stored ? ",," : "") + "\n";
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    const HarmonicTerm& term = model.terms[i];
    text += std::to_string(term.order) + "," + formatDouble(term.amplitudeDeg) + "," + formatDouble(term.phaseRad);
    if (stored) {
      text +=
          "," + std::to_string(stored->integers[i]) + "," + std::to_string(stored->integers[model.terms.size() + i]);
    }
    text += '\n';
  }
  return text;
}

std::string edge(Eigen::Index index, Eigen::Index count) {
  return formatDouble(static_cast<double>(index) * 360.0 / static_cast<double>(count));
}

std::string valueTable(const Eigen::VectorXd& values, bool bins, const std::optional<StoredIntegers>& stored) {
  std::string text = bins ? "from_deg,to_deg,correction_deg" : "reading_deg,correction_deg";
  text += stored ? ",stored\n" : "\n";
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    text += edge(i, values.size()) + ",";
    if (bins) {
      text += edge(i + 1, values.size()) + ",";
    }
    text += formatDouble(values[i]);
    if (stored) {
      text += "," + std::to_string(stored->integers[static_cast<std::size_t>(i)]);
    }
    text += '\n';
  }
  return text;
}

} // namespace

std::string modelTableCsv(const Model& model) {
  if (const auto* harmonic = std::get_if<HarmonicModel>(&model.body)) {
    return harmonicTable(*harmonic, model.stored);
  }
  if (const auto* linear = std::get_if<LinearModel>(&model.body)) {
    return valueTable(linear->valuesDeg, false, model.stored);
  }
  return valueTable(std::get<LookupTableModel>(model.body).valuesDeg, true, model.stored);
}

std::string modelTableFileName(const Model& model) { return model.name.fileStem() + ".csv"; }

} // namespace straightedge::exporting
