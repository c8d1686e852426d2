#include "app/gui/field_steps/field_page_tables.h"

#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/figures/field_words.h"
#include "core/field/block_names.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {

namespace {

const QString noFigure = QStringLiteral("–");

QString sayFieldTable(const char* text) { return QCoreApplication::translate("FieldTables", text); }

QString foretold(const std::optional<double>& percent) {
  return percent && std::isfinite(*percent) ? percentFigure(*percent) : noFigure;
}

} // namespace

ReportTable fitOrdersTable(const field::FieldCalibration& calibration) {
  ReportTable table;
  table.header = {sayFieldTable("Axis"),
                  sayFieldTable("Order"),
                  sayFieldTable("Largest error (% of full scale)"),
                  sayFieldTable("Foretold, largest"),
                  sayFieldTable("Foretold, rms"),
                  QString()};
  table.lastNumericColumn = 4;
  for (const field::OrderError& order : calibration.orders) {
    table.rows.append({axisWord(order.axis), QString::number(order.order), percentFigure(order.maxErrorPercent),
                       foretold(order.crossMaxPercent), foretold(order.crossRmsPercent),
                       order.order == calibration.order ? sayFieldTable("chosen") : QString()});
  }
  return table;
}

ReportTable fitBlocksTable(const field::FieldCalibration& calibration, const std::set<field::Block>& offByChoice) {
  ReportTable table;
  table.header = {sayFieldTable("Block"),    sayFieldTable("Axis"),         sayFieldTable("Rows"),
                  sayFieldTable("Left out"), sayFieldTable("Coefficients"), sayFieldTable("Residual, 1 σ"),
                  sayFieldTable("Largest"),  sayFieldTable("How")};
  table.firstNumericColumn = 2;
  table.lastNumericColumn = 6;
  for (const auto& [block, word] : field::blockWords) {
    bool on = false;
    for (const field::BlockSummary& summary : calibration.blocks) {
      if (summary.block == block) {
        on = true;
        table.rows.append({blockTitle(block), axisWord(summary.axis), QString::number(summary.rowsUsed),
                           QString::number(summary.rowsLeftOut), QString::number(summary.coefficients),
                           residualFigure(block, summary.residualSigma), residualFigure(block, summary.residualLargest),
                           QString::fromStdString(summary.how)});
      }
    }
    if (!on) {
      table.rows.append({blockTitle(block), axisWord({}), noFigure, noFigure, QString::number(0), noFigure, noFigure,
                         offByChoice.contains(block) ? sayFieldTable("switched off by choice")
                                                     : sayFieldTable("off: see the warnings")});
    }
  }
  return table;
}

ReportTable fitStatesTable(const std::vector<field::VerificationRow>& rows, field::PercentOf of) {
  ReportTable table;
  const bool ofReading = of == field::PercentOf::Reading;
  table.header = {sayFieldTable("Axis"),
                  sayFieldTable("State"),
                  ofReading ? sayFieldTable("Mean (% of reading)") : sayFieldTable("Mean (% of full scale)"),
                  sayFieldTable("1 σ"),
                  sayFieldTable("Peak"),
                  sayFieldTable("Points")};
  table.firstNumericColumn = 2;
  for (const field::VerificationRow& row : rows) {
    const std::optional<field::ErrorFigures> figures = ofReading ? row.ofReading : row.ofFullScale;
    table.rows.append({axisWord(row.axis), stateWord(row.state), figures ? percentFigure(figures->mean) : noFigure,
                       figures ? percentFigure(figures->sigma) : noFigure,
                       figures ? percentFigure(figures->peak) : noFigure,
                       row.points > 0 ? QString::number(row.points) : noFigure});
  }
  return table;
}

} // namespace straightedge::gui
