#include "learning/learning_session.h"

#include <algorithm>
#include <stdexcept>

#include "common/half_decade.h"
#include "common/text.h"
#include "evaluation/verify.h"
#include "gait/behavior.h"
#include "repertoire/metrics.h"

namespace hexapod {
namespace {

// Of the time, at most this part goes into writing checkpoints.
constexpr double kCheckpointShare = 0.01;

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

std::optional<Resumed> earlierRun(const RobotDescription& robot, const LearnOptions& options,
                                  const RepertoireWriter& writer) {
  if (options.resume && options.overwrite) {
    throw std::invalid_argument(
        "'resume' and 'overwrite' are both true; set one of them to false: a run is either gone on "
        "with or replaced.");
  }
  if (!writer.holdsRepertoire() || options.overwrite) return std::nullopt;
  if (options.resume) return resume(robot, options);
  throw std::runtime_error(
      options.repertoire_file +
      " holds a repertoire already. Nothing was changed: choose another "
      "repertoire_file, set resume to true to go on with that run, or overwrite "
      "to true to replace it.");
}

std::vector<Genome> genomesOf(const std::vector<Entry>& entries) {
  std::vector<Genome> genomes;
  for (const Entry& entry : entries) genomes.push_back(entry.genome);
  return genomes;
}

BrEvolution makeEvolution(const RobotDescription& robot, const LearnOptions& options,
                          CandidateEvaluator& evaluator, const std::optional<Resumed>& resumed) {
  if (resumed) {
    return BrEvolution(options.evolution, robot.geneCount(), evaluator.evaluator(),
                       resumed->checkpoint.evolution, evaluator.symmetries());
  }
  return BrEvolution(options.evolution, robot.geneCount(), evaluator.evaluator(),
                     Random(static_cast<std::uint64_t>(options.seed)), evaluator.symmetries());
}

}  // namespace

LearningSession::LearningSession(const RobotDescription& robot, const LearnOptions& options,
                                 Clock clock, const DistributedEvaluator::Workers& workers)
    : robot_(robot),
      options_(options),
      clock_(std::move(clock)),
      writer_(claimed(options_)),
      resumed_(earlierRun(robot, options_, writer_)),
      engine_(chooseEngine(options_.engine, robot)),
      worlds_(std::make_shared<WorldPool>(engine_.engine, robot, nominalPhysics(options_),
                                          static_cast<int>(options_.threads))),
      evaluator_(worlds_, options_, stop_, workers),
      evolution_(makeEvolution(robot, options_, evaluator_, resumed_)) {
  if (resumed_) goOn();
}

void LearningSession::goOn() {
  phase_ = resumed_->checkpoint.phase;
  evolved_s_ = resumed_->checkpoint.elapsed_s;
  history_ = resumed_->history;
  executions_ = resumed_->executions;
  entries_validated_ = static_cast<std::int64_t>(executions_.size());
  if (budgetIsLeft()) {
    phase_ = LearningPhase::kEvolving;
    executions_.clear();
    entries_validated_ = 0;
  }
  if (phase_ == LearningPhase::kDone) {
    dropped_ = resumed_->checkpoint.dropped;
    facts_ = resumed_->facts;
  }
}

std::string LearningSession::resumeRemark() const {
  const std::string& file = options_.repertoire_file;
  if (!options_.resume) return "";
  if (!resumed_) return "There is no run in " + file + " to go on with: it is begun.";
  const std::string size =
      std::to_string(resumed_->checkpoint.evolution.archive.size()) + " entries after " +
      std::to_string(resumed_->checkpoint.evolution.counters.evaluations) + " evaluations";
  if (phase_ == LearningPhase::kDone) return "The run in " + file + " is finished: " + size + ".";
  return "Going on with the run in " + file + ": " + size + ".";
}

bool LearningSession::run(const Hooks& hooks) {
  lap_s_ = saved_s_ = clock_();
  const bool was_done = phase_ == LearningPhase::kDone;
  const bool finished = was_done || (evolve(hooks) && verifyEntries(hooks) &&
                                     validateEntries(hooks) && resimulateEntries());
  if (finished) phase_ = LearningPhase::kDone;
  if (!was_done && evolution_.counters().generations > 0) save(hooks);
  if (hooks.progress) hooks.progress(*this);
  return finished;
}

bool LearningSession::budgetIsLeft() const {
  const bool time_is_left = options_.time_budget_s <= 0.0 || evolved_s_ < options_.time_budget_s;
  return time_is_left && evolution_.counters().evaluations < options_.evaluations;
}

std::int64_t LearningSession::simulations() const {
  return (resumed_ ? resumed_->checkpoint.simulations : 0) + evaluator_.simulations();
}

void LearningSession::lap() {
  const double now_s = clock_();
  evolved_s_ += now_s - lap_s_;
  lap_s_ = now_s;
}

bool LearningSession::evolve(const Hooks& hooks) {
  while (budgetIsLeft()) {
    const std::int64_t before = evolution_.counters().evaluations;
    try {
      evolution_.step(options_.evaluations - before);
    } catch (const EvaluationCancelled&) {
      return false;  // the generation under way is given up, nothing of it has been kept
    }
    lap();
    const std::int64_t now = evolution_.counters().evaluations;
    if (now / kEvaluationsPerHistoryRow > before / kEvaluationsPerHistoryRow) {
      recordHistory();
      if (halfDecade(now) > before) addHeldOut();
    }
    if (save_.exchange(false) || checkpointIsDue()) save(hooks);
    lap();
    if (hooks.progress) hooks.progress(*this);
    lap_s_ = clock_();  // whatever the hook waited for was not spent evolving
    if (stop_) return false;
  }
  if (history_.empty() || history_.back().evaluations != evolution_.counters().evaluations) {
    recordHistory();
  }
  return true;
}

bool LearningSession::verifyEntries(const Hooks& hooks) {
  if (!options_.verify_with_ode || engine_.engine == Engine::kOde) return true;
  phase_ = LearningPhase::kVerifying;
  save(hooks);
  VerificationHooks verification_hooks;
  verification_hooks.cancelled = &stop_;
  verification_hooks.progress = [&](std::size_t done, std::size_t) {
    entries_verified_ = static_cast<std::int64_t>(done);
    if (hooks.progress) hooks.progress(*this);
  };
  const std::vector<Entry>& entries = evolution_.archive().entries();
  const Verification verification =
      verifyInOde(*worlds_, options_.behavior, genomesOf(entries), verification_hooks);
  if (stop_) return false;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!verification.holds[i]) dropped_.insert(entries[i].id);
  }
  facts_["verified_entries"] = std::to_string(entries.size() - dropped_.size());
  facts_["dropped_entries"] = std::to_string(dropped_.size());
  facts_["largest_difference_m"] = exactText(verification.largest_difference_m);
  facts_["largest_difference_rad"] = exactText(verification.largest_difference_rad);
  return true;
}

