#include "app/gui/jobs/job_runner.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include <atomic>
#include <semaphore>
#include <stdexcept>

namespace straightedge::gui {

class JobRunnerTest : public QObject {
  Q_OBJECT
private slots:
  void resultComesBackInTheGuiThread();
  void aNewJobOfTheSameKeyOvertakesTheOld();
  void aCancelledJobDeliversNothing();
  void progressIsReported();
  void anExceptionBecomesAnError();
  void idleComesAfterTheLastJob();
  void theDestructorWaitsForRunningWork();
};

namespace {
/// Work that runs until it is told to stop.
Result<int> untilStopped(const JobControl& control, std::binary_semaphore* started) {
  if (started != nullptr) {
    started->release();
  }
  while (!control.stopRequested()) {
    QThread::yieldCurrentThread();
  }
  return fail(ErrorKind::Cancelled, "stopped", "");
}
} // namespace

void JobRunnerTest::resultComesBackInTheGuiThread() {
  JobRunner runner;
  QThread* worked = nullptr;
  QThread* delivered = nullptr;
  int value = 0;
  QSignalSpy idle(&runner, &JobRunner::idle);
  runner.run<int>(
      "a", "A",
      [&](const JobControl&) -> Result<int> {
        worked = QThread::currentThread();
        return 42;
      },
      [&](Result<int> result) {
        delivered = QThread::currentThread();
        value = result.value_or(-1);
      });
  QVERIFY(runner.isRunning("a"));
  QVERIFY(idle.wait(60000));
  QCOMPARE(value, 42);
  QCOMPARE(delivered, thread());
  QVERIFY(worked != thread());
  QVERIFY(!runner.isRunning("a"));
}

void JobRunnerTest::aNewJobOfTheSameKeyOvertakesTheOld() {
  JobRunner runner;
  std::binary_semaphore started{0};
  QList<int> delivered;
  const auto deliver = [&](Result<int> result) { delivered << result.value_or(-1); };
  QSignalSpy ended(&runner, &JobRunner::jobEnded);
  runner.run<int>("a", "first", [&](const JobControl& control) { return untilStopped(control, &started); }, deliver);
  started.acquire();
  QSignalSpy idle(&runner, &JobRunner::idle);
  runner.run<int>("a", "second", [](const JobControl&) -> Result<int> { return 2; }, deliver);
  QVERIFY(idle.wait(60000));
  QCOMPARE(delivered, QList<int>{2});
  QCOMPARE(ended.count(), 2);
  QCOMPARE(ended[0][1].toBool(), true); // the first was cancelled
  QCOMPARE(ended[1][1].toBool(), false);
}

void JobRunnerTest::aCancelledJobDeliversNothing() {
  JobRunner runner;
  std::binary_semaphore started{0};
  bool delivered = false;
  QSignalSpy ended(&runner, &JobRunner::jobEnded);
  QSignalSpy idle(&runner, &JobRunner::idle);
  runner.run<int>(
      "a", "A", [&](const JobControl& control) { return untilStopped(control, &started); },
      [&](Result<int>) { delivered = true; });
  started.acquire();
  runner.cancel("a");
  QVERIFY(!runner.busy());
  QCOMPARE(ended.count(), 1);
  QCOMPARE(idle.count(), 1);
  // A second job passes through the same queue: whatever the first one posted has been handled when it is done.
  QSignalSpy secondIdle(&runner, &JobRunner::idle);
  runner.run<int>("b", "B", [](const JobControl&) -> Result<int> { return 1; }, [](Result<int>) {});
  QVERIFY(secondIdle.wait(60000));
  QVERIFY(!delivered);
}

void JobRunnerTest::progressIsReported() {
  JobRunner runner;
  QSignalSpy progress(&runner, &JobRunner::jobProgress);
  QSignalSpy idle(&runner, &JobRunner::idle);
  runner.run<int>(
      "a", "A",
      [](const JobControl& control) -> Result<int> {
        for (int i = 0; i < 10000; ++i) {
          control.report(i / 10000.0);
        }
        control.report(1.0);
        return 0;
      },
      [](Result<int>) {});
  QVERIFY(idle.wait(60000));
  QVERIFY(progress.count() >= 2);
  QVERIFY(progress.count() < 5000); // throttled: the event loop is not flooded
  QCOMPARE(progress.last()[1].toDouble(), 1.0);
}

void JobRunnerTest::anExceptionBecomesAnError() {
  JobRunner runner;
  std::optional<Error> error;
  QSignalSpy idle(&runner, &JobRunner::idle);
  runner.run<int>(
      "a", "A", [](const JobControl&) -> Result<int> { throw std::runtime_error("out of luck"); },
      [&](Result<int> result) { error = result.error(); });
  QVERIFY(idle.wait(60000));
  QVERIFY(error.has_value());
  QVERIFY(error->what.find("out of luck") != std::string::npos);
}

void JobRunnerTest::idleComesAfterTheLastJob() {
  JobRunner runner;
  QSignalSpy idle(&runner, &JobRunner::idle);
  int done = 0;
  // The first one's delivery starts the next: there is no idle moment between them.
  runner.run<int>(
      "a", "A", [](const JobControl&) -> Result<int> { return 1; },
      [&](Result<int>) {
        ++done;
        runner.run<int>("b", "B", [](const JobControl&) -> Result<int> { return 2; }, [&](Result<int>) { ++done; });
      });
  QVERIFY(idle.wait(60000));
  QCOMPARE(done, 2);
  QCOMPARE(idle.count(), 1);
}

void JobRunnerTest::theDestructorWaitsForRunningWork() {
  std::binary_semaphore started{0};
  std::atomic<bool> finished = false;
  {
    JobRunner runner;
    runner.run<int>(
        "a", "A",
        [&](const JobControl& control) {
          auto result = untilStopped(control, &started);
          finished = true;
          return result;
        },
        [](Result<int>) { QFAIL("delivered to nobody"); });
    started.acquire();
  }
  QVERIFY(finished);
}

} // namespace straightedge::gui

QTEST_GUILESS_MAIN(straightedge::gui::JobRunnerTest)
#include "job_runner_test.moc"
