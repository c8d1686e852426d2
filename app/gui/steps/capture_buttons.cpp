#include "app/gui/steps/capture_buttons.h"

#include <QHBoxLayout>
#include <QMessageBox>
#include <QPushButton>

#include <utility>

namespace straightedge::gui {

namespace {

QPushButton* captureButton(QWidget* parent, const QString& text, const QString& name) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  return made;
}

} // namespace

CaptureButtons::CaptureButtons(QWidget* parent)
    : QWidget(parent), m_continue(captureButton(this, tr("&Go on"), QStringLiteral("continueCapture"))),
      m_start(captureButton(this, {}, QStringLiteral("startCapture"))),
      m_pause(captureButton(this, {}, QStringLiteral("pauseCapture"))),
      m_stop(captureButton(this, tr("S&top"), QStringLiteral("stopCapture"))),
      m_connect(captureButton(this, tr("Go to Connect"), QStringLiteral("goToConnect"))),
      m_next(captureButton(this, {}, QStringLiteral("goOn"))) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  for (QPushButton* each : {m_continue, m_start, m_pause, m_stop, m_connect}) {
    row->addWidget(each);
  }
  row->addStretch(1);
  row->addWidget(m_next);
  connect(m_start, &QPushButton::clicked, this, &CaptureButtons::startWanted);
  connect(m_continue, &QPushButton::clicked, this, &CaptureButtons::continueWanted);
  connect(m_pause, &QPushButton::clicked, this, &CaptureButtons::pauseWanted);
  connect(m_stop, &QPushButton::clicked, this, &CaptureButtons::stopWanted);
  connect(m_connect, &QPushButton::clicked, this, [this] { emit stepWanted(tr("Connect")); });
  connect(m_next, &QPushButton::clicked, this, [this] { emit stepWanted(m_nextStep); });
  showState({});
}

void CaptureButtons::showState(const State& state) {
  m_start->setVisible(!state.capturing && state.hasBench);
  m_start->setEnabled(state.canStart);
  m_start->setText(state.replaces ? tr("St&art over…") : tr("St&art")); // Alt+S is the menu's
  m_start->setDefault(state.hasBench && !state.capturing && !state.canContinue && !state.complete);
  m_continue->setVisible(state.canContinue);
  m_continue->setDefault(state.canContinue);
  m_pause->setVisible(state.capturing && !state.waits);
  m_pause->setText(state.canResume ? tr("&Resume") : tr("&Pause"));
  m_stop->setVisible(state.capturing);
  m_connect->setVisible(!state.hasBench);
  m_nextStep = state.nextStep;
  m_next->setVisible(!m_nextStep.isEmpty());
  m_next->setText(tr("Go on to %1").arg(m_nextStep));
  m_next->setDefault(state.complete);
}

void askToReplace(QWidget& page, const ReplaceQuestion& question, const QString& text, std::function<void()> replace) {
  auto* box = new QMessageBox(QMessageBox::Warning, question.title, text, QMessageBox::Cancel, &page);
  box->setObjectName(question.objectName);
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* yes = box->addButton(CaptureButtons::tr("Replace"), QMessageBox::DestructiveRole);
  box->setDefaultButton(QMessageBox::Cancel);
  QObject::connect(yes, &QPushButton::clicked, &page, std::move(replace));
  box->open();
}

} // namespace straightedge::gui
