#include "learning/learning_report.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/text.h"
#include "geometry/pose2.h"

namespace hexapod {
namespace {

std::string timeLeft(const LearningStatus& status) {
  return fixedText(status.left_s, 0) + " s left";
}

std::string describeEvolving(const LearningStatus& status) {
  std::string line = "Learning: " + std::to_string(status.counters.evaluations);
  // A run that only its time limits has a budget nobody reads.
  if (status.time_budget_s <= 0.0) line += " of " + std::to_string(status.evaluations_budget);
  return line + ", " + describeBriefly(status);
}

}  // namespace

std::string describeBriefly(const LearningStatus& status) {
  if (status.phase != LearningPhase::kEvolving) return describe(status);
  std::string text;
  if (status.last.evaluations > 0) {
    text = "trained: sparseness " + fixedText(100.0 * status.last.sparseness_m, 2) + " cm, " +
           fixedText(status.last.median_orientation_error_rad / kDegree, 2) + " deg, ";
  }
  text += std::to_string(status.entries) + " entries, ";
  if (status.trials > 0) text += std::to_string(status.trials) + " tried on the robot, ";
  return text + timeLeft(status);
}

std::string describe(const LearningStatus& status) {
  const std::string checked =
      std::to_string(status.checked) + " of " + std::to_string(status.to_check);
  if (status.phase == LearningPhase::kVerifying) {
    return "Verifying: " + checked + " entries replayed in ODE, " + timeLeft(status);
  }
  if (status.phase == LearningPhase::kValidating) {
    return "Validating: " + checked + " executions, " + timeLeft(status);
  }
  if (status.phase == LearningPhase::kTryingWorlds) {
    return "Trying other worlds: " + checked + " executions, " + timeLeft(status);
  }
  if (status.phase == LearningPhase::kTransferring) {
    return "Transferring: what " + std::to_string(status.trials) +
           " trials tell of where the robot takes the entries";
  }
  if (status.phase != LearningPhase::kDone) return describeEvolving(status);
  std::string line = "Done: " + std::to_string(status.counters.evaluations) + " evaluations, " +
                     fixedText(status.evaluations_per_s, 0) + "/s, " +
                     std::to_string(status.entries) + " entries";
  if (status.last.evaluations > 0) {
    line += ", sparseness " + fixedText(100.0 * status.last.sparseness_m, 2) +
            " cm, orientation error " +
            fixedText(status.last.median_orientation_error_rad / kDegree, 2) +
            " deg where it learned";
  }
  if (status.last.held_out) {
    line += " (" + fixedText(100.0 * status.last.held_out->sparseness_m, 2) + " cm, " +
            fixedText(status.last.held_out->median_orientation_error_rad / kDegree, 2) +
            " deg in other worlds)";
  }
  return line + "; " + std::to_string(status.simulations) + " simulations, " +
         std::to_string(status.known) + " gaits known.";
}

std::string nothingLearned(const EvolutionCounters& counters, std::size_t dropped) {
  const std::int64_t walked =
      counters.evaluations - counters.fell - counters.self_collided - counters.diverged;
  std::string sentence = "Nothing was learned: of " + std::to_string(counters.evaluations) +
                         " candidates " + std::to_string(counters.fell) + " fell, " +
                         std::to_string(counters.self_collided) + " touched a leg with another, " +
                         std::to_string(counters.diverged) + " blew up";
  if (counters.failed_later > 0) {
    sentence += " (" + std::to_string(counters.failed_later) +
                " of these only under perturbed physics or after other behaviours)";
  }
  sentence += " and " + std::to_string(walked) + " walked";
  if (dropped > 0) {
    return sentence + "; ODE confirms none of the " + std::to_string(dropped) + " entries.";
  }
  if (walked > 0) sentence += ", none to a new place (novelty_threshold_m is too large for it)";
  return sentence + ". import_robot tells how a robot stands and walks.";
}

double fractionDone(const LearningStatus& status) {
  if (status.phase == LearningPhase::kDone) return 1.0;
  const auto part = [](double done, double whole) { return whole > 0.0 ? done / whole : 1.0; };
  if (status.phase != LearningPhase::kEvolving) {
    return part(static_cast<double>(status.checked), static_cast<double>(status.to_check));
  }
  const double of_evaluations = part(static_cast<double>(status.counters.evaluations),
                                     static_cast<double>(status.evaluations_budget));
  const double of_time = status.time_budget_s > 0.0 ? status.elapsed_s / status.time_budget_s : 0.0;
  return std::max(of_evaluations, of_time);
}

}  // namespace hexapod
