#include "tools/walk_campaign.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/random.h"
#include "planning/deviation.h"
#include "simulation/rollout.h"
#include "simulation/world_pool.h"

namespace hexapod {
namespace {

// Polar method; the second value is thrown away.
double normal(Random& random) {
  for (;;) {
    const double u = random.uniform(-1.0, 1.0), v = random.uniform(-1.0, 1.0);
    const double square = u * u + v * v;
    if (square > 0.0 && square < 1.0) return u * std::sqrt(-2.0 * std::log(square) / square);
  }
}

Pose2 randomGoal(Random& random, double radius_m) {
  const double far_m = radius_m * std::sqrt(random.uniform());
  const double direction_rad = random.uniform(-M_PI, M_PI);
  return {far_m * std::cos(direction_rad), far_m * std::sin(direction_rad),
          random.uniform(-M_PI, M_PI)};
}

bool isIntact(const std::vector<LegState>& legs) {
  return std::all_of(legs.begin(), legs.end(),
                     [](const LegState& leg) { return leg.condition == LegCondition::kIntact; });
}

bool sameLegs(const std::vector<LegState>& a, const std::vector<LegState>& b) {
  if (isIntact(a) || isIntact(b)) return isIntact(a) && isIntact(b);
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const LegState& one, const LegState& other) { return one.condition == other.condition; });
}

// One robot on its way.
class Walker {
 public:
  Walker(World& world, const Repertoire& repertoire, const LearnedWorld& learned,
         const CampaignOptions& options, std::uint64_t number)
      : world_(world),
        repertoire_(repertoire),
        learned_(learned),
        options_(options),
        random_(0x77616c6bu + 7919u * static_cast<std::uint64_t>(options.seed) + number) {}

  GoalWalk walkTo(const Pose2& goal, AdaptivePlanner& planner, const SelfModel* self_model) {
    GoalWalk walk;
    world_.restart();
    PlanRequest request;
    request.world_from_goal = goal;
    request.tolerance = {options_.xy_tolerance_m, options_.yaw_tolerance_rad};
    request.world_from_start = measuredPose();
    for (;;) {
      if (arrived(goal)) return ended(walk, GoalWalk::End::kArrived);
      if (walk.behaviors == options_.max_behaviors) return walk;
      const PlanResult plan = planner.plan(request);
      if (plan.steps.empty()) return ended(walk, GoalWalk::End::kNoPlan);
      const PlannedStep& step = plan.steps.front();
      const Outcome outcome = playEntry(step.entry);
      ++walk.behaviors;
      if (outcome.verdict == Verdict::kSelfCollided) {
        return ended(walk, GoalWalk::End::kLegsTouched);
      }
      if (!outcome.walked()) return ended(walk, GoalWalk::End::kFell);
      const Pose2 before = request.world_from_start;
      request.world_from_start = measuredPose();
      walk.off_m.push_back(distance(step.world_from_end, request.world_from_start));
      walk.off_rad.push_back(headingDistance(step.world_from_end, request.world_from_start));
      planner.observe(step.entry, before, request.world_from_start);
      if (self_model != nullptr) noteBelief(*self_model, walk);
    }
  }

 private:
  static GoalWalk ended(GoalWalk walk, GoalWalk::End end) {
    walk.end = end;
    return walk;
  }

  // Of the true pose: a noisy measurement must not decide it.
  bool arrived(const Pose2& goal) const {
    const Pose2 pose = footprint(world_.worldFromBase());
    return distance(pose, goal) <= options_.xy_tolerance_m &&
           headingDistance(pose, goal) <= options_.yaw_tolerance_rad;
  }

  Pose2 measuredPose() {
    Pose2 pose = footprint(world_.worldFromBase());
    pose.x_m += options_.measurement_noise_m * normal(random_);
    pose.y_m += options_.measurement_noise_m * normal(random_);
    pose.yaw_rad = wrapAngle(pose.yaw_rad + options_.measurement_noise_rad * normal(random_));
    return pose;
  }

