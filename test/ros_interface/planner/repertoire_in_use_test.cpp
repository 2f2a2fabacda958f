#include "ros_interface/planner/repertoire_in_use.h"

#include <gtest/gtest.h>

#include "planning/arc_repertoire.h"
#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

class RepertoireInUseTest : public testing::Test {
 protected:
  static hexapod_repertoire::Repertoire message(const std::string& run_id,
                                                const std::string& robot_id = "robot") {
    Repertoire repertoire = arcRepertoire(50, 1);
    repertoire.run_id = run_id;
    repertoire.robot_id = robot_id;
    return toMsg(repertoire, ros::Time(1.0));
  }
  std::string run() const {
    return in_use_.planner() ? in_use_.planner()->repertoire().run_id : "";
  }

  std::vector<std::string> publishers_;
  RepertoireInUse in_use_{PlannerOptions(), "robot", [this] { return publishers_; }};
};

TEST_F(RepertoireInUseTest, RefusesTheRepertoireOfAnotherRobotNamingBoth) {
  const auto taken = in_use_.take(message("a", "another"), "/server");
  EXPECT_FALSE(taken.in_use);
  EXPECT_NE(taken.message.find("another"), std::string::npos);
  EXPECT_EQ(in_use_.planner(), nullptr);
  EXPECT_TRUE(in_use_.take(message("a"), "/server").in_use);
  // One that names no robot (imported) may be planned with.
  EXPECT_TRUE(in_use_.take(message("b", ""), "/server").in_use);
}

TEST_F(RepertoireInUseTest, KeepsTheFirstOfTwoPublishersAndNamesBoth) {
  publishers_ = {"/server", "/learner"};
  EXPECT_TRUE(in_use_.take(message("a"), "/server").in_use);
  const auto taken = in_use_.take(message("b"), "/learner");
  EXPECT_FALSE(taken.in_use);
  EXPECT_NE(taken.message.find("/server"), std::string::npos);
  EXPECT_NE(taken.message.find("/learner"), std::string::npos);
  EXPECT_EQ(run(), "a");
  EXPECT_TRUE(in_use_.take(message("c"), "/server").in_use);
  publishers_ = {"/learner"};
  EXPECT_TRUE(in_use_.take(message("b"), "/learner").in_use);
  EXPECT_EQ(run(), "b");
}

TEST_F(RepertoireInUseTest, KeepsTheEarlierOneWhenAMessageIsWrong) {
  in_use_.take(message("a"), "/server");
  auto wrong = message("a");
  wrong.entries[3].id = wrong.entries[2].id;
  const auto taken = in_use_.take(wrong, "/server");
  EXPECT_FALSE(taken.in_use);
  EXPECT_NE(taken.message.find("stays in use"), std::string::npos);
  EXPECT_EQ(run(), "a");
}

TEST_F(RepertoireInUseTest, KeepsWhatWasLearnedOfTheSameRunOnly) {
  in_use_.take(message("a"), "/server");
  const auto first = in_use_.planner();
  Pose2 pose;
  for (std::size_t i = 0; i < 20; ++i) {
    const Pose2 step = first->repertoire().entries.at(i).expectedPose();
    const Pose2 end = pose * Pose2{1.3 * step.x_m, 1.3 * step.y_m, step.yaw_rad};
    first->observe(i, pose, end);
    pose = end;
  }
  const double learned_m = first->planner()->reach_m();
  in_use_.take(message("a"), "/server");
  EXPECT_NE(in_use_.planner(), first);
  EXPECT_EQ(in_use_.planner()->planner()->reach_m(), learned_m);
  in_use_.take(message("b"), "/server");
  EXPECT_LT(in_use_.planner()->planner()->reach_m(), 0.9 * learned_m);
}

}  // namespace
}  // namespace hexapod
