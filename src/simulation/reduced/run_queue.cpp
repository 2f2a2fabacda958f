#include "simulation/reduced/run_queue.h"

#include <utility>

namespace hexapod {

RunQueue::RunQueue(const std::vector<BatchRun>& runs, std::function<void(std::size_t)> ended,
                   const std::atomic<bool>* cancelled)
    : runs_(&runs), ended_(std::move(ended)), cancelled_(cancelled), results_(runs.size()) {}

std::optional<std::size_t> RunQueue::take() {
  if (cancelled_ != nullptr && *cancelled_) return std::nullopt;
  const std::size_t run = next_++;
  return run < runs_->size() ? std::optional<std::size_t>(run) : std::nullopt;
}

void RunQueue::finish(std::size_t run, BatchResult result) {
  results_[run] = std::move(result);
  if (!ended_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  ended_(++count_ended_);
}

}  // namespace hexapod
