#include "robot_import/check_robot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <deque>
#include <stdexcept>
#include <utility>

#include "common/random.h"
#include "gait/behavior.h"
#include "gait/genome.h"
#include "robot/dimensions.h"
#include "robot_import/leg_model.h"
#include "simulation/kinematics.h"
#include "simulation/reduced/batch_rollout.h"
#include "simulation/rollout.h"
#include "simulation/world.h"

namespace hexapod {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr double kFineStep_s = 0.005;
constexpr double kTouches_m = 1e-3;
// A joint is back within this of where it stands.
constexpr double kBack_rad = 0.03;
constexpr double kLongestReturn_s = 3.0;
constexpr int kReturns = 20;

std::vector<Genome> randomGenomes(const RobotDescription& robot, int count) {
  Random random(kSeed);
  std::vector<Genome> genomes;
  for (int i = 0; i < count; ++i) {
    Genome genome(robot.geneCount());
    for (auto& gene : genome) gene = static_cast<std::uint8_t>(random.below(kGeneLevels));
    genomes.push_back(std::move(genome));
  }
  return genomes;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

std::vector<Outcome> outcomes(World& world, const std::deque<Behavior>& behaviors,
                              double command_period_s) {
  std::vector<BatchRun> runs;
  for (const Behavior& behavior : behaviors) runs.push_back({&behavior, nullptr});
  return playEach(world, runs, command_period_s);
}

// Static torques with the weight shared by all feet, each in the middle of nothing else.
double standingTorqueShare(const RobotDescription& robot) {
  const double load_n =
      kGravity_m_per_s2 * totalMass_kg(robot) / static_cast<double>(robot.legs.size());
  double most = 0.0;
  for (const Leg& leg : robot.legs) {
    std::vector<double> neutral;
    for (const Segment& segment : leg.segments) neutral.push_back(segment.joint.neutral_rad);
    const LegPose pose = LegModel(leg).at(neutral);
    for (std::size_t j = 0; j < neutral.size(); ++j) {
      const double torque_nm = std::abs(pose.jacobian_m(2, static_cast<Eigen::Index>(j))) * load_n;
      most = std::max(most, torque_nm / leg.segments[j].joint.max_torque_nm);
    }
  }
  return most;
}

std::vector<std::string> linksOnFloor(const RobotDescription& robot, const World& world) {
  std::vector<double> angles_rad;
  world.jointAngles(angles_rad);
  const auto poses = baseFromBodies(robot, angles_rad);
  const auto all = bodies(robot);
  std::vector<std::string> names;
  for (std::size_t b = 0; b < all.size(); ++b) {
    const bool touches =
        std::any_of(all[b]->shapes.begin(), all[b]->shapes.end(), [&](const Shape& shape) {
          return lowestPoint(shape, world.worldFromBase() * poses[b] * shape.body_from_shape) <
                 kTouches_m;
        });
    if (touches) names.push_back(all[b]->name);
  }
  return names;
}

// Time until all joints are, after a gait, where they are when the robot stands.
double returnTime_s(World& world, const Behavior& gait, const BehaviorOptions& options) {
  world.restart();
  std::vector<double> standing_rad, now_rad;
  world.jointAngles(standing_rad);
  play(world, gait, options.command_period_s);
  world.setTargets(world.robot().neutralPose());
  const double step_s = world.physics().step_s;
  double back_s = 0.0;
  for (double time_s = step_s; time_s <= kLongestReturn_s; time_s += step_s) {
    world.step();
    world.jointAngles(now_rad);
    for (std::size_t j = 0; j < now_rad.size(); ++j) {
      if (std::abs(now_rad[j] - standing_rad[j]) > kBack_rad) back_s = time_s;
    }
  }
  return back_s;
}

std::string centimetres(const Eigen::Vector3d& way_m) {
  char text[64];
  std::snprintf(text, sizeof(text), "(%+.1f %+.1f %+.1f)", 100.0 * way_m.x(), 100.0 * way_m.y(),
                100.0 * way_m.z());
  return text;
}

// Of the foot, when all joints move by their amplitudes.
std::string wayOf(const Leg& leg) {
  const LegModel model(leg);
  const auto footAt = [&](double gamma) {
    std::vector<double> angles_rad;
    for (const Segment& segment : leg.segments) {
      angles_rad.push_back(segment.joint.neutral_rad + gamma * segment.joint.amplitude_rad);
    }
    return model.at(angles_rad).foot_m;
  };
  const Eigen::Vector3d neutral = footAt(0.0);
  return centimetres(footAt(-1.0) - neutral) + " .. " + centimetres(footAt(1.0) - neutral);
}

}  // namespace

StandingCheck checkStanding(const RobotDescription& robot) {
  StandingCheck check;
  try {
    const EngineChoice choice = chooseEngine(engineNames().front(), robot);
    const auto world = makeWorld(choice.engine, robot, Physics{});
    const Eigen::Isometry3d world_from_base = world->worldFromBase();
    check.height_m = world_from_base.translation().z();
    check.tilt_rad = std::acos(std::clamp(world_from_base.linear()(2, 2), -1.0, 1.0));
    std::vector<double> angles_rad;
    world->jointAngles(angles_rad);
    const std::vector<double> neutral = robot.neutralPose();
    for (std::size_t j = 0; j < neutral.size(); ++j) {
      check.sag_rad = std::max(check.sag_rad, std::abs(angles_rad[j] - neutral[j]));
    }
    check.on_floor = linksOnFloor(robot, *world);
    check.torque_share = standingTorqueShare(robot);
  } catch (const std::runtime_error& error) {
    check.failure = error.what();
  }
  return check;
}

RandomGaitsCheck checkRandomGaits(const RobotDescription& robot, int gaits) {
  const EngineChoice choice = chooseEngine(engineNames().front(), robot);
  RandomGaitsCheck check;
  check.engine = toString(choice.engine);
  check.engine_remark = choice.remark;
  check.gaits = gaits;
  BehaviorOptions options;
  std::deque<Behavior> behaviors;
  for (const Genome& genome : randomGenomes(robot, gaits)) {
    behaviors.emplace_back(robot, genome, options);
  }
  const auto world = makeWorld(choice.engine, robot, Physics{});
  const std::clock_t start = std::clock();  // of this process: others do not count
  const auto ends = outcomes(*world, behaviors, options.command_period_s);
  const double took_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  check.evaluations_per_s = gaits / std::max(1e-3, took_s);
  Physics fine;
  fine.step_s = kFineStep_s;
  const auto fine_world = makeWorld(choice.engine, robot, fine);
  const auto fine_ends = outcomes(*fine_world, behaviors, options.command_period_s);
  std::vector<double> ways_m, shifts_m;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    check.fell += ends[i].verdict == Verdict::kFell ? 1 : 0;
    check.self_collided += ends[i].verdict == Verdict::kSelfCollided ? 1 : 0;
    check.diverged += ends[i].verdict == Verdict::kDiverged ? 1 : 0;
    if (!ends[i].walked()) continue;
    ways_m.push_back(distance(ends[i].end_pose, Pose2{}));
    if (!fine_ends[i].walked()) continue;
    shifts_m.push_back(distance(ends[i].end_pose, fine_ends[i].end_pose));
  }
  check.median_way_m = quantile(ways_m, 0.5);
  check.largest_way_m = quantile(ways_m, 1.0);
  check.median_shift_m = quantile(shifts_m, 0.5);
  options.end_pose = EndPose::kAfterGait;
  std::vector<double> returns_s;
  for (const Genome& genome : randomGenomes(robot, std::min(gaits, kReturns))) {
    returns_s.push_back(returnTime_s(*world, Behavior(robot, genome, options), options));
  }
  check.back_to_neutral_s = quantile(returns_s, 0.9);
  return check;
}

std::string footWay(const Leg& leg, Signal signal) {
  Leg moved = leg;
  for (Segment& segment : moved.segments) {
    if (segment.joint.signal != signal) segment.joint.amplitude_rad = 0.0;
  }
  return wayOf(moved);
}

std::string footWay(const Leg& leg, std::size_t joint) {
  Leg moved = leg;
  for (std::size_t j = 0; j < moved.segments.size(); ++j) {
    if (j != joint) moved.segments[j].joint.amplitude_rad = 0.0;
  }
  return wayOf(moved);
}

std::string footWay(const Leg& leg) {
  return leg.name + ": signal 1 " + footWay(leg, Signal::kFirst) + ", signal 2 " +
         footWay(leg, Signal::kSecond);
}

}  // namespace hexapod
