#include "app/gui/field_steps/field_review_presenter.h"

#include "app/gui/figures/field_campaign_figures.h"
#include "app/gui/figures/field_scene_figures.h"
#include "app/gui/figures/figure_parts.h"

#include <algorithm>
#include <numeric>

namespace straightedge::gui {

FieldReviewPresenter::FieldReviewPresenter(FieldDocument& document, QObject* parent)
    : QObject(parent), m_document(document) {
  connect(&document, &FieldDocument::opened, this, &FieldReviewPresenter::forget);
  connect(&document, &FieldDocument::campaignChanged, this, &FieldReviewPresenter::forget);
  connect(&document, &FieldDocument::choicesChanged, this, &FieldReviewPresenter::forget);
  connect(&document, &FieldDocument::runChanged, this, &FieldReviewPresenter::forget);
}

void FieldReviewPresenter::forget() {
  m_stages.reset();
  m_plotted.reset();
  emit changed();
}

QString FieldReviewPresenter::missing() const {
  return hasCampaign() ? QString() : tr("There is no campaign yet: capture one, or import a CSV file.");
}

QList<Notice> FieldReviewPresenter::notices() const {
  QList<Notice> notices;
  if (hasCampaign() && m_document.runError()) {
    notices.append({Notice::Level::Problem, fromText(m_document.runError()->message())});
  }
  if (const auto run = m_document.run()) {
    QStringList warnings;
    for (const field::FieldWarning& warning : run->result.warnings) {
      const QString text = fromText(warning.text);
      if (!m_document.choices().blocksOff.contains(warning.block) && !warnings.contains(text)) {
        warnings << text;
      }
    }
    if (!warnings.isEmpty()) {
      notices.append({Notice::Level::Warning, warnings.join(QLatin1Char('\n'))});
    }
  }
  return notices;
}

QList<FieldReviewPresenter::Fact> FieldReviewPresenter::facts() const {
  std::size_t runs = 0;
  std::size_t unlocked = 0;
  for (const ListedStage& stage : stages()) {
    runs += stage.runs.size();
    unlocked += stage.needsLock ? stage.rows - stage.locked : 0;
  }
  const auto off = std::ranges::count(m_document.rowsEnabled(), false);
  QList<Fact> facts{{tr("Rows"), QString::number(m_document.campaign().rows.size()), tr("As recorded")},
                    {tr("Stages"), QString::number(stages().size()), tr("One step of one axis or orientation each")},
                    {tr("Plateaus and sweeps"), QString::number(runs), tr("Rows taken in one go")},
                    {tr("Not locked"), QString::number(unlocked),
                     tr("Rows whose reference was not locked where it is needed: they count nowhere")},
                    {tr("Switched off"), QString::number(off), tr("Rows left out by choice")}};
  if (const auto run = m_document.run()) {
    std::size_t rejected = 0;
    for (const auto& report : run->reports.nonlinearity) {
      rejected += report ? report->plateaus.rejected.size() : 0;
    }
    facts.append({tr("Rejected plateaus"), QString::number(rejected), tr("Too short or not settled")});
  }
  return facts;
}

const std::vector<ListedStage>& FieldReviewPresenter::stages() const {
  if (!m_stages) {
    m_stages = campaignStages(m_document);
  }
  return *m_stages;
}

std::optional<std::pair<std::size_t, std::size_t>> FieldReviewPresenter::placeOfRow(std::size_t row) const {
  for (std::size_t stage = 0; stage < stages().size(); ++stage) {
    const std::vector<ListedRun>& runs = stages()[stage].runs;
    for (std::size_t run = 0; run < runs.size(); ++run) {
      if (row >= runs[run].run.first && row < runs[run].run.first + runs[run].run.count) {
        return std::pair(stage, run);
      }
    }
  }
  return std::nullopt;
}

std::vector<std::size_t> FieldReviewPresenter::rowsOf(std::size_t stage, std::optional<std::size_t> run) const {
  std::vector<std::size_t> rows;
  if (stage >= stages().size()) {
    return rows;
  }
  const std::vector<ListedRun>& runs = stages()[stage].runs;
  for (std::size_t place = 0; place < runs.size(); ++place) {
    if (!run || *run == place) {
      const std::size_t before = rows.size();
      rows.resize(before + runs[place].run.count);
      std::iota(rows.begin() + static_cast<std::ptrdiff_t>(before), rows.end(), runs[place].run.first);
    }
  }
  return rows;
}

void FieldReviewPresenter::setEnabled(const std::vector<std::size_t>& rows, bool enabled, const QString& what) {
  const QString text = what.isEmpty() ? QString()
                       : enabled      ? tr("Switch on %1").arg(what)
                                      : tr("Switch off %1").arg(what);
  m_document.setRowsEnabled(rows, enabled, text);
}

void FieldReviewPresenter::toggle(const std::vector<std::size_t>& rows) {
  setEnabled(rows, std::ranges::any_of(rows, [this](std::size_t row) { return !m_document.isRowEnabled(row); }));
}

bool FieldReviewPresenter::anyOff() const { return std::ranges::count(m_document.rowsEnabled(), false) > 0; }

void FieldReviewPresenter::switchAllOn() {
  std::vector<std::size_t> rows(m_document.campaign().rows.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  setEnabled(rows, true, tr("all rows"));
}

const PlotSpec& FieldReviewPresenter::plot(field::CampaignStep step) const {
  if (m_plotted != step) {
    m_figure = campaignStepFigure(m_document.campaign(), step, m_document.rowsEnabled());
    m_plotted = step;
  }
  return m_figure.spec;
}

SphereSpec FieldReviewPresenter::orientations() const {
  return orientationSphere(orientationsCovered(m_document.campaign(), m_document.rowsEnabled()));
}

std::optional<std::size_t> FieldReviewPresenter::rowAt(int series, int index) const {
  if (!m_plotted || series < 0 || static_cast<std::size_t>(series) >= m_figure.rows.size()) {
    return std::nullopt;
  }
  const std::vector<std::size_t>& rows = m_figure.rows[static_cast<std::size_t>(series)];
  return index >= 0 && static_cast<std::size_t>(index) < rows.size()
             ? std::optional(rows[static_cast<std::size_t>(index)])
             : std::nullopt;
}

} // namespace straightedge::gui
