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
                                       const std::atomic<bool>& cancelled,
                                       const DistributedEvaluator::Workers& workers)
    : symmetries_(usedSymmetries(worlds->robot(), options)),
      own_{runId(worlds->robot(), resultOptions(options)), worlds->threads(), ""},
      nominal_(worlds, options.behavior, &cancelled),
      robust_(nominal_, worlds, options.behavior, options.robustness,
              static_cast<std::uint64_t>(options.seed), &cancelled),
      distributed_(robust_, own_, workers, cancelled, options.worker_patience_s),
      cached_(distributed_, static_cast<std::size_t>(options.cached_genomes), symmetries_) {}

void CandidateEvaluator::serveFor(Channel& master) {
  serve(master, own_, robust_, [this] { return simulations(); });
}

std::int64_t CandidateEvaluator::simulations() const {
  return nominal_.counts().simulations + robust_.simulations() + distributed_.remoteSimulations();
}

}  // namespace hexapod
