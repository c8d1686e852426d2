// The verdict in large letters on a tinted ground: passed, failed, in doubt, or nothing yet.
#pragma once

#include "app/gui/steps/verify_presenter.h"

#include <QWidget>

class QLabel;

namespace straightedge::gui {

class VerdictBanner : public QWidget {
  Q_OBJECT
public:
  explicit VerdictBanner(QWidget* parent = nullptr);
  void setVerdict(VerifyPresenter::Outcome outcome, const QString& sentence, const QString& rule);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  VerifyPresenter::Outcome m_outcome = VerifyPresenter::Outcome::None;
  QLabel* m_word;
  QLabel* m_sentence;
  QLabel* m_rule;
};

} // namespace straightedge::gui