std::string LearningSession::verificationRemark() const {
  if (dropped_.empty()) return "";
  return "ODE does not confirm " + std::to_string(dropped_.size()) + " of " +
         std::to_string(evolution_.archive().size()) +
         " entries, which ended otherwise there or more than 0.1 mm or 1 mrad elsewhere: they are "
         "left out.";
}

std::vector<Entry> LearningSession::keptEntries() const {
  std::vector<Entry> kept;
  for (const Entry& entry : evolution_.archive().entries()) {
    if (dropped_.count(entry.id) == 0) kept.push_back(entry);
  }
  return kept;
}

bool LearningSession::validateEntries(const Hooks& hooks) {
  if (options_.validation_trials == 0) return true;
  phase_ = LearningPhase::kValidating;
  save(hooks);
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
  std::vector<Execution> executions =
      validate(*worlds_, options_.behavior, genomesOf(keptEntries()), validation, validation_hooks);
  if (stop_) return false;
  executions_ = std::move(executions);
  return true;
}

bool LearningSession::resimulateEntries() {
  if (!options_.resimulate) return true;
  try {
    const std::vector<TrialResult> results = tryHeldOut(repertoire().entries);
    for (const auto& [name, text] : factsOf(results)) facts_[name] = text;
    history_.back().held_out = heldOutMedians(results);
  } catch (const EvaluationCancelled&) {
    return false;
  }
  return true;
}

