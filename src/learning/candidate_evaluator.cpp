#include "learning/candidate_evaluator.h"

namespace hexapod {
namespace {

std::vector<Symmetry> usedSymmetries(const RobotDescription& robot, const LearnOptions& options) {
  if (!options.evolution.offer_twins) return {};
  return symmetriesOf(robot);
}

}  // namespace

CandidateEvaluator::CandidateEvaluator(std::shared_ptr<WorldPool> worlds,
                                       const LearnOptions& options,
                                       const std::atomic<bool>& cancelled)
    : symmetries_(usedSymmetries(worlds->robot(), options)),
      nominal_(worlds, options.behavior, &cancelled),
      robust_(nominal_, worlds, options.behavior, options.robustness,
              static_cast<std::uint64_t>(options.seed), &cancelled),
      cached_(robust_, static_cast<std::size_t>(options.cached_genomes), symmetries_) {}

std::int64_t CandidateEvaluator::simulations() const {
  return nominal_.counts().simulations + robust_.simulations();
}

}  // namespace hexapod
