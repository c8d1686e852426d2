// A document with the 32-point side-shaft sweep in a scratch session, and waiting for its results by signals.
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/document/bench_link.h"
#include "app/gui/jobs/job_runner.h"
#include "tests/app/gui/figures/example_results.h"

#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>

namespace straightedge::gui::testing {

inline constexpr int patienceMs = 60000; ///< only a failing test waits so long

struct OpenDocument {
  JobRunner jobs;
  AngleDocument document{jobs};
  BenchLink bench{document};

  OpenDocument() {
    QStandardPaths::setTestModeEnabled(true);
    valueOf2(document.createScratch());
  }
  ~OpenDocument() {
    jobs.cancelAll();
    bench.disconnectBench();
    valueOf2(document.discard());
  }
  OpenDocument(const OpenDocument&) = delete;
  OpenDocument& operator=(const OpenDocument&) = delete;

  /// Loads the sweep; true when calibration and comparison, minimax included, are in.
  bool load() {
    document.setSweep(exampleSweep(), QStringLiteral("Import"));
    return QTest::qWaitFor([this] { return document.run() && document.comparison() && document.comparisonComplete(); },
                           patienceMs);
  }
  bool settle() {
    QCoreApplication::processEvents();
    return QTest::qWaitFor([this] { return !jobs.busy(); }, patienceMs);
  }

private:
  static void valueOf2(const Result<void>& result) {
    if (!result) {
      qFatal("%s", result.error().message().c_str());
    }
  }
};

} // namespace straightedge::gui::testing
