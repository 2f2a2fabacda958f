#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "common/random.h"
#include "execution/shipped_robot.h"
#include "self_model/body_belief.h"

namespace hexapod {

/// The shipped robot, in a body of its own, walking.
class WalkedBody {
 public:
  explicit WalkedBody(const std::string& legs, const Physics& otherwise = {})
      : physics_(otherwise) {
    physics_.legs = legStatesFromText(robot_, legs);
    world_ = makeWorld(Engine::kReduced, robot_, physics_);
  }

  /// What is measured of the behaviour; `noise_m` of the positions, a radian per 0.3 m.
  SeenBehavior walk(const Genome& genome, double noise_m = 0.0) {
    SeenBehavior seen;
    seen.genome = genome;
    seen.world_from_before = measured(noise_m);
    const Behavior behavior(robot_, canonical(genome), BehaviorOptions());
    std::vector<double> angles_rad;
    for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
      world_->setTargets(behavior.command(k));
      world_->step();
      world_->step();
      world_->jointAngles(angles_rad);
      joints_.resize(angles_rad.size(), {10.0, -10.0});
      for (std::size_t j = 0; j < angles_rad.size(); ++j) {
        joints_[j].min_rad = std::min(joints_[j].min_rad, angles_rad[j]);
        joints_[j].max_rad = std::max(joints_[j].max_rad, angles_rad[j]);
      }
    }
    seen.world_from_after = measured(noise_m);
    return seen;
  }

  /// From now on it is another body, where and as it stands.
  void become(const std::string& legs) {
    const WorldState now = world_->state();
    physics_.legs = legStatesFromText(robot_, legs);
    world_ = makeWorld(Engine::kReduced, robot_, physics_, &now);
  }

  const RobotDescription& robot() const { return robot_; }

  /// Where it stands.
  Pose2 pose() { return measured(0.0); }

  /// How far each joint has moved so far.
  const std::vector<JointRange>& joints() const { return joints_; }

 private:
  Pose2 measured(double noise_m) {
    Pose2 pose = footprint(world_->worldFromBase());
    if (noise_m == 0.0) return pose;
    pose.x_m += random_.uniform(-1.7, 1.7) * noise_m;
    pose.y_m += random_.uniform(-1.7, 1.7) * noise_m;
    pose.yaw_rad = wrapAngle(pose.yaw_rad + random_.uniform(-1.7, 1.7) * noise_m / 0.3);
    return pose;
  }

  RobotDescription robot_ = shippedRobot();
  Physics physics_;
  std::unique_ptr<World> world_;
  std::vector<JointRange> joints_;
  Random random_{5};
};

/// Gaits of a repertoire of the shipped robot: ahead and left, ahead, back, back and right.
inline std::vector<Genome> walkingGaits() {
  std::vector<Genome> gaits;
  for (const char* digits : {"220011301000404132214310", "211030214241220033301000",
                             "404142214310220021301200", "404132114310200011301300"}) {
    gaits.push_back(genomeFromString(digits));
  }
  return gaits;
}

}  // namespace hexapod