  Outcome playEntry(std::size_t entry) {
    const Behavior behavior(world_.robot(), canonical(repertoire_.entries[entry].genome),
                            learned_.behavior);
    return play(world_, behavior, learned_.behavior.command_period_s);
  }

  void noteBelief(const SelfModel& self_model, GoalWalk& walk) const {
    const BodyBelief belief = self_model.belief();
    const std::vector<LegState>& believed = belief.bodies().front().legs;
    const bool right = sameLegs(believed, world_.physics().legs);
    walk.rightly_believed += right ? 1 : 0;
    if (walk.behaviors == 1) walk.right_after_first = right;
    if (isIntact(world_.physics().legs) && !isIntact(believed)) walk.false_alarm = true;
  }

  World& world_;
  const Repertoire& repertoire_;
  const LearnedWorld& learned_;
  const CampaignOptions& options_;
  Random random_;
};

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
      break;
  }
  return std::make_shared<SelfModel>(robot, learned, options, body.physics);
}

// As new as the first one was.
std::shared_ptr<Foresight> anotherOf(const std::shared_ptr<Foresight>& foresight) {
  if (const auto* self_model = dynamic_cast<const SelfModel*>(foresight.get())) {
    return std::make_shared<SelfModel>(*self_model);
  }
  return foresight ? std::make_shared<DeviationForesight>() : nullptr;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
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
      option("engine", options.engine, "Engine of the world that is walked in.", engineNames()),
  };
}

const std::vector<std::string>& adaptationNames() {
  static const std::vector<std::string> names = {"none", "deviation", "self_model", "told"};
  return names;
}

Adaptation adaptationFromText(const std::string& name) {
  const std::vector<std::string>& names = adaptationNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw std::invalid_argument("'" + name +
                                "' is no adaptation; expected none, deviation, self_model or "
                                "told.");
  }
  return static_cast<Adaptation>(found - names.begin());
}

std::vector<GoalWalk> walkToGoals(const RobotDescription& robot, const Repertoire& repertoire,
                                  const TrueBody& body, Adaptation adaptation,
                                  const CampaignOptions& options) {
  const LearnedWorld learned = learnedWorldOf(repertoire);
  Random random(static_cast<std::uint64_t>(options.seed));
  std::vector<Pose2> goals;
  for (std::int64_t i = 0; i < options.goals; ++i) {
    goals.push_back(randomGoal(random, options.radius_m));
  }
  WorldPool pool(chooseEngine(options.engine, robot).engine, robot, body.physics,
                 static_cast<int>(options.threads));
  std::vector<GoalWalk> walks(goals.size());
  const std::shared_ptr<Foresight> foresight =
      foresightFor(adaptation, robot, learned, body, options);
  const AdaptivePlanner planner(repertoire, PlannerOptions(), foresight);
  pool.forEach(goals.size(), [&](World& world, std::size_t i) {
    const std::shared_ptr<Foresight> fresh = anotherOf(foresight);
    AdaptivePlanner own(planner, fresh);
    walks[i] = Walker(world, repertoire, learned, options, i)
                   .walkTo(goals[i], own, dynamic_cast<const SelfModel*>(fresh.get()));
  });
  return walks;
}

CampaignRow summarize(const std::vector<GoalWalk>& walks) {
  CampaignRow row;
  std::vector<double> off_m, off_rad;
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
    for (std::size_t i = 2; i < walk.off_m.size(); ++i) {
      off_m.push_back(walk.off_m[i]);
      off_rad.push_back(walk.off_rad[i]);
    }
  }
  row.behaviors /= static_cast<double>(std::max<std::int64_t>(row.arrived, 1));
  row.right_after_first /= static_cast<double>(row.goals);
  row.false_alarms /= static_cast<double>(row.goals);
  row.off_m = median(off_m);
  row.off_rad = median(off_rad);
  return row;
}

}  // namespace hexapod
