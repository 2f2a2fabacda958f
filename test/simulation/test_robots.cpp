#include "test_robots.h"

#include <cmath>
#include <string>

#include "common/random.h"
#include "simulation/standing_state.h"

namespace hexapod {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Limb {
  double length_m;
  double radius_m;
  double mass_kg;
  Eigen::Vector3d direction;
};

Eigen::Matrix3d rodInertia(const Limb& limb) {
  const double along = 0.5 * limb.mass_kg * limb.radius_m * limb.radius_m;
  const double across =
      limb.mass_kg * (0.25 * limb.radius_m * limb.radius_m + limb.length_m * limb.length_m / 12.0);
  const Eigen::Matrix3d projection = limb.direction * limb.direction.transpose();
  return along * projection + across * (Eigen::Matrix3d::Identity() - projection);
}

Body limbBody(const std::string& name, const Limb& limb) {
  Shape shape;
  shape.kind = Shape::Kind::kCapsule;
  shape.radius_m = limb.radius_m;
  shape.length_m = limb.length_m - 2.0 * limb.radius_m;
  shape.body_from_shape.translation() = 0.5 * limb.length_m * limb.direction;
  shape.body_from_shape.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), limb.direction)
          .toRotationMatrix();
  Body body;
  body.name = name;
  body.mass_kg = limb.mass_kg;
  body.center_of_mass_m = 0.5 * limb.length_m * limb.direction;
  body.inertia_kg_m2 = rodInertia(limb);
  body.shapes = {shape};
  return body;
}

Joint servo(const std::string& name, const Eigen::Isometry3d& parent_from_joint,
            const Eigen::Vector3d& axis) {
  Joint joint;
  joint.name = name;
  joint.parent_from_joint = parent_from_joint;
  joint.axis = axis;
  joint.lower_rad = -kPi / 2.0;
  joint.upper_rad = kPi / 2.0;
  joint.max_torque_nm = 1.5;
  joint.max_velocity_rad_per_s = 6.28;
  return joint;
}

Leg makeLeg(std::size_t index, double x_m, double y_m, double azimuth_rad) {
  const Limb coxa{0.06, 0.02, 0.020, Eigen::Vector3d::UnitX()};
  const Limb femur{0.085, 0.02, 0.180, Eigen::Vector3d::UnitX()};
  const Limb tibia{0.145, 0.025, 0.060, -Eigen::Vector3d::UnitZ()};
  const std::string number = std::to_string(index);
  Eigen::Isometry3d hip(Eigen::AngleAxisd(azimuth_rad, Eigen::Vector3d::UnitZ()));
  hip.pretranslate(Eigen::Vector3d(x_m, y_m, 0.0));

  Leg leg;
  leg.name = "leg_" + number;
  leg.segments.resize(3);
  leg.segments[0] = {servo("hip_" + number, hip, Eigen::Vector3d::UnitZ()),
                     limbBody("coxa_" + number, coxa)};
  leg.segments[0].joint.amplitude_rad = kPi / 8.0;
  const Eigen::Isometry3d knee(Eigen::Translation3d(coxa.length_m, 0.0, 0.0));
  leg.segments[1] = {servo("knee_" + number, knee, -Eigen::Vector3d::UnitY()),
                     limbBody("femur_" + number, femur)};
  leg.segments[1].joint.amplitude_rad = kPi / 4.0;
  leg.segments[1].joint.signal = Signal::kSecond;
  const Eigen::Isometry3d ankle(Eigen::Translation3d(femur.length_m, 0.0, 0.0));
  leg.segments[2] = {servo("ankle_" + number, ankle, -Eigen::Vector3d::UnitY()),
                     limbBody("tibia_" + number, tibia)};
  leg.segments[2].joint.amplitude_rad = -kPi / 4.0;
  leg.segments[2].joint.signal = Signal::kSecond;
  return leg;
}

bool isLeft(const Leg& leg) {
  return leg.segments[0].joint.parent_from_joint.translation().y() > 0.0;
}

}  // namespace

