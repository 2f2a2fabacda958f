#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "evaluation/behavior_evaluator.h"
#include "evaluation/cached_evaluator.h"
#include "evaluation/robust_evaluator.h"
#include "learning/distributed_evaluator.h"
#include "learning/learn_options.h"

namespace hexapod {

/// The evaluator of a learning run, put together as its options ask: a run from the stand, the
/// perturbations on top of it, spread over the workers there are, and a cache in front of all.
class CandidateEvaluator {
 public:
  /// The robot's symmetries, none unless twins are offered: without them the paper's algorithm
  /// runs on simulated outcomes only. None, too, of a body with a leg out of order, or on a slope.
  /// Waits for the workers (see DistributedEvaluator). Throws std::invalid_argument when options do
  /// not fit.
  CandidateEvaluator(const std::shared_ptr<WorldPool>& worlds, const LearnOptions& options,
                     const std::atomic<bool>& cancelled,
                     const DistributedEvaluator::Workers& workers = {});

  Evaluator& evaluator() { return cached_; }

  /// Works for another process' session with the same options until that sends the end.
  void serveFor(Channel& master);

  const std::vector<Symmetry>& symmetries() const { return symmetries_; }

  /// Candidates so far that were not simulated: their gaits, or images of them, were known.
  std::int64_t known() const { return cached_.counts().saved(); }

  /// Behaviours simulated so far, by the workers as well.
  std::int64_t simulations() const;

  /// How full the registers of this process were.
  LaneUse use() const;

 private:
  std::vector<Symmetry> symmetries_;
  Introduction own_;
  BehaviorEvaluator nominal_;
  RobustEvaluator robust_;
  DistributedEvaluator distributed_;
  CachedEvaluator cached_;
};

}  // namespace hexapod
