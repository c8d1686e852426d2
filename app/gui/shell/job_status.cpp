#include "app/gui/shell/job_status.h"

#include "app/gui/jobs/job_runner.h"
#include "app/gui/shell/line_icon.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace straightedge::gui {

JobStatus::JobStatus(JobRunner& jobs, QWidget* parent)
    : QWidget(parent), m_jobs(jobs), m_content(new QWidget(this)), m_label(new QLabel(m_content)),
      m_bar(new QProgressBar(m_content)) {
  setObjectName("jobStatus");
  auto* outer = new QHBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(m_content);
  auto* layout = new QHBoxLayout(m_content);
  layout->setContentsMargins(0, 0, 4, 0);
  layout->addWidget(m_label);
  m_bar->setTextVisible(false);
  m_bar->setFixedSize(140, 12);
  layout->addWidget(m_bar);
  auto* cancel = new QToolButton(m_content);
  cancel->setObjectName("cancelJob");
  cancel->setAutoRaise(true);
  cancel->setIcon(lineIcon("close"));
  cancel->setToolTip(tr("Cancel this computation"));
  cancel->setAccessibleName(tr("Cancel the running computation"));
  layout->addWidget(cancel);
  m_content->hide();

  m_patience.setSingleShot(true);
  m_patience.setInterval(250);
  connect(&m_patience, &QTimer::timeout, this, &JobStatus::refresh);
  connect(cancel, &QToolButton::clicked, this, [this] {
    if (!m_order.isEmpty()) {
      m_jobs.cancel(m_order.first());
    }
  });
  connect(&jobs, &JobRunner::jobStarted, this, [this](const QString& key, const QString& title) {
    m_running.insert(key, {title});
    m_order.append(key);
    if (m_content->isHidden()) {
      if (!m_patience.isActive()) {
        m_patience.start();
      }
    } else {
      refresh();
    }
  });
  connect(&jobs, &JobRunner::jobProgress, this, [this](const QString& key, double fraction) {
    m_running[key].fraction = fraction;
    if (!m_content->isHidden()) {
      refresh();
    }
  });
  connect(&jobs, &JobRunner::jobEnded, this, [this](const QString& key) {
    m_running.remove(key);
    m_order.removeAll(key);
    if (m_order.isEmpty()) {
      m_patience.stop();
    }
    if (!m_content->isHidden()) {
      refresh();
    }
  });
}

void JobStatus::refresh() {
  m_content->setVisible(!m_order.isEmpty());
  if (m_order.isEmpty()) {
    return;
  }
  const Job& job = m_running[m_order.first()];
  const auto more = m_order.size() - 1;
  m_label->setText(more == 0 ? job.title : tr("%1 (and %2 more)").arg(job.title).arg(more));
  m_bar->setRange(0, job.fraction < 0.0 ? 0 : 1000);
  if (job.fraction >= 0.0) {
    m_bar->setValue(static_cast<int>(job.fraction * 1000.0));
  }
}

} // namespace straightedge::gui
