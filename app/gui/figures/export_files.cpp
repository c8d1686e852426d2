#include "app/gui/figures/export_files.h"

#include "app/gui/figures/picture_files.h"
#include "app/gui/figures/report_content.h"
#include "app/gui/figures/report_html.h"
#include "app/gui/figures/report_pdf.h"
#include "app/gui/figures/scene_pictures.h"
#include "core/angle/sweep_csv.h"
#include "core/base/file_output.h"
#include "core/export/calibration_json.h"
#include "core/export/tables.h"

#include <QFileInfo>

#include <algorithm>
#include <memory>

namespace straightedge::gui {

namespace {

using Files = std::vector<FileToWrite>;

QByteArray toBytes(const std::string& text) { return QByteArray::fromStdString(text); }

using Results = std::shared_ptr<const AngleResults>;

/// A calibration with one of its models.
angle::AngleCalibration onlyModel(const angle::AngleCalibration& calibration, std::size_t place) {
  angle::AngleCalibration one = calibration;
  one.models = {calibration.models[place]};
  std::erase_if(one.uncertainty, [name = one.models.front().name.text()](const angle::UncertaintyBudget& budget) {
    return budget.model != name;
  });
  return one;
}

void addTables(Files& files, const Results& results, const ExportChoices& choices) {
  for (std::size_t place = 0; place < results->calibration.models.size(); ++place) {
    const angle::Model& model = results->calibration.models[place];
    if (choices.tablesCsv) {
      files.push_back({QString::fromStdString(exporting::modelTableFileName(model)), [results, place] {
                         return toBytes(exporting::modelTableCsv(results->calibration.models[place]));
                       }});
    }
    if (choices.tablesJson) {
      files.push_back({QString::fromStdString(model.name.fileStem()) + QStringLiteral(".json"), [results, place] {
                         return toBytes(exporting::calibrationToJson(onlyModel(results->calibration, place)));
                       }});
    }
  }
}

} // namespace

void addPictures(Files& files, const QList<NamedFigure>& figures, const ExportChoices& choices,
                 const std::shared_ptr<ScenePictures>& scenes) {
  const QList<std::pair<bool, PictureFormat>> formats{{choices.plotsPng, PictureFormat::Png},
                                                      {choices.plotsSvg, PictureFormat::Svg},
                                                      {choices.plotsPdf, PictureFormat::Pdf}};
  if (std::ranges::none_of(formats, [](const auto& each) { return each.first; })) {
    return;
  }
  for (const NamedFigure& figure : figures) {
    if (figure.isScene()) {
      if (scenes) {
        files.push_back({QStringLiteral("plots/") + figure.stem + QStringLiteral(".png"),
                         [scenes, figure] { return scenes->png(figure); }});
      }
      continue;
    }
    for (const auto& [wanted, format] : formats) {
      if (wanted) {
        files.push_back({QStringLiteral("plots/") + figure.stem + QLatin1Char('.') + suffixOf(format),
                         [make = figure.make, as = format] { return plotAs(as, make()); }});
      }
    }
  }
}

Files filesToWrite(const std::shared_ptr<const AngleResults>& results, const ExportChoices& choices) {
  Files files;
  const auto add = [&files](const char* name, std::function<QByteArray()> bytes) {
    files.push_back({QString::fromLatin1(name), std::move(bytes)});
  };
  if (choices.calibration) {
    add("calibration.json", [results] { return toBytes(exporting::calibrationToJson(results->calibration)); });
  }
  addTables(files, results, choices);
  if (choices.sweep && results->sweep && results->sweep->size() > 0) {
    add("sweep.csv", [results] { return toBytes(angle::sweepToCsv(*results->sweep)); });
  }
  if (choices.comparison && results->comparison && !results->comparison->rows.empty()) {
    add("comparison.csv", [results] { return toBytes(exporting::comparisonCsv(*results->comparison)); });
  }
  addPictures(files, angleFigures(results), choices);
  if (choices.reportPdf) {
    add("report.pdf", [results] { return reportAsPdf(angleReport(results)); });
  }
  if (choices.reportHtml) {
    add("report.html", [results] { return reportAsHtml(angleReport(results)); });
  }
  return files;
}

Result<QStringList> writeFiles(const Files& files, const QString& folder, const JobControl& job) {
  std::vector<PendingFile> pending;
  pending.reserve(files.size());
  QStringList names;
  for (const FileToWrite& file : files) {
    if (job.stopRequested()) {
      return fail(ErrorKind::Cancelled, "the export was stopped", "nothing was written", folder.toStdString());
    }
    const QByteArray bytes = file.bytes();
    if (bytes.isNull()) {
      continue;
    }
    const QString path = folder + QLatin1Char('/') + file.name;
    if (const Result<void> made = makeFolder(QFileInfo(path).path().toStdString()); !made) {
      return std::unexpected(made.error());
    }
    Result<PendingFile> out = PendingFile::create(path.toStdString());
    if (!out) {
      return std::unexpected(out.error());
    }
    if (const Result<void> written = out->write({bytes.constData(), static_cast<std::size_t>(bytes.size())});
        !written) {
      return std::unexpected(written.error());
    }
    pending.push_back(std::move(*out));
    names.append(file.name);
    job.report(static_cast<double>(names.size()) / static_cast<double>(files.size()));
  }
  if (job.stopRequested()) {
    return fail(ErrorKind::Cancelled, "the export was stopped", "nothing was written", folder.toStdString());
  }
  for (std::size_t i = 0; i < pending.size(); ++i) {
    if (const Result<void> committed = pending[i].commit(Durability::Cached); !committed) {
      Error error = committed.error();
      if (i > 0) {
        error.what += "; " + std::to_string(i) + " of " + std::to_string(pending.size()) +
                      " files are new already, up to " + names[static_cast<qsizetype>(i) - 1].toStdString();
      }
      return std::unexpected(std::move(error));
    }
  }
  return names;
}

} // namespace straightedge::gui
