// Anything over 50 ms runs here: a const snapshot goes in, a result comes back in the GUI thread, with progress and
// cancel.
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <QObject>
#include <QString>

#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace straightedge::gui {

/// GUI thread owns it and calls it; only `work` runs elsewhere. A cancelled job's `done` is never called. `key` names
/// what the job computes: starting a job cancels the one of the same key that still runs, and its result is dropped.
/// The window shows running jobs with progress and a cancel button.
class JobRunner : public QObject {
  Q_OBJECT
public:
  explicit JobRunner(QObject* parent = nullptr);
  ~JobRunner() override; ///< cancels and joins everything

  template <typename T>
  void run(const QString& key, const QString& title, std::function<Result<T>(const JobControl&)> work,
           std::function<void(Result<T>)> done) {
    auto result = std::make_shared<std::optional<Result<T>>>();
    start(
        key, title,
        [work = std::move(work), result](const JobControl& control) {
          try {
            result->emplace(work(control));
          } catch (const std::exception& problem) { // e.g. out of memory: must not end the program from a pool thread
            result->emplace(fail(ErrorKind::Input, std::string("the computation failed: ") + problem.what(),
                                 "try again with less data"));
          }
        },
        [done = std::move(done), result] { done(std::move(**result)); });
  }
  void cancel(const QString& key);
  void cancelAll();
  bool busy() const;
  bool isRunning(const QString& key) const;

signals:
  void jobStarted(const QString& key, const QString& title);
  void jobProgress(const QString& key, double fraction);
  void jobEnded(const QString& key, bool cancelled);
  void idle(); ///< the last job ended

private:
  void start(const QString& key, const QString& title, std::function<void(const JobControl&)> work,
             std::function<void()> deliver);
  bool cancelQuietly(const QString& key); ///< without idle(); true where such a job ran
  void takeEvents();
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
