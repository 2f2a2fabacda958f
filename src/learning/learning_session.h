#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "learning/checkpointer.h"
#include "learning/checks.h"
#include "learning/fair_mutex.h"
#include "learning/learn_options.h"
#include "learning/learning_phase.h"
#include "learning/learning_run.h"
#include "repertoire/repertoire.h"
#include "robot/robot_description.h"
#include "transferability/trial_robot.h"

namespace hexapod {

/// How far a session is.
struct LearningStatus {
  LearningPhase phase = LearningPhase::kEvolving;
  EvolutionCounters counters;
  std::int64_t simulations = 0;  ///< behaviours simulated, in earlier processes as well
  std::int64_t known =
      0;  ///< candidates of this process that were not simulated: gaits seen before
  std::int64_t evaluations_budget = 0;
  double time_budget_s = 0.0;      ///< 0: none
  std::int64_t entries = 0;        ///< those that were dropped excluded
  std::int64_t dropped = 0;        ///< entries left out, since they do not hold in ODE
  std::int64_t trials = 0;         ///< behaviours tried on the robot
  std::int64_t checked = 0;        ///< behaviours that the check under way has played
  std::int64_t to_check = 0;       ///< and those it plays
  double elapsed_s = 0.0;          ///< spent evolving
  double evaluations_per_s = 0.0;  ///< over the time spent evolving
  double left_s = 0.0;             ///< about so long to the end of all phases
  HistoryRow last;                 ///< the newest row of the history
};

/// A learning run from the first random genome to the checked repertoire in its file: evolution,
/// simulation on all cores, history, checkpoints, checks of the entries.
///
/// With the option `resume` it goes on from the last checkpoint of a run that was stopped or
/// killed, and ends with the same entries as if nothing had happened. A run that had been finished
/// stays as it is, unless it is given a larger budget, other checks or `check_again`: then it
/// evolves further, and is checked anew. (More evaluations later give the same as more at once if
/// the former number was a multiple of a generation's candidates, so that no generation was cut
/// short.)
///
/// run() does the work in the thread that calls it. requestStop() and saveNow() may be called from
/// any thread; everything else belongs to the thread of run(), that is, to its hooks.
class LearningSession {
 public:
  struct Hooks {
    /// Called after each generation, now and then while checking (then perhaps by another thread,
    /// one at a time), and when all is done. May wait: then so does the run.
    std::function<void(const LearningSession&)> progress;
    /// Called when a checkpoint could not be written; learning goes on, the next one is tried.
    std::function<void(const std::string& problem)> save_failed;
    /// Called after each behaviour tried on the robot with what it did, as a sentence.
    std::function<void(const std::string& sentence)> tried;
    /// Called when one could not be tried, with the reason; learning goes on without it.
    std::function<void(const std::string& problem)> trial_failed;
  };

  /// Claims repertoire_file (RepertoireWriter). Throws std::invalid_argument for options that do
  /// not fit or not be those of the run to be resumed, std::runtime_error for a file that cannot be
  /// written or that holds a repertoire while neither `overwrite` nor `resume` is set.
  /// Evaluations are spread over this process and the workers, each of which runs workFor(); waits
  /// until they have introduced themselves. Checks are this process' alone.
  /// With the option transferability behaviours are tried on `trial_robot`, which must outlive the
  /// session, or on a simulated one where robot_body names its body; std::invalid_argument without
  /// either.
  LearningSession(const RobotDescription& robot, const LearnOptions& options, Stopwatch clock,
                  const DistributedEvaluator::Workers& workers = {},
                  TrialRobot* trial_robot = nullptr);

  /// Evolves until the budget is used up, checks, saves. Returns true when all was done, false when
  /// requestStop() ended it early; the last whole generation is saved then. Either way
  /// saveProblem() tells whether the file holds it. Throws std::runtime_error telling what became
  /// of the candidates when all was done for no entry.
  bool run(const Hooks& hooks);

  /// Ends run() within one simulated behaviour.
  void requestStop() { stop_ = true; }

  /// Writes the file as soon as the generation under way has ended, in any other phase, before or
  /// after run() at once. Returns why that failed, as a sentence, or nothing.
  std::string saveNow();

  /// Why what is known is not in the file, as a sentence, or nothing: what was last to be saved
  /// was.
  std::string saveProblem() const;

  /// Before run(): a sentence for the user about what `resume` found or what the run begins with,
  /// or empty without either.
  std::string startRemark() const;

  /// A sentence for the user when ODE does not confirm some entries, which are left out, or empty.
  std::string verificationRemark() const;

  /// A sentence for the user about the engine (EngineChoice::remark), or empty.
  const std::string& engineRemark() const { return run_.engine().remark; }

  LearningStatus status() const;

  /// One row now and then, the oldest first.
  const std::vector<HistoryRow>& history() const { return run_.history(); }

  /// The repertoire as it is now.
  Repertoire repertoire() const { return run_.repertoire(); }

 private:
  bool evolve(const Hooks& hooks);
  bool evolveOneGeneration();
  void tryOnRobot(const Hooks& hooks);
  void tryOne(const Hooks& hooks);
  void addHeldOut();
  bool checkEntries(const Hooks& hooks);
  void enter(LearningPhase phase);
  void saveIfDue(const Hooks& hooks);
  void save(const Hooks& hooks);
  /// The time since the last lap was spent evolving. With mutex_ taken.
  void lap();

  LearnOptions options_;
  Stopwatch clock_;
  std::unique_ptr<TrialRobot> simulated_robot_;  // in place of a real one, or none
  TrialRobot* trial_robot_;
  std::atomic<bool> stop_{false};
  mutable FairMutex mutex_;  // whoever changes run_ or phase_, or uses checkpointer_, has it
  RunStart start_;
  Checkpointer checkpointer_;
  LearningRun run_;
  LearningPhase phase_;
  double lap_s_ = 0.0;  // up to here time spent evolving is counted
  std::atomic<std::int64_t> checked_{0};
  std::atomic<std::int64_t> to_check_{0};
  double check_began_s_ = 0.0;  // later by what the hook waited for
};

}  // namespace hexapod
