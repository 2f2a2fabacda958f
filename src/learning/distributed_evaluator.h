#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evolution/evaluator.h"
#include "learning/channel.h"
#include "learning/work_message.h"

namespace hexapod {

/// Spreads batches over this process and others that evaluate in the same way, in proportion to
/// their threads. As an outcome depends on its genome alone, it makes no difference to the result
/// who simulated what: a worker that answers no more is given up, and this process does its part.
/// Without other processes it is the local evaluator.
class DistributedEvaluator : public Evaluator {
 public:
  using Workers = std::vector<std::shared_ptr<Channel>>;

  /// Waits for the workers' introductions; `own` is this process'. A worker is waited for
  /// `patience_s`, 0: for ever. Throws std::runtime_error for a worker that cannot work, does not
  /// introduce itself or was started for another run (other options, another robot),
  /// EvaluationCancelled when cancelled meanwhile. References must outlive the evaluator.
  DistributedEvaluator(Evaluator& local, const Introduction& own, const Workers& workers,
                       const std::atomic<bool>& cancelled, double patience_s = 0.0);

  /// Throw EvaluationCancelled when cancelled, here or at a worker, and std::runtime_error when a
  /// worker could not do its part, naming it.
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override;
  int looks() const override { return local_->looks(); }
  std::vector<Outcome> lookAgain(int look, const std::vector<Genome>& genomes,
                                 const std::vector<Outcome>& previous) override;

  /// Behaviours simulated by the workers so far.
  std::int64_t remoteSimulations() const { return remote_simulations_; }

 private:
  std::vector<Outcome> spread(const Questions& whole);
  /// Nothing from a worker that is given up herewith.
  std::optional<Result> receiveFrom(std::size_t worker);
  /// The end of the part of process `p` of a batch; process 0 is this one.
  std::size_t endOfPart(std::size_t p, std::size_t batch) const;

  Evaluator* local_;
  Workers workers_;                    // empty where one was given up
  std::vector<std::int64_t> threads_;  // per process; 0 for those that were given up
  const std::atomic<bool>* cancelled_;
  double patience_s_;
  std::int64_t remote_simulations_ = 0;
};

/// The other side: introduces itself and answers one part after another until an empty message
/// comes. `simulations` counts what the evaluator has simulated so far. What throws
/// EvaluationCancelled here ends the run as a whole.
void serve(Channel& master, const Introduction& own, Evaluator& evaluator,
           const std::function<std::int64_t()>& simulations);

}  // namespace hexapod
