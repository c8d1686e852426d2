#include "app/gui/steps/verdict_banner.h"

#include "app/gui/steps/step_colors.h"

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

namespace straightedge::gui {

using Outcome = VerifyPresenter::Outcome;

namespace {

StepColor colorOf(Outcome outcome) {
  switch (outcome) {
  case Outcome::Passed:
    return StepColor::Good;
  case Outcome::Failed:
    return StepColor::Bad;
  case Outcome::PassedInDoubt:
  case Outcome::FailedInDoubt:
    return StepColor::Warning;
  case Outcome::None:
    return StepColor::Quiet;
  }
  return StepColor::Quiet;
}

QString wordOf(Outcome outcome) {
  switch (outcome) {
  case Outcome::Passed:
    return VerdictBanner::tr("Passed");
  case Outcome::PassedInDoubt:
    return VerdictBanner::tr("Passed, within uncertainty");
  case Outcome::Failed:
    return VerdictBanner::tr("Failed");
  case Outcome::FailedInDoubt:
    return VerdictBanner::tr("Failed, within uncertainty");
  case Outcome::None:
    return VerdictBanner::tr("Not verified yet");
  }
  return {};
}

} // namespace

VerdictBanner::VerdictBanner(QWidget* parent)
    : QWidget(parent), m_word(new QLabel(this)), m_sentence(new QLabel(this)), m_rule(new QLabel(this)) {
  m_word->setObjectName(QStringLiteral("verdictWord"));
  m_sentence->setObjectName(QStringLiteral("verdictSentence"));
  m_rule->setObjectName(QStringLiteral("decisionRule"));
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 1.7);
  large.setWeight(QFont::DemiBold);
  m_word->setFont(large);
  for (QLabel* label : {m_sentence, m_rule}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 10, 14, 10);
  layout->setSpacing(3);
  layout->addWidget(m_word);
  layout->addWidget(m_sentence);
  layout->addWidget(m_rule);
}

void VerdictBanner::setVerdict(Outcome outcome, const QString& sentence, const QString& rule) {
  m_outcome = outcome;
  m_word->setText(wordOf(outcome));
  m_sentence->setText(sentence);
  m_rule->setText(rule);
  m_rule->setVisible(!rule.isEmpty());
  m_sentence->setVisible(rule.isEmpty()); // the rule says it again, with the uncertainty
  update();
}

void VerdictBanner::paintEvent(QPaintEvent* /*event*/) {
  constexpr int edge = 6;
  QPainter painter(this);
  const QColor color = stepColor(*this, colorOf(m_outcome));
  QColor ground = color;
  ground.setAlpha(30);
  painter.fillRect(rect(), ground);
  painter.fillRect(QRect(0, 0, edge, height()), color);
}

} // namespace straightedge::gui
