// Everything a calibration can be taken away as, written together: all files or none.
#pragma once

#include "app/gui/figures/angle_figures.h"
#include "app/gui/figures/field_figures.h"
#include "core/base/error.h"
#include "core/base/job_control.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <vector>

namespace straightedge::gui {

class ScenePictures;

struct ExportChoices {
  bool calibration = true; ///< calibration.json
  bool tablesCsv = true;   ///< linear-32.csv, …
  bool tablesJson = false; ///< linear-32.json, …: a calibration with one model
  bool sweep = true;       ///< sweep.csv or campaign.csv: the readings the calibration was made from
  bool comparison = true;  ///< comparison.csv
  bool plotsPng = true;    ///< plots/correction-curve.png, …
  bool plotsSvg = false;
  bool plotsPdf = false;
  bool reportPdf = true; ///< report.pdf
  bool reportHtml = false;

  bool operator==(const ExportChoices&) const = default;
};

/// A file to be written: its name below the folder and how its bytes are made. Any thread.
struct FileToWrite {
  QString name;
  std::function<QByteArray()> bytes; ///< null: cannot be made here, the file is left out
};

/// What the choices come to with these results; files without content (no sweep, no comparison) are left out.
/// Cheap: bytes are made only when asked for.
std::vector<FileToWrite> filesToWrite(const std::shared_ptr<const AngleResults>& results, const ExportChoices& choices);
/// Of a field calibration: tablesCsv is coefficients.csv and a table per block; tablesJson and comparison give nothing.
std::vector<FileToWrite> filesToWrite(const std::shared_ptr<const FieldResults>& results, const ExportChoices& choices);

/// Adds plots/STEM.png, … of every figure in the formats chosen; three-dimensional ones, by `scenes`, as PNG whichever
/// are.
void addPictures(std::vector<FileToWrite>& files, const QList<NamedFigure>& figures, const ExportChoices& choices,
                 const std::shared_ptr<ScenePictures>& scenes = {});

/// Writes them below `folder`, which is made where it is missing. Every file is written whole under a temporary name
/// before the first takes its name: stopped or failed until then, the files that were there stay as they were (folders
/// made on the way stay, empty). Giving the names takes no room and is not interrupted; should it fail half-way all the
/// same (somebody else changes the folder), the error says which files are new.
/// Returns the names written. Errors: Storage, Cancelled.
Result<QStringList> writeFiles(const std::vector<FileToWrite>& files, const QString& folder, const JobControl& job);

} // namespace straightedge::gui
