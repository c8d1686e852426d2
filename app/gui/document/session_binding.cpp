#include "app/gui/document/session_binding.h"

#include <chrono>
#include <utility>

namespace straightedge::gui {

using namespace std::chrono_literals;

namespace {
constexpr auto writeDelay = 250ms;
constexpr auto retryDelay = 5s; // a full disk may have room again
} // namespace

SessionBinding::SessionBinding(QObject* parent) : QObject(parent) {
  m_timer.setSingleShot(true);
  connect(&m_timer, &QTimer::timeout, this, [this] { static_cast<void>(flush()); }); // failures are signalled
}

SessionBinding::~SessionBinding() {
  if (m_session) {
    static_cast<void>(flush());
  }
}

void SessionBinding::attach(std::unique_ptr<session::Session> session) {
  m_session = std::move(session);
  m_pending.clear();
  m_failed = false;
}

Result<void> SessionBinding::close() {
  m_timer.stop();
  if (!m_session) {
    return {};
  }
  auto written = flush();
  auto closed = m_session->close();
  m_session.reset();
  m_pending.clear();
  m_failed = false;
  return written ? closed : written;
}

void SessionBinding::schedule(const std::string& name, std::function<Result<void>(session::Session&)> write) {
  if (!m_session) {
    return;
  }
  m_pending.insert_or_assign(name, std::move(write));
  if (!m_timer.isActive()) {
    m_timer.start(writeDelay);
  }
}

Result<void> SessionBinding::flush() {
  m_timer.stop();
  if (!m_session || m_session->readOnly()) {
    return {};
  }
  Result<void> outcome;
  const bool hadPending = !m_pending.empty();
  for (auto next = m_pending.begin(); next != m_pending.end();) {
    auto written = next->second(*m_session);
    if (written) {
      next = m_pending.erase(next);
    } else {
      outcome = std::move(written);
      ++next;
    }
  }
  const bool failedBefore = std::exchange(m_failed, !outcome);
  if (!outcome) {
    m_timer.start(retryDelay);
    if (!failedBefore) {
      emit failed(QString::fromStdString(outcome.error().message()));
    }
  } else if (hadPending || failedBefore) {
    emit written();
  }
  return outcome;
}

} // namespace straightedge::gui
