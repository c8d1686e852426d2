#include "app/gui/field_steps/field_compare_presenter.h"

#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/figures/figure_parts.h"
#include "app/gui/jobs/job_runner.h"

#include <algorithm>
#include <numeric>

namespace straightedge::gui {

namespace {

const QString fieldComparisonJob = QStringLiteral("field-compare"); // as field_recompute.cpp calls it

int slopeOrderIn(const field::CorrectionChain& chain) {
  int order = 0;
  for (const field::AxisChain& axis : chain.axes) {
    if (axis.sensitivitySlope) {
      order = std::max(order, static_cast<int>(axis.sensitivitySlope->size()) - 1);
    }
  }
  return order;
}

} // namespace

FieldComparePresenter::FieldComparePresenter(FieldDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs) {
  connect(&document, &FieldDocument::opened, this, &FieldComparePresenter::changed);
  connect(&document, &FieldDocument::campaignChanged, this, &FieldComparePresenter::changed);
  connect(&document, &FieldDocument::choicesChanged, this, &FieldComparePresenter::changed);
  connect(&document, &FieldDocument::runChanged, this, &FieldComparePresenter::changed);
  connect(&document, &FieldDocument::comparisonChanged, this, &FieldComparePresenter::changed);
  connect(&jobs, &JobRunner::jobProgress, this, [this](const QString& key, double fraction) {
    if (key == fieldComparisonJob) {
      m_progress = fraction;
      emit progressChanged();
    }
  });
  connect(&jobs, &JobRunner::jobEnded, this, [this](const QString& key) {
    if (key == fieldComparisonJob) {
      m_progress = 0.0;
      emit progressChanged();
    }
  });
}

void FieldComparePresenter::setShown(bool shown) {
  m_document.setComparisonWanted(shown);
  emit progressChanged();
}

void FieldComparePresenter::setCost(ChainCost cost) {
  m_cost = cost;
  emit changed();
}

void FieldComparePresenter::setOnlyBest(bool only) {
  m_onlyBest = only;
  emit changed();
}

PlotSpec FieldComparePresenter::figure() const {
  const auto comparison = m_document.comparison();
  const auto run = m_document.run();
  if (!comparison || !run) {
    return emptyFigure(tr("Storage against error"),
                       dataAxis(m_cost == ChainCost::Coefficients ? tr("Coefficients of all axes")
                                                                  : tr("Multiplications for one reading")),
                       dataAxis(tr("Peak error that remains (% of full scale)")), missing());
  }
  return storageFigure(*comparison, m_cost, run->result.order, slopeOrderIn(run->result.chain)).spec;
}

std::optional<std::size_t> FieldComparePresenter::choiceAt(int series, int index) const {
  const auto comparison = m_document.comparison();
  if (!comparison || series < 0 || index < 0) {
    return std::nullopt;
  }
  const auto choices = storageFigure(*comparison, m_cost, 0, 0).choices;
  const auto line = static_cast<std::size_t>(series);
  const auto point = static_cast<std::size_t>(index);
  return line < choices.size() && point < choices[line].size() ? std::optional(choices[line][point]) : std::nullopt;
}

std::vector<std::size_t> FieldComparePresenter::shownChoices() const {
  const auto comparison = m_document.comparison();
  if (!comparison) {
    return {};
  }
  std::vector<std::size_t> places(comparison->choices.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  if (m_onlyBest) {
    std::erase_if(places, [&](std::size_t place) { return !comparison->choices[place].isBest; });
  }
  std::ranges::stable_sort(places, [&](std::size_t a, std::size_t b) {
    const field::StorageChoice& left = comparison->choices[a];
    const field::StorageChoice& right = comparison->choices[b];
    return std::pair(left.size.coefficients, left.largestPeakPercent) <
           std::pair(right.size.coefficients, right.largestPeakPercent);
  });
  return places;
}

std::optional<std::size_t> FieldComparePresenter::choiceOfRow(int row) const {
  const std::vector<std::size_t> places = shownChoices();
  return row >= 0 && static_cast<std::size_t>(row) < places.size()
             ? std::optional(places[static_cast<std::size_t>(row)])
             : std::nullopt;
}

ReportTable FieldComparePresenter::table() const {
  ReportTable table;
  const auto comparison = m_document.comparison();
  if (!comparison) {
    return table;
  }
  table.header = {tr("Chain"),      tr("Coefficients"), tr("Multiplications"), tr("Peak x (%)"), tr("Peak y (%)"),
                  tr("Peak z (%)"), tr("Rms x (%)"),    tr("Rms y (%)"),       tr("Rms z (%)"),  tr("Remark")};
  table.lastNumericColumn = 8;
  for (const std::size_t place : shownChoices()) {
    const field::StorageChoice& choice = comparison->choices[place];
    QStringList row{fromText(choice.name), QString::number(choice.size.coefficients),
                    QString::number(choice.size.multiplications)};
    for (const double peak : choice.peakPercent) {
      row << percentFigure(peak);
    }
    for (const double rms : choice.rmsPercent) {
      row << percentFigure(rms);
    }
    row << (choice.isBest ? tr("best of its size") : QString());
    table.rows.append(row);
  }
  return table;
}

void FieldComparePresenter::choose(std::size_t choice) {
  const auto comparison = m_document.comparison();
  if (!comparison || choice >= comparison->choices.size()) {
    return;
  }
  const field::StorageChoice& wanted = comparison->choices[choice];
  FieldChoices choices = m_document.choices();
  choices.order = wanted.order;
  if (wanted.without) {
    choices.blocksOff.insert(*wanted.without);
  }
  m_document.setChoices(choices, tr("Choose %1").arg(fromText(wanted.name)));
}

QString FieldComparePresenter::chosenText() const {
  const auto run = m_document.run();
  if (!run) {
    return {};
  }
  const field::ChainSize size = field::sizeOf(run->result.chain);
  QString text =
      tr("Fitted now: order %1, %2; %3 coefficients, %4 multiplications for one reading")
          .arg(run->result.order)
          .arg(run->result.method == field::FitMethod::Joint ? tr("all blocks together") : tr("block after block"))
          .arg(size.coefficients)
          .arg(size.multiplications);
  double peak = 0.0;
  for (const field::VerificationRow& row : run->result.verification) {
    if (row.state == field::VerifiedState::Calibrated) {
      peak = std::max(peak, row.ofFullScale.peak);
    }
  }
  return peak > 0.0 ? tr("%1; largest error %2 of full scale.").arg(text, percentPhrase(peak))
                    : text + QLatin1Char('.');
}

QString FieldComparePresenter::missing() const {
  if (m_document.run()) {
    return {};
  }
  return m_document.campaign().rows.empty()
             ? tr("There is no calibration yet: capture a campaign or import a CSV file first.")
             : tr("The calibration is not computed: see the step Fit.");
}

QString FieldComparePresenter::progressText() const {
  if (!m_jobs.isRunning(fieldComparisonJob)) {
    return {};
  }
  return tr("Comparing orders: %1 %").arg(qRound(m_progress * 100.0));
}

} // namespace straightedge::gui
