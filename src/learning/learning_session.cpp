#include "learning/learning_session.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "common/half_decade.h"
#include "common/text.h"
#include "geometry/pose2.h"
#include "learning/learning_report.h"
#include "learning/resume.h"
#include "learning/time_left.h"
#include "simulation/body_text.h"
#include "transferability/simulated_trial_robot.h"

namespace hexapod {
namespace {

// A row of history costs a few milliseconds; a thousand candidates cost seconds.
constexpr std::int64_t kEvaluationsPerHistoryRow = 1000;

std::string claimed(const LearnOptions& options) {
  if (options.repertoire_file.empty()) {
    throw std::invalid_argument(
        "'repertoire_file' is empty; give the path of the file to learn into, e.g. "
        "repertoire_file:=gaits.db.");
  }
  return options.repertoire_file;
}

/// Before the file is claimed: nothing is left where there is nothing to begin with.
RunStart newRun(const RobotDescription& robot, const LearnOptions& options) {
  RunStart start;
  if (!options.from.empty()) {
    start.warm =
        warmStart(robot, options.from, static_cast<std::size_t>(options.behavior.gene_levels));
  }
  return start;
}

/// `start`, or the run in the file where it is to be gone on with.
const RunStart& decided(RunStart& start, const RobotDescription& robot, const LearnOptions& options,
                        const Checkpointer& checkpointer) {
  if (options.resume && options.overwrite) {
    throw std::invalid_argument(
        "'resume' and 'overwrite' are both true; set one of them to false: a run is either gone on "
        "with or replaced.");
  }
  if (!checkpointer.holdsRepertoire() || options.overwrite) return start;
  if (options.resume) return start = {resume(robot, options), std::nullopt};
  throw std::runtime_error(
      options.repertoire_file +
      " holds a repertoire already. Nothing was changed: choose another "
      "repertoire_file, set resume to true to go on with that run, or overwrite "
      "to true to replace it.");
}

std::unique_ptr<TrialRobot> simulatedRobot(const RobotDescription& robot,
                                           const LearnOptions& options) {
  const TransferOptions& transfer = options.transfer;
  if (!transfer.transferability || transfer.robot_body.empty()) return nullptr;
  return std::make_unique<SimulatedTrialRobot>(
      robot, bodyFromText(robot, transfer.robot_body, nominalPhysics(robot, options)),
      options.behavior);
}

TrialRobot* chosenRobot(const LearnOptions& options, TrialRobot* simulated, TrialRobot* real) {
  TrialRobot* robot = simulated != nullptr ? simulated : real;
  if (!options.transfer.transferability || robot != nullptr) return robot;
  throw std::invalid_argument(
      "'transferability' is true, and there is no robot to try behaviours on: give the body of a "
      "simulated one, e.g. robot_body 'friction: 0.6', or learn beside a running session.");
}

/// "Trial 3: entry 1234 ended 31 mm, 2.1 deg from where it does in simulation."
std::string describeTrial(const RobotTrial& trial, std::size_t number, std::int64_t entry_id) {
  const std::string start =
      "Trial " + std::to_string(number) + ": entry " + std::to_string(entry_id);
  if (!trial.measured) return start + " fell.";
  return start + " ended " + fixedText(1e3 * distance(trial.simulated, *trial.measured), 0) +
         " mm, " + fixedText(headingDistance(trial.simulated, *trial.measured) / kDegree, 1) +
         " deg from where it does in simulation.";
}

}  // namespace

LearningSession::LearningSession(const RobotDescription& robot, const LearnOptions& options,
                                 Stopwatch clock, const DistributedEvaluator::Workers& workers,
                                 TrialRobot* trial_robot)
    : options_(suitedTo(robot, withBudget(options))),
      clock_(std::move(clock)),
      simulated_robot_(simulatedRobot(robot, options_)),
      trial_robot_(chosenRobot(options_, simulated_robot_.get(), trial_robot)),
      start_(newRun(robot, options_)),
      checkpointer_(claimed(options_), options_.checkpoint_period_s, clock_),
      run_(robot, options_, decided(start_, robot, options_, checkpointer_), stop_, workers),
      phase_(run_.phaseFound()) {}

std::string LearningSession::startRemark() const {
  const std::string& file = options_.repertoire_file;
  if (start_.warm && !options_.resume) {
    return "Beginning with the entries of " + options_.from + ": " + start_.warm->name + ".";
  }
  if (!options_.resume) return "";
  if (!start_.resumed) return "There is no run in " + file + " to go on with: it is begun.";
  const std::string size = std::to_string(run_.learned().size()) + " entries after " +
                           std::to_string(run_.counters().evaluations) + " evaluations";
  if (phase_ == LearningPhase::kDone) return "The run in " + file + " is finished: " + size + ".";
  return "Going on with the run in " + file + ": " + size + ".";
}

bool LearningSession::run(const Hooks& hooks) {
  checkpointer_.start();
  lap_s_ = clock_();
  const bool was_done = phase_ == LearningPhase::kDone;
  const bool finished = was_done || (evolve(hooks) && checkEntries(hooks));
  if (finished) enter(LearningPhase::kDone);
  if (!was_done && run_.counters().generations > 0) save(hooks);
  if (hooks.progress) hooks.progress(*this);
  if (finished && run_.entries().empty()) {
    throw std::runtime_error(nothingLearned(run_.counters(), run_.dropped()));
  }
  return finished;
}

bool LearningSession::evolve(const Hooks& hooks) {
  for (;;) {
    tryOnRobot(hooks);
    lap_s_ = clock_();  // whatever the robot or the hook took was not spent evolving
    if (stop_ || !run_.budgetIsLeft()) break;
    const std::int64_t before = run_.counters().evaluations;
    if (!evolveOneGeneration()) return false;
    const std::int64_t now = run_.counters().evaluations;
    if (now >= kEvaluationsPerHistoryRow && halfDecade(now) > before) addHeldOut();
    saveIfDue(hooks);
    if (hooks.progress) hooks.progress(*this);
  }
  if (stop_) return false;
  const std::lock_guard<FairMutex> lock(mutex_);
  run_.recordHistory();
  return true;
}

bool LearningSession::evolveOneGeneration() {
  const std::lock_guard<FairMutex> lock(mutex_);
  const std::int64_t before = run_.counters().evaluations;
  try {
    run_.step();
  } catch (const EvaluationCancelled&) {
    return false;  // the generation under way is given up, nothing of it has been kept
  }
  lap();
  const std::int64_t now = run_.counters().evaluations;
  if (now / kEvaluationsPerHistoryRow > before / kEvaluationsPerHistoryRow) run_.recordHistory();
  return true;
}

void LearningSession::tryOnRobot(const Hooks& hooks) {
  while (!stop_ && run_.isTrialDue()) tryOne(hooks);
}

void LearningSession::tryOne(const Hooks& hooks) {
  const Entry entry = run_.entryToTry();
  const TrialRobot::Result result = trial_robot_->play(entry.genome);
  if (stop_ && !result.was_played) return;  // it was broken off, and will be tried again
  std::optional<RobotTrial> trial;
  if (result.was_played) {
    trial = RobotTrial{run_.counters().evaluations, entry.genome, entry.end_pose, entry.cost,
                       result.start_from_end};
  }
  {
    const std::lock_guard<FairMutex> lock(mutex_);
    run_.addTrial(trial);
  }
  save(hooks);
  if (trial && hooks.tried) hooks.tried(describeTrial(*trial, run_.trials().size(), entry.id));
  if (!trial && hooks.trial_failed) hooks.trial_failed(result.problem);
}

void LearningSession::lap() {
  const double now_s = clock_();
  run_.spend(now_s - lap_s_);
  lap_s_ = now_s;
}

void LearningSession::addHeldOut() {
  if (!options_.resimulate) return;
  try {
    const Findings found = tryOtherWorlds(run_, {nullptr, &stop_});
    const std::lock_guard<FairMutex> lock(mutex_);
    run_.add({{}, {}, {}, found.held_out});
  } catch (const EvaluationCancelled&) {
    // Asked to stop: the row does without.
  }
}

bool LearningSession::checkEntries(const Hooks& hooks) {
  const auto progress = [&](std::size_t done, std::size_t all) {
    checked_ = static_cast<std::int64_t>(done);
    to_check_ = static_cast<std::int64_t>(all);
    const double told_s = clock_();
    if (hooks.progress) hooks.progress(*this);
    check_began_s_ += clock_() - told_s;
  };
  for (const Check& check : checks()) {
    if (!check.is_wanted(run_)) continue;
    enter(check.phase);
    save(hooks);
    try {
      const Findings found = check.find(run_, {progress, &stop_});
      const std::lock_guard<FairMutex> lock(mutex_);
      run_.add(found);
    } catch (const EvaluationCancelled&) {
      return false;
    }
  }
  return true;
}

void LearningSession::enter(LearningPhase phase) {
  const std::lock_guard<FairMutex> lock(mutex_);
  phase_ = phase;
  check_began_s_ = clock_();
  checked_ = to_check_ = 0;
}

void LearningSession::saveIfDue(const Hooks& hooks) {
  bool is_due = false;
  {
    const std::lock_guard<FairMutex> lock(mutex_);
    is_due = checkpointer_.isDue();
  }
  if (is_due) save(hooks);
  const std::lock_guard<FairMutex> lock(mutex_);
  lap();
}

void LearningSession::save(const Hooks& hooks) {
  const std::string problem = saveNow();
  if (!problem.empty() && hooks.save_failed) hooks.save_failed(problem);
}

std::string LearningSession::saveNow() {
  const std::lock_guard<FairMutex> lock(mutex_);
  if (run_.counters().generations == 0) {
    return "Nothing has been learned yet that could be saved: ask again after the first "
           "generation.";
  }
  checkpointer_.save(run_.repertoire(), toLearnerState(run_.checkpoint(phase_)));
  return checkpointer_.problem();
}

std::string LearningSession::saveProblem() const {
  const std::lock_guard<FairMutex> lock(mutex_);
  return checkpointer_.problem();
}

std::string LearningSession::verificationRemark() const {
  if (run_.dropped() == 0) return "";
  return "ODE does not confirm " + std::to_string(run_.dropped()) + " of " +
         std::to_string(run_.learned().size()) +
         " entries, which ended otherwise there or more than 0.1 mm or 1 mrad elsewhere: they are "
         "left out.";
}

LearningStatus LearningSession::status() const {
  LearningStatus status;
  status.phase = phase_;
  status.counters = run_.counters();
  status.simulations = run_.simulations();
  status.known = run_.known();
  status.evaluations_budget = options_.evaluations;
  status.time_budget_s = options_.time_budget_s;
  status.entries = static_cast<std::int64_t>(run_.learned().size() - run_.dropped());
  status.dropped = static_cast<std::int64_t>(run_.dropped());
  status.trials = static_cast<std::int64_t>(run_.trials().size());
  status.checked = checked_;
  status.to_check = to_check_;
  status.elapsed_s = run_.elapsed_s();
  if (status.elapsed_s > 0.0) {
    status.evaluations_per_s = static_cast<double>(status.counters.evaluations) / status.elapsed_s;
  }
  status.left_s = timeLeft_s(run_, phase_, {clock_() - check_began_s_, checked_, to_check_});
  if (run_.newestRow() != nullptr) status.last = *run_.newestRow();
  return status;
}

}  // namespace hexapod
