#include "learning/learn_options.h"

#include <limits>
#include <set>

#include "evolution/algorithms.h"
#include "repertoire/digest.h"
#include "robot/stride.h"
#include "simulation/body_text.h"

namespace hexapod {
namespace {

constexpr std::int64_t kMostEvaluations = 1000000000;
constexpr std::int64_t kUsualEvaluations = 20000;

}  // namespace

LearnOptions withBudget(LearnOptions options) {
  if (options.evaluations > 0) return options;
  options.evaluations = options.time_budget_s > 0.0 ? kMostEvaluations : kUsualEvaluations;
  return options;
}

std::vector<Option> declareOptions(LearnOptions& options) {
  std::vector<Option> all = {
      option("repertoire_file", options.repertoire_file,
             "SQLite file the repertoire is written to."),
      option("overwrite", options.overwrite,
             "Replace a repertoire that repertoire_file already holds."),
      option("resume", options.resume,
             "Go on with the run in repertoire_file, or begin it when there is none."),
      option("check_again", options.check_again,
             "With resume: verify and validate a finished run, and try it in other worlds, once "
             "more. (That is done, too, when other options for it are given.)"),
      option(
          "evaluations", options.evaluations,
          "Candidates to evaluate; a run that is resumed may be given more. 0: 20000, or as many "
          "as time_budget_s allows.",
          0, kMostEvaluations),
      option(
          "time_budget_s", options.time_budget_s, "s",
          "Evolution ends after this time even if evaluations are left, and what is learned then "
          "depends on the speed of the machine; 0: no limit. Where only this is given, only this "
          "limits the run.",
          0.0, 1e9),
      option("seed", options.seed, "Seed of everything random; same seed, same repertoire.", 0,
             std::numeric_limits<std::int32_t>::max()),
      option("threads", options.threads, "Threads that simulate; 0: all cores.", 0, 1024),
      option("algorithm", options.algorithm,
             "What breeds the candidates and keeps the entries: BR-Evolution, or MAP-Elites on a "
             "grid or on Voronoi cells, which takes candidates, mutation_rate and offer_twins "
             "of BR-Evolution's options, not the others.",
             algorithmNames()),
      option("from", options.from,
             "Repertoire file whose entries are the first candidates, evaluated anew: for another "
             "body, a changed robot or another floor. Empty: they are random."),
      option(
          "body", options.body,
          "What is otherwise about the body that is learned for: 'left_middle: locked, friction: "
          "0.7'; legs locked, lifted, limp or missing; friction, mass, gain and torque as "
          "scales, slope_x, slope_y, latency. Empty: the robot as its files describe it."),
      option("engine", options.engine,
             "Simulation engine: ODE, or its equations in reduced coordinates.", engineNames()),
      option("step_s", options.step_s, "s",
             "Step of the simulation; the command period must be a multiple of it.", 1e-4, 0.05),
      option(
          "length_scale", options.length_scale, "",
          "novelty_threshold_m, novelty_threshold_min_m, heading_m_per_rad, cell_m and "
          "cvt_radius_m are multiplied with it, spread_weight_rad_per_m and "
          "disparity_weight_rad_per_m are divided by it; 0: by the reach of the robot's legs over "
          "the 0.29 m that these are made for, and by less for feet that step less far for it.",
          0.0, 1000.0),
      option(
          "verify_with_ode", options.verify_with_ode,
          "Replay entries of the engine reduced in ODE when learning is done, and leave out those "
          "that do not hold."),
      option("verification_sample", options.verification_sample,
             "So many entries, drawn at random, are replayed in ODE; where one of them does not "
             "hold, all are. 0: all in any case.",
             0, 1000000000),
      option("resimulate", options.resimulate,
             "When learning is done, play the entries in worlds that it did not use, too, and keep "
             "among the file's facts what is left of them."),
      option("validation_trials", options.validation_trials,
             "Executions of each entry after random predecessors when learning is done; 0: none.",
             0, 1000),
      option("checkpoint_period_s", options.checkpoint_period_s, "s",
             "The file is written about this often while learning, but not so often that it takes "
             "more than 1 % of the time; 0: after every generation.",
             0.0, 86400.0),
      option("cached_genomes", options.cached_genomes,
             "Genomes whose outcomes are remembered, so that none is simulated twice; about 200 "
             "bytes each.",
             0, 100000000),
      option("worker_patience_s", options.worker_patience_s, "s",
             "Under mpirun: a process that has not answered for so long is given up, and this one "
             "does its part; 0: never.",
             0.0, 86400.0)};
  for (auto& more : {declareOptions(options.evolution), declareOptions(options.map_elites),
                     declareOptions(options.behavior), declareOptions(options.robustness),
                     declareOptions(options.transfer)}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

LearnOptions suitedTo(const RobotDescription& robot, LearnOptions options) {
  if (options.length_scale == 0.0) options.length_scale = strideScale(robot);
  options.evolution.novelty_threshold_m *= options.length_scale;
  options.evolution.novelty_threshold_min_m *= options.length_scale;
  options.evolution.heading_m_per_rad *= options.length_scale;
  options.map_elites.cell_m *= options.length_scale;
  options.map_elites.cvt_radius_m *= options.length_scale;
  options.robustness.spread_weight_rad_per_m /= options.length_scale;
  options.transfer.disparity_weight_rad_per_m /= options.length_scale;
  options.body = bodyText(robot, bodyFromText(robot, options.body));
  if (options.body == toString(LegCondition::kIntact)) options.body.clear();
  // Not the same without any: there is no simulated robot then.
  std::string& robot_body = options.transfer.robot_body;
  if (!robot_body.empty()) robot_body = bodyText(robot, bodyFromText(robot, robot_body));
  return options;
}

Physics nominalPhysics(const RobotDescription& robot, const LearnOptions& options) {
  Physics physics;
  physics.step_s = options.step_s;
  return bodyFromText(robot, options.body, physics);
}

std::map<std::string, std::string> resultOptions(const LearnOptions& options) {
  const std::set<std::string> others = {
      "repertoire_file", "overwrite",           "resume",         "check_again",
      "threads",         "checkpoint_period_s", "cached_genomes", "worker_patience_s"};
  LearnOptions copy = options;
  std::map<std::string, std::string> texts;
  for (const Option& option : declareOptions(copy)) {
    if (others.count(option.name) == 0) texts[option.name] = option.text();
  }
  // Files keep only what is there.
  if (!copy.transfer.transferability) {
    for (const Option& option : declareOptions(copy.transfer)) texts.erase(option.name);
  }
  for (const char* name : {"from", "body", "robot_body"}) {
    if (texts[name].empty()) texts.erase(name);
  }
  return texts;
}

bool isBudget(const std::string& option_name) {
  return option_name == "evaluations" || option_name == "time_budget_s";
}

bool isCheck(const std::string& option_name) {
  return option_name == "verify_with_ode" || option_name == "verification_sample" ||
         option_name == "resimulate" || option_name == "validation_trials";
}

std::string runId(const RobotDescription& robot,
                  const std::map<std::string, std::string>& options) {
  Digest digest;
  digest.add(robot.digest);
  for (const auto& [name, text] : options) {
    digest.add(name);
    digest.add(text);
  }
  return robot.name + "-seed" + options.at("seed") + "-" + digest.text().substr(0, 8);
}

}  // namespace hexapod
