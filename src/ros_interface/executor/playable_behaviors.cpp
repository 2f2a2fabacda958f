#include "ros_interface/executor/playable_behaviors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "common/problems.h"
#include "common/text.h"
#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

// Durations are sums of decimal options; anything above rounding is another behaviour.
constexpr double kSameDuration_s = 1e-6;

double durationOf(const BehaviorOptions& options) {
  return static_cast<double>(behaviorParts(options).total()) * options.command_period_s;
}

}  // namespace

PlayableBehaviors::PlayableBehaviors(const RobotDescription& robot, const BehaviorOptions& options)
    : robot_(robot),
      options_(options),
      problem_("No repertoire has come yet; start a learner or a repertoire_server.") {
  checkReturnIsSlowEnough(robot, options);
}

std::string PlayableBehaviors::update(const hexapod_repertoire::Repertoire& message) {
  Genomes genomes;
  BehaviorOptions options = options_;
  std::string problem = mismatch(message);
  if (problem.empty()) problem = readOptions(message, options);
  if (problem.empty()) problem = readEntries(message, options.gene_levels, genomes);
  const bool is_first = !problem_.empty();
  if (!problem.empty()) {
    if (is_first) problem_ = problem;
    return problem + (is_first ? "" : " The earlier repertoire stays in use.");
  }
  genomes_ = std::move(genomes);
  options_ = options;
  run_id_ = message.run_id;
  body_ = optionOf(message, "body");
  problem_.clear();
  return "";
}

std::string PlayableBehaviors::readEntries(const hexapod_repertoire::Repertoire& message,
                                           std::int64_t gene_levels, Genomes& genomes) const {
  for (const hexapod_repertoire::RepertoireEntry& entry : message.entries) {
    const Genome genome(entry.genome.begin(), entry.genome.end());
    const std::string illegal = checkGenome(genome, gene_levels);
    if (illegal.empty() && entry.id >= 0 && genomes.emplace(entry.id, genome).second) continue;
    return "Entry " + std::to_string(entry.id) + " of the repertoire is refused: " +
           (illegal.empty() ? "its id is negative or occurs twice." : illegal);
  }
  return "";
}

std::string PlayableBehaviors::mismatch(const hexapod_repertoire::Repertoire& message) const {
  if (message.robot_id != robot_.digest) {
    return "The repertoire was learned for the robot " + message.robot_id + ", this one is " +
           robot_.digest + " (" + robot_.name + "); learn one for this robot description.";
  }
  if (message.joint_names != robot_.jointNames()) {
    return "The repertoire's joint names are not those of the robot description.";
  }
  return "";
}

std::string PlayableBehaviors::readOptions(const hexapod_repertoire::Repertoire& message,
                                           BehaviorOptions& options) const {
  // From before there was a choice.
  std::map<std::string, std::string> kept = {{"gene_levels", std::to_string(kGeneLevels)}};
  for (const Option& option : declarePlayingOptions(options)) {
    const std::string value = optionOf(message, option.name);
    if (!value.empty()) kept[option.name] = value;
  }
  try {
    options = behaviorOptionsOf(kept, options);
    if (std::abs(options.command_period_s - options_.command_period_s) > kSameDuration_s) {
      return "The repertoire was learned with a command every " +
             numberText(options.command_period_s) + " s, the executor sends one every " +
             numberText(options_.command_period_s) + " s; give it the same command_period_s.";
    }
    checkReturnIsSlowEnough(robot_, options);
    const double duration_s = durationOf(options);
    if (std::abs(message.behavior_duration_s - duration_s) < kSameDuration_s) return "";
    return "The repertoire's behaviours take " + numberText(message.behavior_duration_s) +
           " s, but by its gait_duration_s, return_duration_s, rest_duration_s and end_pose, or "
           "the executor's where it has none, " +
           numberText(duration_s) + " s.";
  } catch (const std::invalid_argument& error) {
    return "The repertoire's options are refused: " + std::string(error.what());
  }
}

std::string PlayableBehaviors::checkGenome(const Genome& genome, std::int64_t gene_levels) const {
  try {
    requireGeneLevels(gene_levels);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  if (genome.size() != robot_.geneCount()) {
    return "The genome has " + std::to_string(genome.size()) + " genes; this robot has " +
           std::to_string(robot_.geneCount()) + ".";
  }
  for (std::size_t i = 0; i < genome.size(); ++i) {
    if (genome[i] < gene_levels) continue;
    return "Gene " + std::to_string(i) + " of the genome is " + std::to_string(genome[i]) +
           "; expected 0 .. " + std::to_string(gene_levels - 1) + ".";
  }
  return "";
}

RobotDescription PlayableBehaviors::movingOnly(const std::vector<std::string>& joints,
                                               std::string& problem) const {
  RobotDescription robot = robot_;
  std::size_t found = 0;
  for (Leg& leg : robot.legs) {
    for (Segment& segment : leg.segments) {
      const bool moves =
          std::find(joints.begin(), joints.end(), segment.joint.name) != joints.end();
      if (!moves) segment.joint.amplitude_rad = 0.0;
      found += moves ? 1 : 0;
    }
  }
  if (found != joints.size()) {
    problem = "Of the " + std::to_string(joints.size()) + " joints of the goal the robot has " +
              std::to_string(found) + "; it has " + namesText(robot_.jointNames()) + ".";
  }
  return robot;
}

std::shared_ptr<const Behavior> PlayableBehaviors::find(
    const hexapod_repertoire::ExecuteBehaviorGoal& goal, std::string& problem) const {
  Genome genome(goal.genome.begin(), goal.genome.end());
  BehaviorOptions options = options_;
  if (goal.entry_id == -1) {
    if (goal.gene_levels != 0) options.gene_levels = goal.gene_levels;
    problem = checkGenome(genome, options.gene_levels);
  } else if (!goal.joints.empty()) {
    problem = "The goal names joints and an entry; single joints move by bare genomes only.";
  } else if (!problem_.empty()) {
    problem = problem_;
  } else if (goal.run_id != run_id_) {
    problem = "The goal quotes the run '" + goal.run_id + "'; the repertoire at hand is of run '" +
              run_id_ + "'.";
  } else {
    const auto found = genomes_.find(goal.entry_id);
    if (found == genomes_.end() && !genome.empty()) {
      problem =
          checkGenome(genome, options.gene_levels);  // of another state of a growing repertoire
    } else if (found == genomes_.end()) {
      problem = "Entry " + std::to_string(goal.entry_id) + " is not in the repertoire of run '" +
                run_id_ + "' (" + std::to_string(genomes_.size()) + " entries).";
    } else {
      genome = found->second;
      problem.clear();
    }
  }
  if (!problem.empty()) return nullptr;
  if (goal.joints.empty()) {
    return std::make_shared<const Behavior>(robot_, genome, options);
  }
  const RobotDescription robot = movingOnly(goal.joints, problem);
  if (!problem.empty()) return nullptr;
  return std::make_shared<const Behavior>(robot, genome, options);
}

}  // namespace hexapod
