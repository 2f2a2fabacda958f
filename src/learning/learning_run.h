#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "evolution/generational.h"
#include "learning/candidate_evaluator.h"
#include "learning/checkpoint.h"
#include "learning/learn_options.h"
#include "learning/resume.h"
#include "learning/warm_start.h"
#include "repertoire/repertoire.h"
#include "robot/robot_description.h"
#include "simulation/world.h"
#include "transferability/disparity_model.h"

namespace hexapod {

/// What a check of the entries found, by the ids of the entries.
struct Findings {
  std::set<std::int64_t> dropped;  ///< do not hold and are left out
  std::map<std::int64_t, Execution> executions;
  std::map<std::string, std::string> facts;
  std::optional<HeldOut> held_out;
};

/// From where a run starts: with neither, from random candidates.
struct RunStart {
  std::optional<Resumed> resumed;  ///< the run that is to be gone on with
  std::optional<WarmStart> warm;   ///< of a new run
};

/// All that a learning run has found so far: population and archive, what checks said of the
/// entries, history, time spent. One thread at a time.
class LearningRun {
 public:
  /// A new run, or the one that is to be gone on with: from where it was, or, given a larger budget
  /// or other checks, without what its checks had found. Throws as CandidateEvaluator does.
  LearningRun(const RobotDescription& robot, const LearnOptions& options, const RunStart& start,
              const std::atomic<bool>& cancelled, const DistributedEvaluator::Workers& workers);

  const RobotDescription& robot() const { return robot_; }
  const LearnOptions& options() const { return options_; }
  const EngineChoice& engine() const { return engine_; }
  const std::shared_ptr<WorldPool>& worlds() const { return worlds_; }
  const EvolutionCounters& counters() const { return algorithm_->counters(); }
  const std::vector<HistoryRow>& history() const { return history_; }
  const HistoryRow* newestRow() const { return history_.empty() ? nullptr : &history_.back(); }
  std::int64_t simulations() const { return earlier_simulations_ + evaluator_.simulations(); }
  std::int64_t known() const { return evaluator_.known(); }
  LaneUse laneUse() const { return evaluator_.use(); }
  /// Spent evolving, in earlier processes as well.
  double elapsed_s() const { return elapsed_s_; }

  bool budgetIsLeft() const;

  /// One generation, cut short where the budget ends. Throws EvaluationCancelled when cancelled;
  /// nothing of the generation is kept then.
  void step();
  void spend(double time_s) { elapsed_s_ += time_s; }
  /// A row for what the run is now, unless there is one.
  void recordHistory();

  /// All entries of the archive, those that were dropped as well, as they were learned.
  const std::vector<Entry>& learned() const { return algorithm_->entries(); }
  /// The entries that were not dropped, with their executions.
  std::vector<Entry> entries() const;
  std::size_t dropped() const { return dropped_.size(); }

  /// Behaviours that were tried on the robot, the first one first.
  const std::vector<RobotTrial>& trials() const { return trials_; }
  /// What they tell; nothing before the first.
  const std::shared_ptr<const DisparityModel>& disparities() const { return disparities_; }
  /// Whether one is to be tried before the next generation.
  bool isTrialDue() const;
  /// The entry to try. There must be entries.
  const Entry& entryToTry() const;
  /// What became of it, by which evolution goes on. Nothing: it was not played; the others of its
  /// series are not tried either.
  void addTrial(const std::optional<RobotTrial>& trial);

  /// Adds what a check found.
  void add(const Findings& findings);

  /// The phase that a run which is gone on with was in.
  LearningPhase phaseFound() const { return phase_found_; }

  Repertoire repertoire() const;
  Checkpoint checkpoint(LearningPhase phase) const;

 private:
  void goOn(const Resumed& resumed);
  std::int64_t attemptsDue() const;
  FeatureScales featureScales() const;
  void learnFromTrials();

  RobotDescription robot_;
  LearnOptions options_;
  EngineChoice engine_;
  std::shared_ptr<WorldPool> worlds_;
  CandidateEvaluator evaluator_;
  std::unique_ptr<Generational> algorithm_;
  LearningPhase phase_found_ = LearningPhase::kEvolving;
  std::vector<HistoryRow> history_;
  std::map<std::int64_t, Execution> executions_;  // by id of the entry
  std::set<std::int64_t> dropped_;                // ids of entries
  std::map<std::string, std::string> facts_;
  std::vector<RobotTrial> trials_;
  std::int64_t trial_attempts_ = 0;
  std::shared_ptr<const DisparityModel> disparities_;
  std::int64_t earlier_simulations_ = 0;
  double elapsed_s_ = 0.0;
};

}  // namespace hexapod
