#include "learning/learning_session.h"

#include <algorithm>
#include <stdexcept>

#include "gait/behavior.h"
#include "repertoire/metrics.h"

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

Physics nominalPhysics(const LearnOptions& options) {
  Physics physics;
  physics.step_s = options.step_s;
  return physics;
}

}  // namespace

std::string toString(LearningPhase phase) {
  switch (phase) {
    case LearningPhase::kEvolving:
      return "evolving";
    case LearningPhase::kValidating:
      return "validating";
    case LearningPhase::kDone:
      return "done";
  }
  return "unknown";
}

LearningSession::LearningSession(const RobotDescription& robot, const LearnOptions& options,
                                 Clock clock)
    : robot_(robot),
      options_(options),
      clock_(std::move(clock)),
      writer_(claimed(options)),
      engine_(chooseEngine(options.engine, robot)),
      worlds_(std::make_shared<WorldPool>(engine_.engine, robot, nominalPhysics(options),
                                          static_cast<int>(options.threads))),
      evaluator_(worlds_, options.behavior, &stop_),
      evolution_(options.evolution, robot.geneCount(), evaluator_,
                 Random(static_cast<std::uint64_t>(options.seed))) {
  if (writer_.holdsRepertoire() && !options.overwrite) {
    throw std::runtime_error(options.repertoire_file +
                             " holds a repertoire already. Nothing was changed: choose another "
                             "repertoire_file, or set overwrite to true to replace it.");
  }
}

bool LearningSession::run(const Hooks& hooks) {
  started_s_ = clock_();
  saved_s_ = started_s_;
  const bool finished = evolve(hooks) && validateEntries(hooks);
  if (finished) phase_ = LearningPhase::kDone;
  save(hooks);
  if (hooks.progress) hooks.progress(*this);
  return finished;
}

bool LearningSession::evolve(const Hooks& hooks) {
  while (evolution_.counters().evaluations < options_.evaluations) {
    const std::int64_t before = evolution_.counters().evaluations;
    try {
      evolution_.step(options_.evaluations - before);
    } catch (const EvaluationCancelled&) {
      return false;  // the generation under way is given up, nothing of it has been kept
    }
    evolved_s_ = clock_() - started_s_;
    const std::int64_t now = evolution_.counters().evaluations;
    if (now / kEvaluationsPerHistoryRow > before / kEvaluationsPerHistoryRow ||
        now >= options_.evaluations) {
      recordHistory();
    }
    if (save_.exchange(false) || clock_() - saved_s_ >= options_.checkpoint_period_s) save(hooks);
    if (hooks.progress) hooks.progress(*this);
    if (stop_) return false;
  }
  return true;
}

bool LearningSession::validateEntries(const Hooks& hooks) {
  if (options_.validation_trials == 0) return true;
  phase_ = LearningPhase::kValidating;
  ValidationOptions validation;
  validation.trials = options_.validation_trials;
  validation.start_states = std::max(validation.start_states, validation.trials);
  validation.seed = static_cast<std::uint64_t>(options_.seed);
  ValidationHooks validation_hooks;
  validation_hooks.cancelled = &stop_;
  validation_hooks.progress = [&](std::size_t done, std::size_t) {
    entries_validated_ = static_cast<std::int64_t>(done);
    if (hooks.progress) hooks.progress(*this);
  };
  std::vector<Genome> genomes;
  for (const Entry& entry : evolution_.archive().entries()) genomes.push_back(entry.genome);
  std::vector<Execution> executions =
      validate(*worlds_, options_.behavior, genomes, validation, validation_hooks);
  if (stop_) return false;
  executions_ = std::move(executions);
  return true;
}

void LearningSession::recordHistory() {
  const RepertoireMetrics metrics = measure(learnedEndings(evolution_.archive().entries()));
  HistoryRow row;
  row.evaluations = evolution_.counters().evaluations;
  row.archive_size = static_cast<std::int64_t>(evolution_.archive().size());
  row.sparseness_m = metrics.sparseness_m;
  row.median_orientation_error_rad = metrics.median_error_in_region_rad;
  row.max_reach_m = metrics.max_reach_m;
  row.elapsed_s = evolved_s_;
  history_.push_back(row);
}

void LearningSession::save(const Hooks& hooks) {
  saved_s_ = clock_();
  try {
    writer_.save(repertoire());
  } catch (const std::runtime_error& error) {
    if (hooks.save_failed) hooks.save_failed(error.what());
  }
}

LearningStatus LearningSession::status() const {
  LearningStatus status;
  status.phase = phase_;
  status.counters = evolution_.counters();
  status.evaluations_budget = options_.evaluations;
  status.entries = static_cast<std::int64_t>(evolution_.archive().size());
  status.entries_validated = entries_validated_;
  status.elapsed_s = evolved_s_;
  if (evolved_s_ > 0.0) {
    status.evaluations_per_s = static_cast<double>(status.counters.evaluations) / evolved_s_;
  }
  const auto left = static_cast<double>(options_.evaluations - status.counters.evaluations);
  if (left > 0.0 && status.evaluations_per_s > 0.0) status.eta_s = left / status.evaluations_per_s;
  if (!history_.empty()) status.last = history_.back();
  return status;
}

Repertoire LearningSession::repertoire() const {
  Repertoire repertoire;
  LearnOptions options = options_;
  for (const Option& option : declareOptions(options)) {
    // Where and with how many threads it was learned makes no difference to what was learned.
    if (option.name != "repertoire_file" && option.name != "overwrite" && option.name != "threads") {
      repertoire.options[option.name] = option.text();
    }
  }
  repertoire.run_id = runId(robot_, repertoire.options);
  repertoire.robot_id = robot_.digest;
  repertoire.seed = static_cast<std::uint64_t>(options_.seed);
  repertoire.generation = evolution_.counters().generations;
  repertoire.evaluations = evolution_.counters().evaluations;
  repertoire.behavior_duration_s =
      static_cast<double>(behaviorParts(options_.behavior).total()) *
      options_.behavior.command_period_s;
  repertoire.joint_names = robot_.jointNames();
  repertoire.entries = evolution_.archive().entries();
  for (std::size_t i = 0; i < executions_.size(); ++i) repertoire.entries[i].execution = executions_[i];
  repertoire.history = history_;
  return repertoire;
}

}  // namespace hexapod