RobotDescription handMadeHexapod() {
  RobotDescription robot;
  robot.name = "hand-made hexapod";
  robot.base_link = "base_link";
  robot.base.name = "base_link";
  robot.base.mass_kg = 1.5;
  const Eigen::Vector3d size(0.24, 0.20, 0.04);
  const Eigen::Vector3d squares = size.cwiseProduct(size);
  robot.base.inertia_kg_m2 = 1.5 / 12.0 *
                             Eigen::Vector3d(squares.y() + squares.z(), squares.x() + squares.z(),
                                             squares.x() + squares.y())
                                 .asDiagonal()
                                 .toDenseMatrix();
  Shape box;
  box.kind = Shape::Kind::kBox;
  box.size_m = size;
  robot.base.shapes = {box};
  const double degree = kPi / 180.0;
  robot.legs = {makeLeg(0, -0.12, 0.06, 112.5 * degree), makeLeg(1, 0.0, 0.10, 90.0 * degree),
                makeLeg(2, 0.12, 0.06, 67.5 * degree),   makeLeg(3, 0.12, -0.06, -67.5 * degree),
                makeLeg(4, 0.0, -0.10, -90.0 * degree),  makeLeg(5, -0.12, -0.06, -112.5 * degree)};
  return robot;
}

RobotDescription hexapodWithWideHips() {
  RobotDescription robot = handMadeHexapod();
  for (Leg& leg : robot.legs) leg.segments[0].joint.amplitude_rad = kPi / 2.0;
  return robot;
}

RobotDescription hexapodOfBoxes() {
  RobotDescription robot = handMadeHexapod();
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    std::vector<Segment>& segments = robot.legs[leg].segments;
    for (std::size_t s = 1; s < segments.size(); ++s) {
      Shape& shape = segments[s].body.shapes[0];
      // The feet of two legs stay round.
      if (s == 2 && leg % 3 == 1) continue;
      shape.kind = Shape::Kind::kBox;
      shape.size_m = {1.6 * shape.radius_m, 2.0 * shape.radius_m,
                      shape.length_m + 2.0 * shape.radius_m};
      shape.radius_m = shape.length_m = 0.0;
    }
  }
  return robot;
}

Genome standing(const RobotDescription& robot) { return Genome(robot.geneCount(), 0); }

Genome tripod(const RobotDescription& robot) {
  Genome genome;
  for (std::size_t i = 0; i < robot.legs.size(); ++i) {
    // The leg is in the air for the first half of its second signal's period. There the foot must
    // go forward: the first signal runs a quarter ahead or behind, by the side of the robot.
    const int second_phase = i % 2 == 0 ? 0 : 2;
    const int first_phase = (second_phase + (isLeft(robot.legs[i]) ? 1 : 3)) % 4;
    for (const int level : {4, first_phase, 4, second_phase}) {
      genome.push_back(static_cast<std::uint8_t>(level));
    }
  }
  return genome;
}

std::vector<Genome> randomGenomes(const RobotDescription& robot, std::size_t count,
                                  std::uint64_t seed) {
  Random random(seed);
  std::vector<Genome> genomes;
  for (std::size_t i = 0; i < count; ++i) {
    Genome genome;
    for (std::size_t g = 0; g < robot.geneCount(); ++g) {
      genome.push_back(static_cast<std::uint8_t>(random.below(kGeneLevels)));
    }
    genomes.push_back(canonical(genome));
  }
  return genomes;
}

WorldState rolled(const RobotDescription& robot, WorldState state, double roll_rad, double lift_m) {
  const Eigen::Vector3d base_m = Eigen::Map<const Eigen::Vector3d>(state.values.data());
  const Eigen::Quaterniond roll(Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()));
  for (std::size_t index = 0; index <= robot.jointCount(); ++index) {
    double* const body = state.values.data() + index * kStateValuesPerBody;
    Eigen::Map<Eigen::Vector3d> position_m(body);
    position_m = base_m + roll * (position_m - base_m) + lift_m * Eigen::Vector3d::UnitZ();
    const Eigen::Quaterniond turned = roll * Eigen::Quaterniond(body[3], body[4], body[5], body[6]);
    body[3] = turned.w();
    body[4] = turned.x();
    body[5] = turned.y();
    body[6] = turned.z();
  }
  return state;
}

BehaviorOptions shortBehavior() {
  BehaviorOptions options;
  options.gait_duration_s = 0.6;
  options.return_duration_s = 0.3;
  options.rest_duration_s = 0.0;
  return options;
}

}  // namespace hexapod
