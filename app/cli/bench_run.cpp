#include "app/cli/bench_run.h"

#include "app/cli/dialogue_folder.h"

#include <utility>

namespace straightedge::cli {

Result<void> runOnBench(const CaptureOptions& options,
                        const std::function<Result<void>(BenchSource&, CaptureWatch&)>& capture) {
  DialogueFolder dialogues(options.dialogues); // outlives the bench, which tells it everything
  auto source = BenchSource::find(options.bench);
  if (!source) {
    return std::unexpected(std::move(source.error()));
  }
  if (source->isSimulated() && !options.dialogues.empty()) {
    return fail(ErrorKind::Usage, "--record-dialogue: nothing is said with a simulated bench",
                "leave the option out, or give a bench with instruments");
  }
  if (auto made = dialogues.make(); !made) {
    return made;
  }
  CaptureWatch watch(options.waitS); // before any thread is started; libusb starts one
  auto outcome = source->open(dialogues.listener());
  if (outcome) {
    outcome = capture(*source, watch);
  }
  dialogues.tell(); // above all where something went wrong
  return outcome;
}

} // namespace straightedge::cli
