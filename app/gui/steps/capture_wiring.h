// What the steps Capture of every kind do alike between their presenter, the buttons and the page.
#pragma once

#include "app/gui/steps/capture_buttons.h"
#include "app/gui/steps/notice_list.h"
#include "app/gui/steps/step_page.h"

#include <QList>
#include <QObject>
#include <QString>

namespace straightedge::gui {

/// Leads the buttons to presenter and page; before rows or readings are replaced, it is asked.
template <typename Presenter>
void wireCaptureButtons(StepPage& page, Presenter& presenter, CaptureButtons& buttons,
                        const ReplaceQuestion& question) {
  QObject::connect(&buttons, &CaptureButtons::startWanted, &page, [&page, &presenter, question] {
    if (presenter.startReplacesData()) {
      askToReplace(page, question, presenter.replaceQuestion(), [&presenter] { presenter.start(); });
    } else {
      presenter.start();
    }
  });
  QObject::connect(&buttons, &CaptureButtons::continueWanted, &presenter, &Presenter::continueInterrupted);
  QObject::connect(&buttons, &CaptureButtons::pauseWanted, &page, [&presenter] {
    if (presenter.canResume()) {
      presenter.resume();
    } else {
      presenter.pause();
    }
  });
  QObject::connect(&buttons, &CaptureButtons::stopWanted, &presenter, &Presenter::stop);
  QObject::connect(&buttons, &CaptureButtons::stepWanted, &page, &StepPage::goToStep);
}

/// `waits`: for an instrument that was unplugged.
template <typename Presenter>
CaptureButtons::State captureState(const Presenter& presenter, bool waits) {
  return {.hasBench = presenter.phase() != Presenter::Phase::NoBench,
          .capturing = presenter.canStop(),
          .waits = waits,
          .canStart = presenter.canStart(),
          .replaces = presenter.startReplacesData(),
          .canContinue = presenter.canContinueInterrupted(),
          .canResume = presenter.canResume(),
          .complete = presenter.isComplete(),
          .nextStep = presenter.nextStep()};
}

/// What went wrong; milder where it passes by itself once the instrument is back.
inline QList<Notice> captureNotices(const QString& problem, bool waits) {
  return problem.isEmpty() ? QList<Notice>{}
                           : QList<Notice>{{waits ? Notice::Level::Warning : Notice::Level::Problem, problem}};
}

} // namespace straightedge::gui
