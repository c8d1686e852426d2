#include "app/gui/field_steps/field_verify_presenter.h"

#include "app/gui/field_steps/field_page_figures.h"
#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/figures/field_report_tables.h"
#include "app/gui/figures/figure_parts.h"
#include "app/gui/jobs/job_runner.h"
#include "core/field/campaign_csv.h"

#include <algorithm>
#include <array>

namespace straightedge::gui {

FieldVerifyPresenter::FieldVerifyPresenter(FieldDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs) {
  connect(&document, &FieldDocument::opened, this, [this] { setProblem({}); });
  connect(&document, &FieldDocument::campaignChanged, this, &FieldVerifyPresenter::changed);
  connect(&document, &FieldDocument::choicesChanged, this, &FieldVerifyPresenter::changed);
  connect(&document, &FieldDocument::runChanged, this, &FieldVerifyPresenter::changed);
  connect(&document, &FieldDocument::verificationCampaignChanged, this, &FieldVerifyPresenter::changed);
  connect(&document, &FieldDocument::verificationChanged, this, &FieldVerifyPresenter::changed);
}

void FieldVerifyPresenter::setLimitPercent(double percent) {
  FieldChoices choices = m_document.choices();
  choices.limitPercent = percent;
  if (percent > 0.0) {
    m_document.setChoices(choices, tr("Set the limit"));
  }
}

void FieldVerifyPresenter::setPercentOf(field::PercentOf of) {
  FieldChoices choices = m_document.choices();
  choices.percentOf = of;
  m_document.setChoices(choices, tr("Choose what the limit refers to"));
}

void FieldVerifyPresenter::loadCsv(const QString& file) {
  m_jobs.run<field::Campaign>(
      QStringLiteral("load-field-verification"), tr("Reading the campaign"),
      [path = file.toStdString()](const JobControl&) -> Result<field::Campaign> {
        Result<field::Campaign> campaign = field::readCampaignCsv(path);
        const auto verifies = [](const field::CampaignRow& row) {
          return row.step == field::CampaignStep::Verification;
        };
        if (campaign && std::ranges::none_of(campaign->rows, verifies)) {
          return fail(ErrorKind::Input, "the campaign has no rows of the step verification",
                      "record that step: known fields at several temperatures", campaign->name);
        }
        return campaign;
      },
      [this](Result<field::Campaign> campaign) {
        if (campaign) {
          m_document.setVerificationCampaign(std::move(*campaign));
        }
        setProblem(campaign ? QString() : fromText(campaign.error().message()));
      });
}

void FieldVerifyPresenter::forgetFresh() {
  if (hasFresh()) {
    m_document.setVerificationCampaign({});
    setProblem({});
  }
}

bool FieldVerifyPresenter::hasFresh() const { return !m_document.verificationCampaign().rows.empty(); }

QString FieldVerifyPresenter::campaignText() const {
  const auto& report = m_document.verification();
  if (!hasFresh() && !report) {
    return {};
  }
  QString text;
  if (hasFresh()) {
    const std::string& name = m_document.verificationCampaign().name;
    text = name.empty() ? tr("A fresh campaign, captured on a bench") : fromText(name);
  } else {
    text = tr("The campaign's own verification rows");
  }
  if (report) {
    const field::FieldVerification& verified = report->verification;
    text += tr(": %1 readings").arg(verified.points);
    if (verified.unlocked > 0) {
      text += tr("; %1 left out, reference not locked").arg(verified.unlocked);
    }
    if (verified.incomplete > 0) {
      text += tr("; %1 left out, a temperature is missing").arg(verified.incomplete);
    }
  }
  return text + QLatin1Char('.');
}

FieldVerifyPresenter::Outcome FieldVerifyPresenter::outcome() const {
  const auto& report = m_document.verification();
  return !report ? Outcome::None : report->met ? Outcome::Passed : Outcome::Failed;
}

QString FieldVerifyPresenter::verdictText() const {
  if (const auto& report = m_document.verification()) {
    const QString sentence = report->met ? tr("Largest error %1 (axis %2), limit %3; before correction %4.")
                                         : tr("Largest error %1 (axis %2) exceeds the limit %3; before correction %4.");
    return sentence.arg(percentPhrase(report->peakPercent), axisWord(report->worstAxis),
                        percentPhrase(report->limitPercent), percentPhrase(report->peakBeforePercent));
  }
  if (m_document.verificationError()) {
    return fromText(m_document.verificationError()->message());
  }
  if (const QString first = missing(); !first.isEmpty()) {
    return first;
  }
  return tr("The campaign has no verification rows: load a fresh campaign that has some.");
}

QString FieldVerifyPresenter::ruleText() const {
  if (!m_document.verification()) {
    return {};
  }
  const QString of =
      percentOf() == field::PercentOf::FullScale
          ? tr("Percent of full scale, %1 T.")
                .arg(m_document.run() ? m_document.run()->result.chain.fullScaleT : m_document.choices().fullScaleT)
          : tr("Percent of reading, for fields of at least %1 % of full scale.").arg(field::leastOfReading * 100.0);
  return verdictText() + QLatin1Char(' ') + of;
}

QList<NamedFigure> FieldVerifyPresenter::figures() const {
  static constexpr std::array topics{FigureTopic::Verification};
  return m_document.verification() ? figuresAbout(m_document, topics) : QList<NamedFigure>{};
}

PlotSpec FieldVerifyPresenter::emptyPlot() const {
  return emptyFigure(tr("Error before and after correction"), dataAxis(tr("Reference field (T)")),
                     dataAxis(tr("Error (% of full scale)")), {});
}

ReportTable FieldVerifyPresenter::table() const {
  const auto& report = m_document.verification();
  return report ? fieldVerificationTable(report->verification.rows, report->of) : ReportTable{};
}

QString FieldVerifyPresenter::missing() const {
  if (m_document.run()) {
    return {};
  }
  return m_document.campaign().rows.empty()
             ? tr("There is no calibration yet: capture a campaign or import a CSV file first.")
             : tr("The calibration is not computed: see the step Fit.");
}

void FieldVerifyPresenter::setProblem(const QString& problem) {
  m_problem = problem;
  emit changed();
}

} // namespace straightedge::gui
