// Running jobs in the status bar: what, how far, and a button that cancels.
#pragma once

#include <QMap>
#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;

namespace straightedge::gui {

class JobRunner;

/// Shows the oldest job that has been running for more than a moment, and how many more there are.
class JobStatus : public QWidget {
  Q_OBJECT
public:
  explicit JobStatus(JobRunner& jobs, QWidget* parent = nullptr);

private:
  struct Job {
    QString title;
    double fraction = -1.0; ///< negative: not known
  };
  void refresh();

  JobRunner& m_jobs;
  QMap<QString, Job> m_running;
  QList<QString> m_order;
  QTimer m_patience; ///< jobs shorter than this are not worth a flicker
  QWidget* m_content;
  QLabel* m_label;
  QProgressBar* m_bar;
};

} // namespace straightedge::gui
