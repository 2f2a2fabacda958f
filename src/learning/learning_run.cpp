#include "learning/learning_run.h"

#include "evolution/algorithms.h"
#include "gait/behavior.h"
#include "repertoire/metrics.h"
#include "robot/dimensions.h"
#include "transferability/choose_trial.h"

namespace hexapod {
namespace {

// What a radian counts as between behaviours, for the robot that length_scale is 1 of.
constexpr double kRadian_m = 0.3;

std::unique_ptr<Generational> algorithmOf(const RobotDescription& robot,
                                          const LearnOptions& options,
                                          const std::shared_ptr<WorldPool>& worlds,
                                          CandidateEvaluator& evaluator, const RunStart& start) {
  const AlgorithmChoice choice{options.algorithm, options.evolution, options.map_elites};
  Task task(gaitsOf(robot, options.behavior), evaluator.evaluator().looks(),
            evaluator.symmetries());
  task.spread = [worlds](std::size_t count, const std::function<void(std::size_t)>& work) {
    worlds->forEach(count, [&](World& /*world*/, std::size_t i) { work(i); });
  };
  if (start.resumed) return makeAlgorithm(choice, task, start.resumed->checkpoint.evolution);
  auto algorithm = makeAlgorithm(choice, task, Random(static_cast<std::uint64_t>(options.seed)));
  if (start.warm) algorithm->beginWith(start.warm->genomes);
  return algorithm;
}

LearnOptions begunAs(LearnOptions options, const RunStart& start) {
  options.from = start.resumed ? start.resumed->from : start.warm ? start.warm->name : "";
  return options;
}

}  // namespace

LearningRun::LearningRun(const RobotDescription& robot, const LearnOptions& options,
                         const RunStart& start, const std::atomic<bool>& cancelled,
                         const DistributedEvaluator::Workers& workers)
    : robot_(robot),
      options_(begunAs(options, start)),
      engine_(chooseEngine(options.engine, robot)),
      worlds_(std::make_shared<WorldPool>(engine_.engine, robot, nominalPhysics(robot, options),
                                          static_cast<int>(options.threads))),
      evaluator_(worlds_, options, cancelled, workers),
      algorithm_(algorithmOf(robot, options, worlds_, evaluator_, start)) {
  if (start.resumed) goOn(*start.resumed);
}

void LearningRun::goOn(const Resumed& resumed) {
  history_ = resumed.history;
  elapsed_s_ = resumed.checkpoint.elapsed_s;
  earlier_simulations_ = resumed.checkpoint.simulations;
  trials_ = resumed.trials;
  trial_attempts_ = resumed.checkpoint.trial_attempts;
  learnFromTrials();
  phase_found_ = budgetIsLeft() ? LearningPhase::kEvolving : resumed.checkpoint.phase;
  if (phase_found_ != LearningPhase::kDone) return;
  if (options_.check_again || resumed.checks_differ) {
    phase_found_ = LearningPhase::kVerifying;
    return;
  }
  executions_ = resumed.executions;
  dropped_ = resumed.checkpoint.dropped;
  facts_ = resumed.facts;
}

bool LearningRun::budgetIsLeft() const {
  const bool time_is_left = options_.time_budget_s <= 0.0 || elapsed_s_ < options_.time_budget_s;
  return time_is_left && counters().evaluations < options_.evaluations;
}

void LearningRun::step() {
  advance(*algorithm_, evaluator_.evaluator(), options_.evaluations - counters().evaluations);
}

std::int64_t LearningRun::attemptsDue() const {
  const TransferOptions& transfer = options_.transfer;
  return counters().generations / transfer.trial_period * transfer.trials_at_once;
}

bool LearningRun::isTrialDue() const {
  const TransferOptions& transfer = options_.transfer;
  return transfer.transferability && static_cast<std::int64_t>(trials_.size()) < transfer.trials &&
         trial_attempts_ < attemptsDue() && !learned().empty();
}

FeatureScales LearningRun::featureScales() const {
  return {kRadian_m * options_.length_scale,
          static_cast<std::size_t>(options_.behavior.gene_levels), evaluator_.symmetries()};
}

const Entry& LearningRun::entryToTry() const {
  return learned()[farthestFromTried(learned(), trials_, featureScales())];
}

void LearningRun::addTrial(const std::optional<RobotTrial>& trial) {
  if (!trial) {
    trial_attempts_ = attemptsDue();
    return;
  }
  ++trial_attempts_;
  trials_.push_back(*trial);
  learnFromTrials();
}

void LearningRun::learnFromTrials() {
  if (trials_.empty()) return;
  disparities_ = std::make_shared<DisparityModel>(
      featureScales(), options_.transfer.disparity_weight_rad_per_m, trials_);
  algorithm_->judgeBy(disparities_);
}

void LearningRun::recordHistory() {
  if (!history_.empty() && history_.back().evaluations == counters().evaluations) return;
  const RepertoireMetrics metrics =
      measure(learnedEndings(learned()), RegionOfInterest().scaledBy(lengthScale(robot_)));
  HistoryRow row;
  row.evaluations = counters().evaluations;
  row.archive_size = static_cast<std::int64_t>(learned().size());
  row.sparseness_m = metrics.sparseness_m;
  row.median_orientation_error_rad = metrics.median_error_in_region_rad;
  row.max_reach_m = metrics.max_reach_m;
  row.elapsed_s = elapsed_s_;
  history_.push_back(row);
}

std::vector<Entry> LearningRun::entries() const {
  std::vector<Entry> kept;
  for (const Entry& entry : learned()) {
    if (dropped_.count(entry.id) > 0) continue;
    kept.push_back(entry);
    const auto execution = executions_.find(entry.id);
    if (execution != executions_.end()) kept.back().execution = execution->second;
  }
  return kept;
}

void LearningRun::add(const Findings& findings) {
  dropped_.insert(findings.dropped.begin(), findings.dropped.end());
  for (const auto& [id, execution] : findings.executions) executions_[id] = execution;
  for (const auto& [name, text] : findings.facts) facts_[name] = text;
  if (findings.held_out && !history_.empty()) history_.back().held_out = findings.held_out;
}

Repertoire LearningRun::repertoire() const {
  Repertoire repertoire;
  repertoire.options = resultOptions(options_);
  repertoire.run_id = runId(robot_, repertoire.options);
  repertoire.robot_id = robot_.digest;
  repertoire.seed = static_cast<std::uint64_t>(options_.seed);
  repertoire.generation = counters().generations;
  repertoire.evaluations = counters().evaluations;
  repertoire.behavior_duration_s = static_cast<double>(behaviorParts(options_.behavior).total()) *
                                   options_.behavior.command_period_s;
  repertoire.joint_names = robot_.jointNames();
  repertoire.facts = facts_;
  repertoire.facts["engine"] = toString(engine_.engine);
  repertoire.facts["simulations"] = std::to_string(simulations());
  repertoire.entries = entries();
  repertoire.history = history_;
  repertoire.trials = trials_;
  return repertoire;
}

Checkpoint LearningRun::checkpoint(LearningPhase phase) const {
  return {algorithm_->state(), phase, elapsed_s_, simulations(), dropped_, trial_attempts_};
}

}  // namespace hexapod
