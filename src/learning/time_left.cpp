#include "learning/time_left.h"

#include <algorithm>

#include "learning/checks.h"

namespace hexapod {
namespace {

double evolutionLeft_s(const LearningRun& run) {
  const LearnOptions& options = run.options();
  const auto evaluated = static_cast<double>(run.counters().evaluations);
  const double left = static_cast<double>(options.evaluations) - evaluated;
  double left_s = left > 0.0 && evaluated > 0.0 ? run.elapsed_s() / evaluated * left : 0.0;
  if (options.time_budget_s > 0.0) {
    const double time_left_s = std::max(0.0, options.time_budget_s - run.elapsed_s());
    left_s = run.elapsed_s() > 0.0 ? std::min(left_s, time_left_s) : time_left_s;
  }
  return left_s;
}

// Its own speed counts more and more, and alone once so much of it is done.
constexpr double kTelling = 0.25;

double checkLeft_s(const CheckProgress& check, double expected_s) {
  if (check.checked == 0) return std::max(0.0, expected_s - check.elapsed_s);
  const double share = static_cast<double>(check.checked) / static_cast<double>(check.to_check);
  const double trust = std::min(1.0, share / kTelling);
  return trust * check.elapsed_s / share + (1.0 - trust) * expected_s - check.elapsed_s;
}

}  // namespace

double timeLeft_s(const LearningRun& run, LearningPhase phase, const CheckProgress& check) {
  if (phase == LearningPhase::kDone) return 0.0;
  const auto simulations = static_cast<double>(run.simulations());
  const double simulation_s = simulations > 0.0 ? run.elapsed_s() / simulations : 0.0;
  double left_s = phase == LearningPhase::kEvolving ? evolutionLeft_s(run) : 0.0;
  for (const Check& later : checks()) {
    if (later.phase < phase || !later.is_wanted(run)) continue;
    const double expected_s = simulation_s * later.cost(run);
    left_s += later.phase == phase ? checkLeft_s(check, expected_s) : expected_s;
  }
  return left_s;
}

}  // namespace hexapod
