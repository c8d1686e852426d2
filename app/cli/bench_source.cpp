#include "app/cli/bench_source.h"

#include "devices/bench/saved_bench.h"
#include "devices/instruments/profile_files.h"

#include <algorithm>
#include <utility>

namespace straightedge::cli {

namespace {

const char* benchDocument(session::SweepRole role) {
  return role == session::SweepRole::Calibration ? "bench" : "verification-bench";
}

/// What decides the readings. Ports, speeds and latencies may be corrected between two runs.
bool measuresAlike(const devices::BenchInstrument& a, const devices::BenchInstrument& b) {
  return a.instrument == b.instrument && a.roles == b.roles && a.serial == b.serial && a.settings == b.settings;
}

} // namespace

Result<BenchSource> BenchSource::find(const std::string& name) {
  BenchSource source;
  if (name != "simulated") {
    auto saved = devices::readBench(name);
    if (!saved) {
      return std::unexpected(std::move(saved.error()));
    }
    source.m_saved = *std::move(saved);
  }
  return source;
}

Result<void> BenchSource::open(const devices::BenchDialogueListener& listener) {
  if (isSimulated()) {
    return {};
  }
  auto opened = devices::OpenedBench::open(*m_saved, devices::readProfiles(devices::userProfileFolder()), {}, listener);
  if (!opened) {
    return std::unexpected(std::move(opened.error()));
  }
  m_opened = *std::move(opened);
  return {};
}

Result<void> BenchSource::note(session::Session& session, session::SweepRole role) const {
  return isSimulated() ? Result<void>{} : session.setDocument(benchDocument(role), devices::benchToJson(*m_saved));
}

Result<void> BenchSource::checkSame(const session::Session& session, session::SweepRole role) const {
  const std::string file = session.file().string();
  const auto noted = session.document(benchDocument(role));
  if (!noted) {
    return std::unexpected(noted.error());
  }
  if (isSimulated() && noted->empty()) {
    return {};
  }
  if (noted->empty()) {
    return fail(ErrorKind::Usage, "the session was begun on the simulated bench",
                "give --bench simulated, or begin a new session", file);
  }
  const auto before = devices::benchFromJson(*noted, file);
  if (!before) {
    return std::unexpected(before.error());
  }
  if (isSimulated()) {
    return fail(ErrorKind::Usage,
                "the session was begun on the bench '" + before->name + "' and not on the simulated one",
                "give --bench " + before->name, file);
  }
  if (!std::ranges::equal(before->instruments, m_saved->instruments, measuresAlike)) {
    return fail(ErrorKind::Usage, "the session was begun with other instruments or other settings of them",
                "go on with the bench as it was, or begin a new session", file);
  }
  return {};
}

} // namespace straightedge::cli
