// A field document with a quick simulated campaign in a scratch session, and waiting for its results by signals.
#pragma once

#include "app/gui/document/field_bench_link.h"
#include "app/gui/document/field_document.h"
#include "app/gui/jobs/job_runner.h"
#include "core/field/campaign_csv.h"
#include "devices/simulated/hall_campaign.h"

#include <QStandardPaths>
#include <QTest>

namespace straightedge::gui::testing {

inline constexpr int patienceMs = 120000; ///< only a failing test waits so long

/// As if read from a file: rows know their lines.
inline field::Campaign quickCampaign(std::uint64_t seed, const char* name = "probe.csv") {
  const auto made = devices::makeHallCampaign(devices::quickHallCampaign(seed));
  auto read = field::parseCampaignCsv(field::campaignCsv(made), name, name);
  if (!read) {
    qFatal("%s", read.error().message().c_str());
  }
  return std::move(*read);
}

struct OpenFieldDocument {
  JobRunner jobs;
  FieldDocument document{jobs};
  FieldBenchLink bench{document};

  OpenFieldDocument() {
    QStandardPaths::setTestModeEnabled(true);
    if (!document.createScratch()) {
      qFatal("no scratch file");
    }
  }
  ~OpenFieldDocument() {
    jobs.cancelAll();
    if (!document.discard()) {
      qWarning("the scratch file stays");
    }
  }
  OpenFieldDocument(const OpenFieldDocument&) = delete;
  OpenFieldDocument& operator=(const OpenFieldDocument&) = delete;

  /// True when calibration and verification are in.
  bool load(field::Campaign campaign = quickCampaign(7)) {
    document.setCampaign(std::move(campaign), QStringLiteral("Import"));
    return settle() && document.run() != nullptr;
  }
  bool settle() {
    const auto quiet = [this] {
      QCoreApplication::processEvents(); // what a finished job has asked for begins with the next turn
      return !jobs.busy();
    };
    return QTest::qWaitFor([&] { return quiet() && quiet() && quiet(); }, patienceMs);
  }
};

} // namespace straightedge::gui::testing
