#include "tools/walk_campaign.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "common/random.h"
#include "common/text.h"
#include "learning/relearning.h"
#include "planning/deviation.h"
#include "simulation/world_pool.h"
#include "tools/campaign_walker.h"

namespace hexapod {
namespace {

Pose2 randomGoal(Random& random, double radius_m) {
  const double far_m = radius_m * std::sqrt(random.uniform());
  const double direction_rad = random.uniform(-M_PI, M_PI);
  return {far_m * std::cos(direction_rad), far_m * std::sin(direction_rad),
          random.uniform(-M_PI, M_PI)};
}

Physics told(Physics physics, double error) {
  physics.friction_scale *= 1.0 + error;
  physics.torque_scale *= 1.0 + error;
  physics.servo_gain_scale /= 1.0 + error;
  physics.mass_scale /= 1.0 + error;
  return physics;
}

std::shared_ptr<Foresight> foresightFor(Adaptation adaptation, const RobotDescription& robot,
                                        const LearnedWorld& learned, const TrueBody& body,
                                        const CampaignOptions& campaign) {
  SelfModelOptions options;
  options.threads = 1;  // as many goals at once as there are threads
  options.belief.measurement_noise_m = campaign.measurement_noise_m;
  options.belief.measurement_noise_rad = campaign.measurement_noise_rad;
  switch (adaptation) {
    case Adaptation::kNone:
      return nullptr;
    case Adaptation::kDeviation:
      return std::make_shared<DeviationForesight>();
    case Adaptation::kSelfModel:
      return std::make_shared<SelfModel>(robot, learned, options);
    case Adaptation::kTold:
    case Adaptation::kRelearned:
      break;
  }
  return std::make_shared<SelfModel>(robot, learned, options,
                                     told(body.physics, campaign.told_error));
}

// As new as the first one was.
std::shared_ptr<Foresight> anotherOf(const std::shared_ptr<Foresight>& foresight) {
  if (const auto* self_model = dynamic_cast<const SelfModel*>(foresight.get())) {
    return std::make_shared<SelfModel>(*self_model);
  }
  return foresight ? std::make_shared<DeviationForesight>() : nullptr;
}

// From one goal to the next with one belief. A robot that fell is stood up where it began.
std::vector<GoalWalk> walkOn(CampaignWalker& walker, const std::vector<Pose2>& goals,
                             const AdaptivePlanner& planner,
                             const std::shared_ptr<Foresight>& foresight) {
  std::vector<GoalWalk> walks;
  AdaptivePlanner own(planner, foresight);
  walker.restart();
  for (const Pose2& goal : goals) {
    walks.push_back(
        walker.walkTo(walker.pose() * goal, own, dynamic_cast<const SelfModel*>(foresight.get())));
    const GoalWalk::End end = walks.back().end;
    if (end == GoalWalk::End::kFell || end == GoalWalk::End::kLegsTouched) walker.restart();
  }
  walks.erase(walks.begin());
  return walks;
}

Repertoire relearnedFor(const RobotDescription& robot, const Repertoire& repertoire,
                        const TrueBody& body, const CampaignOptions& campaign) {
  RelearnOptions options;
  options.evaluations = campaign.relearn_evaluations;
  options.threads = campaign.threads;
  const std::atomic<bool> never{false};
  return *relearn(robot, repertoire, body.physics, options, never);
}

// The value below which `share` of the values lie; 0 when there are none.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto last = static_cast<double>(values.size() - 1);
  const auto found = values.begin() + static_cast<std::ptrdiff_t>(std::lround(share * last));
  std::nth_element(values.begin(), found, values.end());
  return *found;
}

}  // namespace

std::vector<Option> declareOptions(CampaignOptions& options) {
  return {
      option("goals", options.goals, "Goals per body.", 1, 1000000),
      option("seed", options.seed, "Seed of the goals.", 0, 1000000000),
      option("threads", options.threads, "Goals walked to at once; 0: all cores.", 0, 1024),
      option("radius_m", options.radius_m, "m", "Goals lie within this distance.", 0.1, 10.0),
      option("xy_tolerance_m", options.xy_tolerance_m, "m", "Distance that counts as arrived.",
             0.001, 1.0),
      option("yaw_tolerance_rad", options.yaw_tolerance_rad, "rad",
             "Heading error that counts as arrived.", 0.001, 3.15),
      option("max_behaviors", options.max_behaviors, "Behaviours until a goal is given up.", 1,
             1000),
      option("measurement_noise_m", options.measurement_noise_m, "m",
             "Standard deviation of measured positions, per axis.", 0.0, 1.0),
      option("measurement_noise_rad", options.measurement_noise_rad, "rad",
             "Standard deviation of measured headings.", 0.0, 1.0),
      option("told_error", options.told_error, "",
             "By this share friction and torque are told too high in 'told' and 'relearned', servo "
             "gain "
             "and mass too low: who is told knows no more than somebody could measure.",
             0.0, 0.5),
      option("keep_belief", options.keep_belief,
             "Walk from goal to goal, each relative to where the robot stands, with what was "
             "learned on the way; the first goal is not counted."),
      option("relearn_evaluations", options.relearn_evaluations,
             "Candidates of the relearning in 'relearned', the old entries included.", 1,
             100000000),
      option("engine", options.engine, "Engine of the world that is walked in.", engineNames()),
  };
}

