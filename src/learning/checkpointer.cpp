#include "learning/checkpointer.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hexapod {
namespace {

// Of the time, at most this part goes into writing checkpoints.
constexpr double kCheckpointShare = 0.01;

}  // namespace

Checkpointer::Checkpointer(const std::string& file, double period_s, Stopwatch clock)
    : period_s_(period_s), clock_(std::move(clock)), writer_(file) {}

bool Checkpointer::isDue() const {
  if (period_s_ <= 0.0) return true;
  return clock_() - tried_s_ >= std::max(period_s_, cost_s_ / kCheckpointShare);
}

void Checkpointer::save(const Repertoire& repertoire, const LearnerState& state) {
  const double begin_s = clock_();
  try {
    writer_.save(repertoire, state);
    problem_.clear();
  } catch (const std::runtime_error& error) {
    problem_ = error.what();
  }
  tried_s_ = clock_();
  cost_s_ = tried_s_ - begin_s;
}

}  // namespace hexapod
