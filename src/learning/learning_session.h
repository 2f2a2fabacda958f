#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "evaluation/assessment.h"
#include "evaluation/validation.h"
#include "evolution/br_evolution.h"
#include "learning/candidate_evaluator.h"
#include "learning/learn_options.h"
#include "learning/learning_phase.h"
#include "learning/resume.h"
#include "repertoire/repertoire.h"
#include "repertoire/repertoire_writer.h"
#include "robot/robot_description.h"

namespace hexapod {

/// How far a session is.
struct LearningStatus {
  LearningPhase phase = LearningPhase::kEvolving;
  EvolutionCounters counters;
  std::int64_t simulations = 0;  ///< behaviours simulated, in earlier processes as well
  std::int64_t known =
      0;  ///< candidates of this process that were not simulated: gaits seen before
  std::int64_t evaluations_budget = 0;
  double time_budget_s = 0.0;  ///< 0: none
  std::int64_t entries = 0;    ///< those that were dropped excluded
  std::int64_t entries_verified = 0;
  std::int64_t entries_dropped = 0;  ///< since they do not hold in ODE
  std::int64_t entries_validated = 0;
  double elapsed_s = 0.0;          ///< spent evolving
  double evaluations_per_s = 0.0;  ///< over the time spent evolving
  double eta_s = 0.0;              ///< to the end of evolution; 0 once it has ended
  HistoryRow last;                 ///< the newest row of the history
};

/// A learning run from the first random genome to the validated repertoire in its file: evolution,
/// simulation on all cores, history, checkpoints, validation.
///
/// With the option `resume` it goes on from the last checkpoint of a run that was stopped or
/// killed, and ends with the same entries as if nothing had happened. A run that had been finished
/// stays as it is, unless it is given a larger budget: then it evolves further and validates all
/// anew. (More evaluations later give the same as more at once if the former number was a multiple
/// of population_size, so that no generation was cut short.)
///
/// run() does the work in the thread that calls it. requestStop() and requestSave() may be called
/// from any thread; everything else belongs to the thread of run(), that is, to its hooks.
class LearningSession {
 public:
  /// Seconds on a clock that never goes back.
  using Clock = std::function<double()>;

  struct Hooks {
    /// Called after each generation, now and then while validating (then perhaps by another thread,
    /// one at a time), and when all is done.
    std::function<void(const LearningSession&)> progress;
    /// Called when a checkpoint could not be written; learning goes on, the next one is tried.
    std::function<void(const std::string& problem)> save_failed;
  };

  /// Claims repertoire_file (RepertoireWriter). Throws std::invalid_argument for options that do
  /// not fit or not be those of the run to be resumed, std::runtime_error for a file that cannot be
  /// written or that holds a repertoire while neither `overwrite` nor `resume` is set.
  /// Evaluations are spread over this process and the workers, each of which runs workFor(); waits
  /// until they have introduced themselves. Validation is this process' alone.
  LearningSession(const RobotDescription& robot, const LearnOptions& options, Clock clock,
                  const DistributedEvaluator::Workers& workers = {});

  /// Evolves until the budget is used up, validates, saves. Returns true when all was done, false
  /// when requestStop() ended it early; the file then holds the last whole generation.
  bool run(const Hooks& hooks);

  /// Ends run() within one simulated behaviour.
  void requestStop() { stop_ = true; }

  /// Asks for a checkpoint at the end of the generation under way.
  void requestSave() { save_ = true; }

  /// Before run(): a sentence for the user about what `resume` found, or empty without it.
  std::string resumeRemark() const;

  /// A sentence for the user when ODE does not confirm some entries, which are left out, or empty.
  std::string verificationRemark() const;

  /// A sentence for the user about the engine (EngineChoice::remark), or empty.
  const std::string& engineRemark() const { return engine_.remark; }

  LearningStatus status() const;

  /// The repertoire as it is now.
  Repertoire repertoire() const;

 private:
  void goOn();
  bool budgetIsLeft() const;
  std::int64_t simulations() const;
  void lap();
  bool evolve(const Hooks& hooks);
  bool verifyEntries(const Hooks& hooks);
  bool validateEntries(const Hooks& hooks);
  bool resimulateEntries();
  /// Throws EvaluationCancelled when asked to stop.
  std::vector<TrialResult> tryHeldOut(const std::vector<Entry>& entries);
  std::vector<Entry> keptEntries() const;
  void recordHistory();
  void addHeldOut();
  bool checkpointIsDue() const;
  void save(const Hooks& hooks);

  RobotDescription robot_;
  LearnOptions options_;
  Clock clock_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> save_{false};
  RepertoireWriter writer_;
  std::optional<Resumed> resumed_;  // the run as it was found
  EngineChoice engine_;
  std::shared_ptr<WorldPool> worlds_;
  CandidateEvaluator evaluator_;
  BrEvolution evolution_;
  LearningPhase phase_ = LearningPhase::kEvolving;
  std::vector<HistoryRow> history_;
  std::vector<Execution> executions_;         // per kept entry; empty until validated
  std::set<std::int64_t> dropped_;            // ids of entries that do not hold in ODE
  std::map<std::string, std::string> facts_;  // of verification
  std::int64_t entries_verified_ = 0;
  std::int64_t entries_validated_ = 0;
  double evolved_s_ = 0.0;  // spent evolving, in earlier processes as well
  double lap_s_ = 0.0;      // up to here evolved_s_ is counted
  double saved_s_ = 0.0;
  double save_cost_s_ = 0.0;  // of the last save
};

}  // namespace hexapod
