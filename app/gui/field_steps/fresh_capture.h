// Capturing a fresh campaign to verify with: its plan, whether it can be begun, begun or gone on with. No widgets.
#pragma once

#include "app/gui/document/field_bench_link.h"

#include <QObject>
#include <QString>

namespace straightedge::gui {

class FieldDocument;

/// GUI thread. The step Capture shows how it goes.
class FreshCapture : public QObject {
  Q_OBJECT
public:
  FreshCapture(FieldDocument& document, FieldBenchLink& bench, QObject* parent = nullptr);

  /// The stages of step verification of the document's plan; the usual ones where it has none.
  devices::FieldPlan plan() const;
  bool isRunning() const;
  bool isInterrupted() const { return m_interrupted.has_value(); } ///< the session holds the beginning of one
  QString cannot() const;                                          ///< why it cannot be begun; empty where it can
  void start();                                                    ///< or goes on where it was interrupted
  QString problem() const { return m_problem; }                    ///< of the last start()

signals:
  void changed();

private:
  void look();

  FieldDocument& m_document;
  FieldBenchLink& m_bench;
  std::optional<devices::FieldPlan> m_interrupted;
  bool m_running = false;
  QString m_problem;
};

} // namespace straightedge::gui
