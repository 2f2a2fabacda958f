#include "robot/digest.h"

#include <gtest/gtest.h>

#include <functional>
#include <locale>
#include <set>

#include "shipped_files.h"

namespace hexapod {
namespace {

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Digest, IsSixteenHexadecimalDigitsAndTheSameEveryTime) {
  const std::string digest = loadRobot(kUrdfFile, kYamlFile).digest;
  EXPECT_EQ(digest.size(), 16u);
  EXPECT_EQ(digest.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(digest, loadRobot(kUrdfFile, kYamlFile).digest);
}

TEST(Digest, IgnoresCommentsLayoutColoursAndFileNames) {
  const std::string urdf = contentOf(kUrdfFile);
  const std::string yaml = contentOf(kYamlFile);
  const std::string digest = parseRobot(urdf, yaml, "a", "b").digest;
  EXPECT_EQ(
      parseRobot(replaced(urdf, "</robot>", "<!-- more -->\n\n</robot>"),
                 "# more\n\n" + replaced(yaml, "gain_per_s: 16.0", "gain_per_s:   16"), "c", "d")
          .digest,
      digest);
  EXPECT_EQ(parseRobot(replaced(urdf, "0.13 0.45 0.70 1", "1 0 0 1"), yaml, "a", "b").digest,
            digest);
}

TEST(Digest, IsTheSameWhenTheLocaleHasADecimalComma) {
  const std::string digest = loadRobot(kUrdfFile, kYamlFile).digest;
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const std::string with_comma = loadRobot(kUrdfFile, kYamlFile).digest;
  std::locale::global(before);
  EXPECT_EQ(with_comma, digest);
}

TEST(Digest, IgnoresTheLastBitsOfARotation) {
  RobotDescription robot = loadRobot(kUrdfFile, kYamlFile);
  Joint& joint = robot.legs[1].segments[0].joint;
  joint.parent_from_joint.linear()(0, 0) += 1e-16;
  joint.parent_from_joint.linear()(1, 0) *= 1.0 - 1e-15;
  EXPECT_EQ(digestOf(robot), robot.digest);
}

TEST(Digest, ChangesWithEveryField) {
  using Edit = std::function<void(RobotDescription&)>;
  const auto segment = [](RobotDescription& r) -> Segment& { return r.legs[5].segments[2]; };
  const std::vector<Edit> edits = {
      [](auto& r) { r.name += "x"; },
      [](auto& r) { r.base_link += "x"; },
      [](auto& r) { r.base.name += "x"; },
      [](auto& r) { r.base.mass_kg += 1e-9; },
      [](auto& r) { r.base.center_of_mass_m.y() += 1e-9; },
      [](auto& r) { r.base.inertia_kg_m2(1, 2) += 1e-9; },
      [](auto& r) { r.base.shapes[0].kind = Shape::Kind::kSphere; },
      [](auto& r) { r.base.shapes[0].size_m.z() += 1e-9; },
      [](auto& r) { r.base.shapes.clear(); },
      [&](auto& r) { segment(r).body.shapes[0].radius_m += 1e-9; },
      [&](auto& r) { segment(r).body.shapes[0].length_m += 1e-9; },
      [&](auto& r) { segment(r).body.shapes[0].body_from_shape.translation().x() += 1e-9; },
      [&](auto& r) { segment(r).joint.name += "x"; },
      [&](auto& r) { segment(r).joint.parent_from_joint.translation().z() += 1e-9; },
      [&](auto& r) { segment(r).joint.axis = Eigen::Vector3d::UnitX(); },
      [&](auto& r) { segment(r).joint.lower_rad += 1e-9; },
      [&](auto& r) { segment(r).joint.upper_rad += 1e-9; },
      [&](auto& r) { segment(r).joint.max_torque_nm += 1e-9; },
      [&](auto& r) { segment(r).joint.max_velocity_rad_per_s += 1e-9; },
      [&](auto& r) { segment(r).joint.neutral_rad += 1e-9; },
      [&](auto& r) { segment(r).joint.amplitude_rad += 1e-9; },
      [&](auto& r) { segment(r).joint.signal = Signal::kFirst; },
      [](auto& r) { r.legs[0].name += "x"; },
      [](auto& r) { r.legs[0].segments.pop_back(); },
      [](auto& r) { r.legs.pop_back(); },
      [](auto& r) { std::swap(r.legs[0], r.legs[1]); },
      [](auto& r) { r.servo.gain_per_s += 1e-9; },
      [](auto& r) { r.servo.dead_zone_rad_per_s += 1e-9; },
      [](auto& r) { r.contact.friction += 1e-9; },
      [](auto& r) { r.contact.slip_per_n_s += 1e-9; },
      [](auto& r) { r.contact.soft_erp += 1e-9; },
      [](auto& r) { r.contact.soft_cfm += 1e-9; },
      [](auto& r) { r.contact.max_correcting_velocity_m_per_s += 1e-9; },
      [](auto& r) { r.contact.joint_erp += 1e-9; },
      [](auto& r) { r.contact.joint_cfm += 1e-9; },
      [](auto& r) { r.failure.max_base_height_m += 1e-9; },
  };
  const RobotDescription robot = loadRobot(kUrdfFile, kYamlFile);
  std::set<std::string> digests = {robot.digest};
  for (std::size_t i = 0; i < edits.size(); ++i) {
    RobotDescription edited = robot;
    edits[i](edited);
    EXPECT_TRUE(digests.insert(digestOf(edited)).second) << "edit " << i;
  }
}

}  // namespace
}  // namespace hexapod