std::vector<TrialResult> LearningSession::tryHeldOut(const std::vector<Entry>& entries) {
  return resimulate(worlds_, options_.behavior, entries, heldOutTrials(robot_, worlds_->physics()),
                    &stop_);
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

void LearningSession::addHeldOut() {
  if (!options_.resimulate) return;
  try {
    history_.back().held_out = heldOutMedians(tryHeldOut(evolution_.archive().entries()));
  } catch (const EvaluationCancelled&) {
    // Asked to stop: the row does without.
  }
}

bool LearningSession::checkpointIsDue() const {
  const double period_s = options_.checkpoint_period_s;
  if (period_s <= 0.0) return true;
  return clock_() - saved_s_ >= std::max(period_s, save_cost_s_ / kCheckpointShare);
}

void LearningSession::save(const Hooks& hooks) {
  const double begin_s = clock_();
  try {
    writer_.save(repertoire(),
                 toLearnerState({evolution_.state(), phase_, evolved_s_, simulations(), dropped_}));
  } catch (const std::runtime_error& error) {
    if (hooks.save_failed) hooks.save_failed(error.what());
  }
  saved_s_ = clock_();
  save_cost_s_ = saved_s_ - begin_s;
}

LearningStatus LearningSession::status() const {
  LearningStatus status;
  status.phase = phase_;
  status.counters = evolution_.counters();
  status.simulations = simulations();
  status.known = evaluator_.known();
  status.evaluations_budget = options_.evaluations;
  status.time_budget_s = options_.time_budget_s;
  status.entries = static_cast<std::int64_t>(evolution_.archive().size() - dropped_.size());
  status.entries_verified = entries_verified_;
  status.entries_dropped = static_cast<std::int64_t>(dropped_.size());
  status.entries_validated = entries_validated_;
  status.elapsed_s = evolved_s_;
  if (evolved_s_ > 0.0) {
    status.evaluations_per_s = static_cast<double>(status.counters.evaluations) / evolved_s_;
  }
  const auto left = static_cast<double>(options_.evaluations - status.counters.evaluations);
  if (left > 0.0 && status.evaluations_per_s > 0.0) status.eta_s = left / status.evaluations_per_s;
  if (options_.time_budget_s > 0.0) {
    const double time_left_s = std::max(0.0, options_.time_budget_s - evolved_s_);
    status.eta_s = evolved_s_ > 0.0 ? std::min(status.eta_s, time_left_s) : time_left_s;
  }
  if (!history_.empty()) status.last = history_.back();
  return status;
}

Repertoire LearningSession::repertoire() const {
  Repertoire repertoire;
  repertoire.options = resultOptions(options_);
  repertoire.run_id = runId(robot_, repertoire.options);
  repertoire.robot_id = robot_.digest;
  repertoire.seed = static_cast<std::uint64_t>(options_.seed);
  repertoire.generation = evolution_.counters().generations;
  repertoire.evaluations = evolution_.counters().evaluations;
  repertoire.behavior_duration_s = static_cast<double>(behaviorParts(options_.behavior).total()) *
                                   options_.behavior.command_period_s;
  repertoire.joint_names = robot_.jointNames();
  repertoire.facts = facts_;
  repertoire.facts["engine"] = toString(engine_.engine);
  repertoire.facts["simulations"] = std::to_string(simulations());
  repertoire.entries = keptEntries();
  for (std::size_t i = 0; i < executions_.size(); ++i)
    repertoire.entries[i].execution = executions_[i];
  repertoire.history = history_;
  return repertoire;
}

}  // namespace hexapod
