#include "ros_interface/common/conversions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace hexapod {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Repertoire sample() {
  Repertoire repertoire;
  repertoire.run_id = "run";
  repertoire.robot_id = "robot";
  repertoire.seed = 7;
  repertoire.generation = 3;
  repertoire.evaluations = 300;
  repertoire.behavior_duration_s = 3.9;
  repertoire.joint_names = {"a", "b"};
  Entry learned;
  learned.id = 1;
  learned.genome = {0, 1, 2, 3};
  learned.end_pose = {0.3, 0.1, 0.6};
  learned.cost = 0.05;
  learned.evaluation = 17;
  Entry validated = learned;
  validated.id = 2;
  validated.execution = Execution{{0.29, 0.11, 0.61}, 0.01, 0.02, 8, 1};
  repertoire.entries = {learned, validated};
  return repertoire;
}

TEST(RepertoireMessage, CarriesARepertoireThereAndBack) {
  const Repertoire sent = sample();
  const Repertoire received = fromMsg(toMsg(sent, ros::Time(1.0)));
  EXPECT_EQ(received.run_id, sent.run_id);
  EXPECT_EQ(received.robot_id, sent.robot_id);
  EXPECT_EQ(received.seed, sent.seed);
  EXPECT_EQ(received.joint_names, sent.joint_names);
  EXPECT_EQ(received.behavior_duration_s, sent.behavior_duration_s);
  ASSERT_EQ(received.entries.size(), 2u);
  EXPECT_FALSE(received.entries[0].execution);
  ASSERT_TRUE(received.entries[1].execution);
  EXPECT_EQ(received.entries[1].execution->mean.x_m, 0.29);
  EXPECT_EQ(received.entries[1].execution->falls, 1);
  EXPECT_EQ(received.entries[1].genome, sent.entries[1].genome);
  EXPECT_FALSE(received.entries[1].usable());
}

TEST(RepertoireMessage, TellsTheArcThroughTheEndPoint) {
  const auto message = toMsg(sample(), ros::Time(1.0));
  // 2y / (x^2 + y^2) = 0.2 / 0.1.
  EXPECT_NEAR(message.entries[0].curvature_per_m, 2.0, 1e-12);
  EXPECT_GT(message.entries[0].arc_length_m, std::hypot(0.3, 0.1));
  EXPECT_EQ(message.header.frame_id, "base_footprint");
}

TEST(RepertoireMessage, HasTheGenomesOfMoreLevels) {
  Repertoire sent = sample();
  sent.options["gene_levels"] = "253";
  sent.entries[1].genome = {252, 17, 4, 126};
  const Repertoire received = fromMsg(toMsg(sent, ros::Time(1.0)));
  EXPECT_EQ(received.geneLevels(), 253U);
  EXPECT_EQ(received.entries[1].genome, sent.entries[1].genome);
  sent.entries[1].genome[0] = 253;
  EXPECT_THROW(fromMsg(toMsg(sent, ros::Time(1.0))), std::invalid_argument);
}

TEST(RepertoireMessage, IsRefusedWithTheEntryNamed) {
  auto message = toMsg(sample(), ros::Time(1.0));
  const auto refusal = [](const hexapod_repertoire::Repertoire& wrong) -> std::string {
    try {
      fromMsg(wrong);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  auto wrong = message;
  wrong.entries[1].genome[2] = 5;
  EXPECT_NE(refusal(wrong).find("entry 2 has a gene of level 5"), std::string::npos);
  wrong = message;
  wrong.entries[1].genome.pop_back();
  EXPECT_NE(refusal(wrong).find("entry 2 has 3 genes"), std::string::npos);
  wrong = message;
  wrong.entries[0].end_pose.theta = kNan;
  EXPECT_NE(refusal(wrong).find("entry 1 has an end pose that is not finite"), std::string::npos);
  wrong = message;
  wrong.entries[1].spread_m = kNan;
  EXPECT_NE(refusal(wrong).find("entry 2 has a spread that is negative or not finite"),
            std::string::npos);
  wrong = message;
  wrong.entries[1].falls = wrong.entries[1].trials + 1;
  EXPECT_NE(refusal(wrong).find("falls in"), std::string::npos);
  wrong = message;
  wrong.entries[1].id = 1;
  EXPECT_NE(refusal(wrong).find("entry 1 stands there twice"), std::string::npos);
}

std::string problemOf(const geometry_msgs::Pose& pose) {
  std::string problem;
  EXPECT_FALSE(fromPoseMsg(pose, problem));
  return problem;
}

TEST(PoseMessage, CarriesAPoseThereAndBack) {
  std::string problem;
  for (const double yaw : {-3.0, -0.5, 0.0, 1.0, 3.1}) {
    const auto pose = fromPoseMsg(toPoseMsg({1.0, -2.0, yaw}), problem);
    ASSERT_TRUE(pose) << problem;
    EXPECT_NEAR(pose->x_m, 1.0, 1e-12);
    EXPECT_NEAR(pose->yaw_rad, yaw, 1e-12);
  }
}

TEST(PoseMessage, IsRefusedWhenItIsNoPoseInThePlane) {
  geometry_msgs::Pose pose;
  EXPECT_NE(problemOf(pose).find("quaternion has length 0"), std::string::npos);
  pose.orientation.w = 2.0;
  EXPECT_NE(problemOf(pose).find("length 2"), std::string::npos);
  pose.orientation.w = 1.0;
  pose.position.y = kNan;
  EXPECT_NE(problemOf(pose).find("not a finite number"), std::string::npos);
  pose.position.y = 0.0;
  pose.orientation.x = std::sqrt(0.5);
  pose.orientation.w = std::sqrt(0.5);
  EXPECT_NE(problemOf(pose).find("tilted"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
