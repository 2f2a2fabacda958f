#include "calibration/calibrated_robot.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "robot/load_robot.h"

namespace hexapod {
namespace {

std::string contentOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

RobotDescription robotOf(const std::string& yaml) {
  return parseRobot(contentOf("urdf/hexapod.urdf"), yaml, "hexapod.urdf", "hexapod.yaml");
}

TEST(CalibratedRobot, IsTheRobotScaled) {
  const std::string yaml = contentOf("config/hexapod.yaml");
  const RobotDescription before = robotOf(yaml);
  const RobotDescription after = robotOf(calibratedYaml(yaml, "a.yaml", {0.5, 0.75, 0.8, 1.25}));
  EXPECT_DOUBLE_EQ(after.contact.friction, 0.5 * before.contact.friction);
  EXPECT_DOUBLE_EQ(after.servo.gain_per_s, 0.75 * before.servo.gain_per_s);
  EXPECT_DOUBLE_EQ(after.base.mass_kg, 1.25 * before.base.mass_kg);
  const Segment &thin = before.legs[2].segments[1], &thick = after.legs[2].segments[1];
  EXPECT_DOUBLE_EQ(thick.joint.max_torque_nm, 0.8 * thin.joint.max_torque_nm);
  EXPECT_DOUBLE_EQ(thick.body.mass_kg, 1.25 * thin.body.mass_kg);
  EXPECT_TRUE(thick.body.inertia_kg_m2.isApprox(1.25 * thin.body.inertia_kg_m2));
  EXPECT_EQ(thick.body.center_of_mass_m, thin.body.center_of_mass_m);
  EXPECT_NE(after.digest, before.digest);
}

TEST(CalibratedRobot, KeepsAllElseOfItsFile) {
  const std::string yaml = contentOf("config/hexapod.yaml");
  const std::string calibrated = calibratedYaml(yaml, "a.yaml", {0.5, 1.0, 1.0, 1.0});
  EXPECT_EQ(calibrated.substr(0, yaml.size()), yaml);
}

TEST(CalibratedRobot, CalibratedAgainMultiplies) {
  const std::string once =
      calibratedYaml(contentOf("config/hexapod.yaml"), "a.yaml", {0.5, 0.8, 1.0, 1.0});
  const std::string twice = calibratedYaml(once, "a.yaml", {0.5, 1.0, 1.0, 2.0});
  EXPECT_EQ(twice,
            calibratedYaml(contentOf("config/hexapod.yaml"), "a.yaml", {0.25, 0.8, 1.0, 2.0}));
}

TEST(CalibratedRobot, RefusesWhatIsNoRobot) {
  EXPECT_THROW(calibratedYaml("name: [", "a.yaml", {}), std::runtime_error);
  try {
    robotOf(contentOf("config/hexapod.yaml") + "\ncalibration:\n  friction_scale: 0.0\n");
    FAIL() << "it was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("calibration.friction_scale"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("calibration.mass_scale"), std::string::npos);
  }
}

}  // namespace
}  // namespace hexapod
