#include "app/gui/steps/compare_presenter.h"

#include "app/gui/figures/figure_parts.h"
#include "app/gui/jobs/job_runner.h"

#include <algorithm>
#include <utility>

namespace straightedge::gui {

namespace {

/// Least and largest error that a target line can stand for.
constexpr double smallestTargetDeg = 1e-4;
constexpr double largestTargetDeg = 180.0;
constexpr int largestBudget = 4096;

} // namespace

ComparePresenter::ComparePresenter(AngleDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_known(document.choices()) {
  connect(&document, &AngleDocument::opened, this, [this] {
    m_known = m_document.choices();
    rebuild();
  });
  connect(&document, &AngleDocument::choicesChanged, this, &ComparePresenter::onChoices);
  connect(&document, &AngleDocument::runChanged, this, &ComparePresenter::rebuild);
  connect(&document, &AngleDocument::comparisonChanged, this, [this] {
    rebuild();
    emit progressChanged();
  });
  connect(&jobs, &JobRunner::jobProgress, this, [this](const QString& key, double fraction) {
    if (key == QLatin1String("compare-fully")) {
      m_progress = fraction;
      emit progressChanged();
    }
  });
}

void ComparePresenter::setErrorMeasure(ErrorMeasure measure) {
  if (std::exchange(m_error, measure) != measure) {
    rebuild();
  }
}

void ComparePresenter::setStorageMeasure(StorageMeasure measure) {
  if (std::exchange(m_storage, measure) != measure) {
    rebuild();
  }
}

std::optional<int> ComparePresenter::bits() const { return m_document.choices().bits; }

void ComparePresenter::setBits(std::optional<int> bits) {
  AngleChoices choices = m_document.choices();
  if (choices.bits != bits) {
    choices.bits = bits;
    m_document.setChoices(choices, tr("Choose the stored width"));
  }
}

const PlotSpec& ComparePresenter::figure() const {
  if (!m_figure) {
    const AngleChoices& choices = m_document.choices();
    ComparisonFigureOptions options{.error = m_error,
                                    .storage = m_storage,
                                    .selected = choices.selected,
                                    .targetErrorDeg = choices.targetErrorDeg,
                                    .budgetEntries = choices.budgetEntries,
                                    .leaveOneOutDeg = {},
                                    .bits = choices.bits};
    if (const auto run = m_document.run()) {
      options.leaveOneOutDeg =
          m_error == ErrorMeasure::Maximum ? run->curve.leaveOneOutMaxDeg : run->curve.leaveOneOutRmsDeg;
    }
    const auto rows = comparison();
    m_figure = comparisonFigure(rows ? *rows : angle::Comparison{}, options);
    if (!rows) {
      m_figure->spec.guides.clear();
      m_figure->spec.note = missing();
    }
  }
  return m_figure->spec;
}

double ComparePresenter::targetErrorDeg() const { return m_document.choices().targetErrorDeg; }

int ComparePresenter::budgetEntries() const { return m_document.choices().budgetEntries; }

void ComparePresenter::setTargetErrorDeg(double valueDeg) {
  AngleChoices choices = m_document.choices();
  choices.targetErrorDeg = std::clamp(valueDeg, smallestTargetDeg, largestTargetDeg);
  if (choices != m_document.choices()) {
    m_document.setChoices(choices, tr("Set the target error"));
  }
}

void ComparePresenter::setBudgetEntries(int entries) {
  AngleChoices choices = m_document.choices();
  choices.budgetEntries = std::clamp(entries, 1, largestBudget);
  if (choices != m_document.choices()) {
    m_document.setChoices(choices, tr("Set the storage budget"));
  }
}

void ComparePresenter::dragGuide(const QString& id, double value) {
  if (id == QLatin1String(targetGuide)) {
    setTargetErrorDeg(value);
  } else if (id == QLatin1String(budgetGuide)) {
    setBudgetEntries(budgetFromAxis(value, m_storage, bits()));
  }
}

double ComparePresenter::guideValue(const QString& id) const {
  return id == QLatin1String(targetGuide) ? targetErrorDeg() : budgetOnAxis(budgetEntries(), m_storage, bits());
}

angle::Recommendation ComparePresenter::forTarget() const {
  const auto rows = comparison();
  return rows ? angle::recommendForTarget(*rows, targetErrorDeg()) : angle::Recommendation{};
}

angle::Recommendation ComparePresenter::forBudget() const {
  const auto rows = comparison();
  return rows ? angle::recommendForBudget(*rows, budgetEntries()) : angle::Recommendation{};
}

void ComparePresenter::choosePoint(int series, int index) {
  const auto rows = comparison();
  figure(); // fills m_figure, which knows the row of every point
  if (!rows || series < 0 || static_cast<std::size_t>(series) >= m_figure->rows.size()) {
    return;
  }
  const std::vector<std::size_t>& rowOf = m_figure->rows[static_cast<std::size_t>(series)];
  if (index >= 0 && static_cast<std::size_t>(index) < rowOf.size()) {
    chooseModel(rows->rows[rowOf[static_cast<std::size_t>(index)]].name);
  }
}

void ComparePresenter::chooseModel(const angle::ModelName& name) {
  AngleChoices choices = m_document.choices();
  choices.selected = name;
  if (std::ranges::find(choices.models, name) == choices.models.end()) {
    choices.models.push_back(name);
  }
  if (choices != m_document.choices()) {
    m_document.setChoices(choices, tr("Choose %1").arg(modelNameText(name)));
  }
}

QString ComparePresenter::chosenText() const {
  const angle::ModelName& name = m_document.choices().selected;
  const QString what = tr("Chosen: %1, %2 entries, %3 bytes")
                           .arg(modelNameText(name))
                           .arg(name.storageEntries())
                           .arg(name.storageBytes());
  if (const auto rows = comparison()) {
    const auto row = std::ranges::find(rows->rows, name, &angle::ComparisonRow::name);
    if (row != rows->rows.end()) {
      return tr("%1; leaves %2 at most, %3 rms against the curve.")
          .arg(what, degrees(row->maxErrorFineDeg.value_or(row->maxErrorDeg)), degrees(row->rmsErrorDeg));
    }
  }
  return what + QLatin1Char('.');
}

std::shared_ptr<const angle::Comparison> ComparePresenter::comparison() const { return m_document.comparison(); }

QString ComparePresenter::missing() const {
  if (comparison()) {
    return {};
  }
  if (m_document.runError()) {
    return fromText(m_document.runError()->message());
  }
  return m_document.sweep().size() == 0 ? tr("There are no readings yet: capture a sweep or import a CSV file.")
                                        : tr("The methods are being compared.");
}

QString ComparePresenter::progressText() const {
  if (!comparison() || m_document.comparisonComplete()) {
    return {};
  }
  return tr("Minimax and the fine grid are being computed: %1 %").arg(static_cast<int>(m_progress * 100.0));
}

void ComparePresenter::onChoices() {
  const AngleChoices previous = std::exchange(m_known, m_document.choices());
  AngleChoices sameButDemands = m_known;
  sameButDemands.targetErrorDeg = previous.targetErrorDeg;
  sameButDemands.budgetEntries = previous.budgetEntries;
  const bool onlyDemands = sameButDemands == previous;
  if (!onlyDemands) {
    rebuild();
    return;
  }
  if (m_figure) {
    for (PlotGuide& guide : m_figure->spec.guides) {
      if (guide.draggable) {
        guide.value = guideValue(guide.id);
      }
    }
  }
  emit demandsChanged();
}

void ComparePresenter::rebuild() {
  m_figure.reset();
  emit figureChanged();
  emit demandsChanged();
}

} // namespace straightedge::gui
