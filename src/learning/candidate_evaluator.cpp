#include "learning/candidate_evaluator.h"

#include <algorithm>

namespace hexapod {
namespace {

// A leg that is out of order, or a slope, leaves no image of the robot.
bool isLopsided(const Physics& physics) {
  return physics.slope_x_rad != 0.0 || physics.slope_y_rad != 0.0 ||
         std::any_of(physics.legs.begin(), physics.legs.end(),
                     [](const LegState& leg) { return leg.condition != LegCondition::kIntact; });
}

std::vector<Symmetry> usedSymmetries(const WorldPool& worlds, const LearnOptions& options) {
  if (!options.evolution.offer_twins || isLopsided(worlds.physics())) return {};
  return symmetriesOf(worlds.robot(), static_cast<std::size_t>(options.behavior.gene_levels));
}

// What a candidate is evaluated to does not depend on those that the run began with.
std::string nameOfWork(const RobotDescription& robot, LearnOptions options) {
  options.from.clear();
  return runId(robot, resultOptions(options));
}

}  // namespace

CandidateEvaluator::CandidateEvaluator(const std::shared_ptr<WorldPool>& worlds,
                                       const LearnOptions& options,
                                       const std::atomic<bool>& cancelled,
                                       const DistributedEvaluator::Workers& workers)
    : symmetries_(usedSymmetries(*worlds, options)),
      own_{nameOfWork(worlds->robot(), options), worlds->threads(), ""},
      nominal_(worlds, options.behavior, &cancelled),
      robust_(nominal_, worlds, options.behavior, options.robustness,
              static_cast<std::uint64_t>(options.seed), &cancelled),
      distributed_(robust_, own_, workers, cancelled, options.worker_patience_s),
      cached_(distributed_, static_cast<std::size_t>(options.cached_genomes),
              gaitsOf(worlds->robot(), options.behavior), symmetries_) {}

void CandidateEvaluator::serveFor(Channel& master) {
  serve(master, own_, robust_, [this] { return simulations(); });
}

LaneUse CandidateEvaluator::use() const {
  const LaneUse first = nominal_.use(), further = robust_.use();
  return {first.register_steps + further.register_steps, first.lane_steps + further.lane_steps};
}

std::int64_t CandidateEvaluator::simulations() const {
  return nominal_.counts().simulations + robust_.simulations() + distributed_.remoteSimulations();
}

}  // namespace hexapod
