#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "evaluation/robust_options.h"
#include "evaluation/robust_worlds.h"
#include "evolution/evaluator.h"
#include "evolution/genome_space.h"

namespace hexapod {

/// Evaluates genomes as they are executed: not only from a perfect start in one world.
///
/// The first look is another evaluator's: one run under nominal conditions, with
/// first_look_handicap_rad on top of its orientation error. The second look adds runs under
/// perturbed physics and runs that start after other behaviours, in turn, and gives the whole: the
/// mean end pose of all runs, and as cost the mean of their orientation errors plus
/// spread_weight_rad_per_m times the spread of the end positions. Any failure is a failure. With
/// screening_runs the second look adds only so many of these runs, and a third one the others.
///
/// Where the quality is steadiness, the spread of the headings takes the place of the orientation
/// errors. One run has no spread: a first look costs the handicap alone.
///
/// Perturbations and start states are drawn once, from the seed: an outcome depends on its genome
/// alone, whatever the number of threads.
class RobustEvaluator : public Evaluator {
 public:
  /// Nominal physics are the pool's. Throws std::invalid_argument when options do not fit, and for
  /// steadiness without runs to see it by.
  /// `nominal` and `cancelled`, if given, must outlive the evaluator.
  RobustEvaluator(Evaluator& nominal, const std::shared_ptr<WorldPool>& pool,
                  const BehaviorOptions& behavior, const RobustnessOptions& options,
                  std::uint64_t seed, const std::atomic<bool>* cancelled = nullptr);

  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override;
  int looks() const override;
  std::vector<Outcome> lookAgain(int look, const std::vector<Genome>& genomes,
                                 const std::vector<Outcome>& previous) override;

  /// Runs added to those of the first looks so far.
  std::int64_t simulations() const { return simulations_; }

  /// How full the registers of these runs were.
  LaneUse use() const { return worlds_.use(); }

 private:
  std::size_t runsUntil(int look) const;
  std::vector<Outcome> seenBefore(int look, const Genome& genome, const Outcome& previous) const;
  RobustWorlds::Run run(std::size_t number, std::size_t genome) const;
  Outcome atFirst(const Outcome& nominal) const;
  Outcome whole(const std::vector<Outcome>& outcomes) const;
  bool goesOnStanding(const WorldState& state);
  void prepareStartStates();

  Evaluator* nominal_;
  RobustnessOptions options_;
  std::uint64_t seed_;
  PlayHooks hooks_;
  RobustWorlds worlds_;  // physics 0 is the nominal one
  GenomeSpace gaits_;
  std::vector<WorldState> start_states_;
  // What all runs of the last second look gave, the nominal one first. Sparing, not necessary: a
  // third look at other genomes simulates them anew.
  std::map<Genome, std::vector<Outcome>> screened_;
  std::int64_t simulations_ = 0;
};

}  // namespace hexapod
