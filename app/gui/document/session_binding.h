// Keeps the session file in step with the open calibration: what changed is written soon after, in one go.
#pragma once

#include "core/session/session.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace straightedge::gui {

/// GUI thread. Owns the session. A change is written at most 250 ms later (a drag is written once), and by flush().
class SessionBinding : public QObject {
  Q_OBJECT
public:
  explicit SessionBinding(QObject* parent = nullptr);
  ~SessionBinding() override;

  void attach(std::unique_ptr<session::Session> session);
  session::Session* session() const { return m_session.get(); }
  /// Commits what is pending, checkpoints, closes. The session is gone afterwards, whatever came of it.
  Result<void> close();

  /// `write` is called with the session when it is time; a later one of the same name replaces it.
  void schedule(const std::string& name, std::function<Result<void>(session::Session&)> write);
  /// Writes what is pending now. What fails stays pending. On read-only media nothing is written and nothing fails
  /// until the calibration is saved elsewhere.
  Result<void> flush();
  using Pending = std::map<std::string, std::function<Result<void>(session::Session&)>>;
  Pending takePending() { return std::exchange(m_pending, {}); } ///< what read-only media did not take
  void putPending(Pending pending) { m_pending = std::move(pending); }
  void dropPending() { m_pending.clear(); }
  bool hasPending() const { return !m_pending.empty(); }
  bool hasFailed() const { return m_failed; }

signals:
  void failed(const QString& message); ///< once per run of failures
  void written();                      ///< what was pending is in the file

private:
  std::unique_ptr<session::Session> m_session;
  Pending m_pending;
  QTimer m_timer;
  bool m_failed = false;
};

} // namespace straightedge::gui
