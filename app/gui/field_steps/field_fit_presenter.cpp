#include "app/gui/field_steps/field_fit_presenter.h"

#include "app/gui/field_steps/field_page_figures.h"
#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/figures/field_report_tables.h"
#include "app/gui/figures/field_words.h"
#include "app/gui/figures/figure_parts.h"
#include "core/field/block_costs.h"
#include "core/field/block_names.h"
#include "core/field/names.h"

#include <algorithm>
#include <array>

namespace straightedge::gui {

FieldFitPresenter::FieldFitPresenter(FieldDocument& document, QObject* parent) : QObject(parent), m_document(document) {
  connect(&document, &FieldDocument::opened, this, &FieldFitPresenter::changed);
  connect(&document, &FieldDocument::campaignChanged, this, &FieldFitPresenter::changed);
  connect(&document, &FieldDocument::choicesChanged, this, &FieldFitPresenter::changed);
  connect(&document, &FieldDocument::runChanged, this, &FieldFitPresenter::changed);
}

void FieldFitPresenter::setOrder(int order) {
  FieldChoices choices = m_document.choices();
  choices.order = std::clamp(order, field::lowestOrder, field::highestOrder);
  m_document.setChoices(choices, tr("Choose the order"));
}

void FieldFitPresenter::setMethod(field::FitMethod method) {
  FieldChoices choices = m_document.choices();
  choices.method = method;
  m_document.setChoices(choices, tr("Choose the method"));
}

void FieldFitPresenter::setFullScaleT(double fullScaleT) {
  FieldChoices choices = m_document.choices();
  choices.fullScaleT = fullScaleT;
  if (fullScaleT > 0.0) {
    m_document.setChoices(choices, tr("Set the full scale"));
  }
}

void FieldFitPresenter::setReferenceTemperatureC(double temperatureC) {
  FieldChoices choices = m_document.choices();
  choices.referenceTemperatureC = temperatureC;
  m_document.setChoices(choices, tr("Set the reference temperature"));
}

QList<FieldFitPresenter::BlockChoice> FieldFitPresenter::blocks() const {
  const std::vector<field::CampaignRow>& rows = m_document.campaign().rows;
  std::set<field::CampaignStep> recorded;
  for (const field::CampaignRow& row : rows) {
    recorded.insert(row.step);
  }
  QList<BlockChoice> choices;
  for (const auto& [block, word] : field::blockWords) {
    choices.append({.block = block,
                    .title = blockTitle(block),
                    .on = !m_document.choices().blocksOff.contains(block),
                    .measured = recorded.contains(field::stepOf(block)),
                    .cost = QString::fromLatin1(field::costOf(block))});
  }
  return choices;
}

void FieldFitPresenter::setBlockOn(field::Block block, bool on) {
  FieldChoices choices = m_document.choices();
  if (on) {
    choices.blocksOff.erase(block);
  } else {
    choices.blocksOff.insert(block);
  }
  const QString title = blockTitle(block).toLower();
  m_document.setChoices(choices, on ? tr("Switch on %1").arg(title) : tr("Switch off %1").arg(title));
}

QString FieldFitPresenter::fitText() const {
  const std::shared_ptr<const field::FieldRun> run = m_document.run();
  if (!run) {
    return {};
  }
  QStringList lines;
  if (!run->result.jointHow.empty()) {
    lines << fromText(run->result.jointHow);
  }
  for (const field::Axis axis : field::allAxes) {
    if (const std::string& text = run->result.orderExplanation[field::indexOf(axis)]; !text.empty()) {
      lines << axisWord(axis) + QStringLiteral(": ") + fromText(text);
    }
  }
  return lines.join(QLatin1Char('\n'));
}

QList<NamedFigure> FieldFitPresenter::figures() const {
  static constexpr std::array topics{FigureTopic::Nonlinearity, FigureTopic::ProbeTemperature, FigureTopic::Offset,
                                     FigureTopic::Sensitivity,  FigureTopic::Electronics,      FigureTopic::AxisMatrix,
                                     FigureTopic::Verification, FigureTopic::Uncertainty};
  return figuresAbout(m_document, topics);
}

PlotSpec FieldFitPresenter::emptyPlot() const {
  return emptyFigure(tr("Fit"), dataAxis(tr("Reference field (T)")), dataAxis(tr("Error (% of full scale)")),
                     missing());
}

QList<FieldFitPresenter::BeforeAfter> FieldFitPresenter::beforeAfter() const {
  const std::shared_ptr<const field::FieldRun> run = m_document.run();
  if (!run) {
    return {};
  }
  const auto peakOf = [](const std::vector<field::VerificationRow>& rows, field::Axis axis,
                         field::VerifiedState state) -> std::optional<double> {
    const auto row = std::ranges::find_if(
        rows, [&](const field::VerificationRow& each) { return each.axis == axis && each.state == state; });
    return row == rows.end() ? std::nullopt : std::optional(row->ofFullScale.peak);
  };
  QList<BeforeAfter> values;
  for (const field::Axis axis : field::allAxes) {
    const auto before = peakOf(run->result.verification, axis, field::VerifiedState::Uncalibrated);
    const auto after = peakOf(run->result.verification, axis, field::VerifiedState::Calibrated);
    if (!before || !after) {
      continue;
    }
    QString hint = tr("Largest error over the verification rows, percent of full scale, before and after calibration");
    if (const auto stepwise = peakOf(run->result.stepwiseVerification, axis, field::VerifiedState::Calibrated)) {
      hint += tr("; fitted step by step: %1").arg(percentPhrase(*stepwise));
    }
    values.append({tr("Largest error, %1").arg(axisWord(axis)),
                   percentPhrase(*before) + QStringLiteral(" → ") + percentPhrase(*after), hint});
  }
  if (const auto& uncertainty = run->result.uncertainty) {
    constexpr double teslaToMicrotesla = 1e6;
    values.append({tr("Uncertainty (95 %)"),
                   QString::number(uncertainty->medianT * teslaToMicrotesla, 'f', 0) + QStringLiteral(" – ") +
                       QString::number(uncertainty->largestT * teslaToMicrotesla, 'f', 0) + QStringLiteral(" µT"),
                   tr("Of a corrected reading over field and temperature: median and largest")});
  }
  return values;
}

ReportTable FieldFitPresenter::orders() const {
  const std::shared_ptr<const field::FieldRun> run = m_document.run();
  return run ? ordersTable(run->result) : ReportTable{};
}

ReportTable FieldFitPresenter::blockRows() const {
  const std::shared_ptr<const field::FieldRun> run = m_document.run();
  if (!run) {
    return {};
  }
  ReportTable table = blocksTable(run->result);
  table.lastNumericColumn = static_cast<int>(table.header.size()) - 1;
  table.header << tr("How");
  for (QStringList& row : table.rows) { // the report has no room for it
    const auto summary = std::ranges::find_if(run->result.blocks, [&row](const field::BlockSummary& each) {
      return blockTitle(each.block) == row[0] && axisWord(each.axis) == row[1];
    });
    row << (summary == run->result.blocks.end() ? QString() : fromText(summary->how));
  }
  return table;
}

ReportTable FieldFitPresenter::coefficients() const {
  const std::shared_ptr<const field::FieldRun> run = m_document.run();
  return run ? chainTable(run->result.chain) : ReportTable{};
}

ReportTable FieldFitPresenter::uncertainty() const {
  const std::shared_ptr<const field::FieldRun> run = m_document.run();
  return run && run->result.uncertainty ? fieldUncertaintyTable(*run->result.uncertainty) : ReportTable{};
}

ReportTable FieldFitPresenter::states() const {
  const std::shared_ptr<const field::FieldRun> run = m_document.run();
  return run ? fieldVerificationTable(run->result.verification, field::PercentOf::FullScale) : ReportTable{};
}

QString FieldFitPresenter::missing() const {
  if (m_document.run()) {
    return {};
  }
  if (m_document.runError()) {
    return fromText(m_document.runError()->message());
  }
  return m_document.campaign().rows.empty() ? tr("There is no campaign yet: capture one, or import a CSV file.")
                                            : tr("The blocks are being fitted.");
}

QList<Notice> FieldFitPresenter::notices() const {
  QList<Notice> notices;
  if (const QString text = missing(); !text.isEmpty()) {
    notices.append({m_document.runError() ? Notice::Level::Problem : Notice::Level::Information, text});
  }
  const std::shared_ptr<const field::FieldRun> run = m_document.run();
  if (!run) {
    return notices;
  }
  QStringList chosen; // what was switched off by choice is no surprise: one line for all
  for (const field::Block block : m_document.choices().blocksOff) {
    chosen << tr("%1 is switched off: %2").arg(blockTitle(block), QString::fromLatin1(field::costOf(block)));
  }
  if (!chosen.isEmpty()) {
    notices.append({Notice::Level::Information, chosen.join(QLatin1Char('\n'))});
  }
  QStringList warnings;
  for (const field::FieldWarning& warning : run->result.warnings) {
    const bool byChoice = m_document.choices().blocksOff.contains(warning.block);
    if (const QString text = fromText(warning.text); !byChoice && !warnings.contains(text)) {
      warnings << text;
    }
  }
  if (!warnings.isEmpty()) {
    notices.append({Notice::Level::Warning, warnings.join(QLatin1Char('\n'))});
  }
  return notices;
}

} // namespace straightedge::gui
