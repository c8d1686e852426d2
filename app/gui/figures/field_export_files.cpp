#include "app/gui/figures/export_files.h"
#include "app/gui/figures/report_content.h"
#include "app/gui/figures/report_html.h"
#include "app/gui/figures/report_pdf.h"
#include "app/gui/figures/scene_pictures.h"
#include "core/export/field_calibration_json.h"
#include "core/export/field_tables.h"
#include "core/field/campaign_csv.h"

namespace straightedge::gui {

std::vector<FileToWrite> filesToWrite(const std::shared_ptr<const FieldResults>& results,
                                      const ExportChoices& choices) {
  std::vector<FileToWrite> files;
  const auto add = [&files](const char* name, std::function<QByteArray()> bytes) {
    files.push_back({QString::fromLatin1(name), std::move(bytes)});
  };
  const auto bytesOf = [](const std::string& text) { return QByteArray::fromStdString(text); };
  if (choices.calibration) {
    add("calibration.json",
        [results, bytesOf] { return bytesOf(exporting::fieldCalibrationToJson(results->calibration)); });
  }
  if (choices.tablesCsv) {
    add("coefficients.csv",
        [results, bytesOf] { return bytesOf(exporting::fieldCoefficientsCsv(results->calibration)); });
    for (exporting::NamedTable& table : exporting::fieldBlockTables(results->calibration)) {
      files.push_back({QString::fromStdString(table.fileName), [bytes = bytesOf(table.text)] { return bytes; }});
    }
  }
  if (choices.sweep && results->campaign && !results->campaign->rows.empty()) {
    add("campaign.csv", [results, bytesOf] { return bytesOf(field::campaignCsv(*results->campaign)); });
  }
  const auto scenes = std::make_shared<ScenePictures>();
  addPictures(files, fieldFigures(results), choices, scenes);
  if (choices.reportPdf) {
    add("report.pdf", [results, scenes] { return reportAsPdf(fieldReport(results, scenes.get())); });
  }
  if (choices.reportHtml) {
    add("report.html", [results, scenes] { return reportAsHtml(fieldReport(results, scenes.get())); });
  }
  return files;
}

} // namespace straightedge::gui
