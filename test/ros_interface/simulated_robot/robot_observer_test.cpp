#include "ros_interface/simulated_robot/robot_observer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "execution/shipped_robot.h"

namespace hexapod {
namespace {

// A robot that is where a test puts it.
class FakeWorld : public World {
 public:
  const RobotDescription& robot() const override { return shippedRobot(); }
  const Physics& physics() const override { return physics_; }
  void restart() override {}
  WorldState state() const override { return {}; }
  void restore(const WorldState&) override {}
  void setTargets(const std::vector<double>&) override {}
  Verdict step() override { return Verdict::kWalked; }
  Eigen::Isometry3d worldFromBase() const override { return world_from_base; }
  void jointAngles(std::vector<double>& angles) const override { angles = angles_rad; }

  void put(double x_m, double y_m, double yaw_rad) {
    world_from_base =
        Eigen::Translation3d(x_m, y_m, 0.1) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
  }

  Eigen::Isometry3d world_from_base = Eigen::Isometry3d::Identity();
  std::vector<double> angles_rad = shippedRobot().neutralPose();

 private:
  Physics physics_;
};

Eigen::Isometry3d isometryOf(const geometry_msgs::TransformStamped& message) {
  const auto& transform = message.transform;
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.translation() << transform.translation.x, transform.translation.y,
      transform.translation.z;
  const auto& q = transform.rotation;
  isometry.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  return isometry;
}

class RobotObserverTest : public testing::Test {
 protected:
  FakeWorld world_;
  RobotObserver observer_{shippedRobot()};
};

TEST_F(RobotObserverTest, ReportsEveryJointByName) {
  world_.angles_rad[7] = 0.123;
  const RobotReport* report = observer_.observe(world_, ros::Time(5.0));
  ASSERT_NE(report, nullptr);
  EXPECT_EQ(report->joints.name, shippedRobot().jointNames());
  EXPECT_EQ(report->joints.position, world_.angles_rad);
  EXPECT_EQ(report->joints.header.stamp, ros::Time(5.0));
}

TEST_F(RobotObserverTest, TheTwoTransformsLeadToTheBase) {
  world_.world_from_base = Eigen::Translation3d(0.4, -0.3, 0.12) *
                           Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ()) *
                           Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY());
  const RobotReport* report = observer_.observe(world_, ros::Time(5.0));
  ASSERT_EQ(report->transforms.size(), 2u);
  const auto& [footprint, base] = std::pair(report->transforms[0], report->transforms[1]);
  EXPECT_EQ(footprint.header.frame_id, "odom");
  EXPECT_EQ(footprint.child_frame_id, "base_footprint");
  EXPECT_EQ(base.header.frame_id, "base_footprint");
  EXPECT_EQ(base.child_frame_id, shippedRobot().base_link);
  EXPECT_EQ(footprint.transform.translation.z, 0.0);
  EXPECT_EQ(footprint.transform.rotation.x, 0.0);
  const Eigen::Isometry3d link_from_base(
      Eigen::AngleAxisd(shippedRobot().link_from_base_yaw_rad, Eigen::Vector3d::UnitZ()));
  const Eigen::Isometry3d world_from_base =
      isometryOf(footprint) * isometryOf(base) * link_from_base;
  EXPECT_TRUE(world_from_base.isApprox(world_.world_from_base, 1e-12));
}

TEST_F(RobotObserverTest, VelocityIsTheMotionSinceTheLastReportInTheFootprintsFrame) {
  world_.put(1.0, 2.0, M_PI / 2.0);
  EXPECT_EQ(observer_.observe(world_, ros::Time(5.0))->odometry.twist.twist.linear.x, 0.0);
  world_.put(1.0, 2.03, M_PI / 2.0);  // it looks along y: 0.03 m ahead in 0.1 s
  const RobotReport* report = observer_.observe(world_, ros::Time(5.1));
  EXPECT_NEAR(report->odometry.twist.twist.linear.x, 0.3, 1e-9);
  EXPECT_NEAR(report->odometry.twist.twist.linear.y, 0.0, 1e-9);
  EXPECT_NEAR(report->odometry.pose.pose.position.y, 2.03, 1e-12);
  observer_.forgetMotion();
  world_.put(0.0, 0.0, 0.0);
  EXPECT_EQ(observer_.observe(world_, ros::Time(5.2))->odometry.twist.twist.linear.x, 0.0)
      << "it was put elsewhere, it did not walk there";
}

TEST_F(RobotObserverTest, NothingThatIsNotFiniteIsReported) {
  world_.angles_rad[3] = NAN;
  EXPECT_EQ(observer_.observe(world_, ros::Time(5.0)), nullptr);
  world_.angles_rad[3] = 0.0;
  world_.world_from_base.translation().x() = INFINITY;
  EXPECT_EQ(observer_.observe(world_, ros::Time(5.0)), nullptr);
}

TEST_F(RobotObserverTest, JointsOfAMissingLegAreNotReportedAndAnglesAreNoisyAsAsked) {
  Disturbance disturbance;
  disturbance.physics.legs.resize(6);
  disturbance.physics.legs[1].condition = LegCondition::kMissing;
  disturbance.physics.legs[2].condition = LegCondition::kLimp;
  disturbance.feedback_noise_rad = 0.02;
  observer_.disturb(shippedRobot(), disturbance);
  double sum = 0.0;
  double count = 0.0;
  for (int i = 0; i < 200; ++i) {
    const RobotReport* report = observer_.observe(world_, ros::Time(5.0 + i));
    ASSERT_EQ(report->joints.name.size(), 15u);
    EXPECT_EQ(report->joints.name[2], shippedRobot().jointNames()[2]);
    EXPECT_EQ(report->joints.name[3], shippedRobot().jointNames()[6]);
    for (std::size_t j = 0; j < 3; ++j, ++count) {
      sum += std::pow(report->joints.position[j] - world_.angles_rad[j], 2);
    }
  }
  EXPECT_NEAR(std::sqrt(sum / count), 0.02, 0.003);
  observer_.disturb(shippedRobot(), {});
  EXPECT_EQ(observer_.observe(world_, ros::Time(500.0))->joints.position, world_.angles_rad);
}

}  // namespace
}  // namespace hexapod