const std::vector<std::string>& adaptationNames() {
  static const std::vector<std::string> names = {"none", "deviation", "self_model", "told",
                                                 "relearned"};
  return names;
}

Adaptation adaptationFromText(const std::string& name) {
  const std::vector<std::string>& names = adaptationNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw std::invalid_argument("'" + name + "' is no adaptation; expected one of " +
                                listed(names) + ".");
  }
  return static_cast<Adaptation>(found - names.begin());
}

std::vector<GoalWalk> walkToGoals(const RobotDescription& robot, const Repertoire& original,
                                  const TrueBody& body, Adaptation adaptation,
                                  const CampaignOptions& options) {
  const Repertoire repertoire = adaptation == Adaptation::kRelearned
                                    ? relearnedFor(robot, original, body, options)
                                    : original;
  const LearnedWorld learned = learnedWorldOf(robot, repertoire);
  Random random(static_cast<std::uint64_t>(options.seed));
  std::vector<Pose2> goals;
  for (std::int64_t i = 0; i < options.goals; ++i) {
    goals.push_back(randomGoal(random, options.radius_m));
  }
  WorldPool pool(chooseEngine(options.engine, robot).engine, robot, body.physics,
                 static_cast<int>(options.threads));
  const std::shared_ptr<Foresight> foresight =
      foresightFor(adaptation, robot, learned, body, options);
  AdaptivePlanner planner(repertoire, PlannerOptions(), foresight);
  planner.prepare([] { return false; });
  if (options.keep_belief) {
    std::vector<GoalWalk> walks;
    pool.forEach(1, [&](World& world, std::size_t) {
      CampaignWalker walker(world, repertoire, learned, options, 0);
      walks = walkOn(walker, goals, planner, foresight);
    });
    return walks;
  }
  std::vector<GoalWalk> walks(goals.size());
  pool.forEach(goals.size(), [&](World& world, std::size_t i) {
    const std::shared_ptr<Foresight> fresh = anotherOf(foresight);
    AdaptivePlanner own(planner, fresh);
    CampaignWalker walker(world, repertoire, learned, options, i);
    walker.restart();
    walks[i] = walker.walkTo(goals[i], own, dynamic_cast<const SelfModel*>(fresh.get()));
  });
  return walks;
}

CampaignRow summarize(const std::vector<GoalWalk>& walks) {
  CampaignRow row;
  std::vector<double> off_m, off_rad, thought_s;
  for (const GoalWalk& walk : walks) {
    ++row.goals;
    row.arrived += walk.end == GoalWalk::End::kArrived;
    row.given_up += walk.end == GoalWalk::End::kGivenUp;
    row.no_plan += walk.end == GoalWalk::End::kNoPlan;
    row.fell += walk.end == GoalWalk::End::kFell;
    row.touched += walk.end == GoalWalk::End::kLegsTouched;
    if (walk.end == GoalWalk::End::kArrived) row.behaviors += walk.behaviors;
    row.right_after_first += walk.right_after_first;
    row.false_alarms += walk.false_alarm;
    thought_s.insert(thought_s.end(), walk.thought_s.begin(), walk.thought_s.end());
    for (std::size_t i = 2; i < walk.off_m.size(); ++i) {
      off_m.push_back(walk.off_m[i]);
      off_rad.push_back(walk.off_rad[i]);
    }
  }
  row.behaviors /= static_cast<double>(std::max<std::int64_t>(row.arrived, 1));
  row.right_after_first /= static_cast<double>(row.goals);
  row.false_alarms /= static_cast<double>(row.goals);
  row.off_m = quantile(off_m, 0.5);
  row.off_rad = quantile(off_rad, 0.5);
  row.thought_s = quantile(thought_s, 0.5);
  row.most_thought_s = quantile(thought_s, 0.95);
  return row;
}

}  // namespace hexapod
