#include "execution/feedback_merger.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ms.h"

namespace hexapod {
namespace {

using Names = std::vector<std::string>;
using Result = FeedbackMerger::Result;

constexpr std::int64_t kRosBegin_ns = 1'700'000'000'000 * kMs;

// Three joints a, b, c, and a clock on which messages come at once.
class FeedbackMergerTest : public testing::Test {
 protected:
  Result say(const Names& names, const std::vector<double>& positions,
             const std::string& source = "/driver") {
    return merger_.add({names,
                        positions,
                        stamped_ ? kRosBegin_ns + now_ms_ * kMs : 0,
                        source,
                        {kRosBegin_ns + now_ms_ * kMs + ros_set_ns_, now_ms_ * kMs}});
  }

  const std::vector<std::uint64_t>& counts() const { return merger_.readings().counts; }
  const std::vector<double>& angles() const { return merger_.readings().angles_rad; }

  FeedbackMerger merger_{{"a", "b", "c"}, 0.5};
  std::int64_t now_ms_ = 10'000;
  std::int64_t ros_set_ns_ = 0;  // somebody set our clock by so much
  bool stamped_ = true;
};

TEST_F(FeedbackMergerTest, TakesJointsInAnyOrderAndLeavesOutOtherDevices) {
  EXPECT_EQ(say({"c", "camera", "a", "b"}, {3, 9, 1, 2}), Result::kUsed);
  EXPECT_EQ(angles(), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(say({"camera"}, {9}), Result::kNothing);
  EXPECT_EQ(say({"gripper", "camera"}, {}), Result::kNothing) << "not about our joints";
  EXPECT_EQ(say({}, {}), Result::kNothing);
}

TEST_F(FeedbackMergerTest, MergesDriversThatEachReadSomeOfTheJoints) {
  EXPECT_EQ(say({"a", "b"}, {1, 2}, "/left"), Result::kUsed);
  EXPECT_EQ(say({"c"}, {3}, "/right"), Result::kUsed);
  now_ms_ += 50;
  EXPECT_EQ(say({"a", "b"}, {4, 5}, "/left"), Result::kUsed);
  EXPECT_EQ(counts(), (std::vector<std::uint64_t>{2, 2, 1}));
  EXPECT_EQ(angles(), (std::vector<double>{4, 5, 3}));
  EXPECT_EQ(merger_.readings().contested_joint, -1);
}

TEST_F(FeedbackMergerTest, RefusesAMessageThatIsWrongAsAWhole) {
  EXPECT_EQ(say({"a", "b"}, {1, NAN}), Result::kRefused);
  EXPECT_NE(merger_.problem().find("'b' is not a finite number"), std::string::npos);
  EXPECT_EQ(say({"a", "a"}, {1, 1}), Result::kRefused);
  EXPECT_NE(merger_.problem().find("'a' occurs twice"), std::string::npos);
  EXPECT_EQ(say({"a", "b"}, {1}), Result::kRefused);
  EXPECT_NE(merger_.problem().find("2 names and 1 positions"), std::string::npos);
  EXPECT_EQ(counts(), (std::vector<std::uint64_t>{0, 0, 0}));
}

TEST_F(FeedbackMergerTest, RefusesStaleStampsAndSaysWhose) {
  const Names names{"a"};
  const std::vector<double> positions{1.0};
  EXPECT_EQ(merger_.add({names, positions, kRosBegin_ns, "/bag", {kRosBegin_ns + 2000 * kMs, 0}}),
            Result::kRefused);
  EXPECT_NE(merger_.problem().find("2000 ms ago by /bag"), std::string::npos) << merger_.problem();
}

TEST_F(FeedbackMergerTest, AStampSeenBeforeIsNothingNew) {
  EXPECT_EQ(say({"a"}, {1}), Result::kUsed);
  EXPECT_EQ(say({"a"}, {2}), Result::kNothing);
  EXPECT_EQ(say({"b"}, {2}), Result::kUsed) << "a driver may tell joint after joint";
  EXPECT_EQ(angles()[0], 1);
  stamped_ = false;
  EXPECT_EQ(say({"a"}, {3}), Result::kUsed) << "without a stamp it is new when it comes";
  EXPECT_EQ(say({"a"}, {4}), Result::kUsed);
}

TEST_F(FeedbackMergerTest, AJointBelongsToTheSourceThatReportedItFirst) {
  say({"a", "b", "c"}, {1, 2, 3});
  EXPECT_EQ(say({"b"}, {0}, "/joint_state_publisher"), Result::kNothing);
  EXPECT_EQ(angles()[1], 2) << "a stray publisher is not believed";
  EXPECT_EQ(merger_.readings().contested_joint, 1);
  EXPECT_EQ(merger_.rivals(1), "/driver and /joint_state_publisher");
  // The stray one is stopped; the contest is forgotten after a while.
  now_ms_ += 2500;
  say({"a", "b", "c"}, {1, 2, 3});
  EXPECT_EQ(merger_.readings().contested_joint, -1);
}

TEST_F(FeedbackMergerTest, ASourceThatIsGoneIsNoticedLongBeforeAnotherTakesItsPlace) {
  say({"a", "b", "c"}, {1, 2, 3});
  for (int i = 0; i < 19; ++i) {
    now_ms_ += 100;
    EXPECT_EQ(say({"a"}, {0}, "/other"), Result::kNothing) << i;
  }
  now_ms_ += 200;
  EXPECT_EQ(say({"a"}, {7}, "/other"), Result::kUsed) << "2 s: four times the timeout";
  EXPECT_EQ(angles()[0], 7);
  EXPECT_EQ(merger_.readings().contested_joint, -1) << "nobody contests what one gave up";
}

TEST_F(FeedbackMergerTest, TellsWhenSomethingElseOfASourceHappenedThoughItsClockIsAnother) {
  constexpr std::int64_t kHour = 3'600'000 * kMs;
  say({"a"}, {1});
  ros_set_ns_ = kHour;
  now_ms_ += 100;
  const Arrival arrival{kRosBegin_ns + now_ms_ * kMs + ros_set_ns_, now_ms_ * kMs};
  const std::int64_t stamp_ns = kRosBegin_ns + (now_ms_ - 30) * kMs;
  EXPECT_EQ(merger_.timeOf("/driver", stamp_ns, arrival), (now_ms_ - 30) * kMs);
  EXPECT_EQ(merger_.timeOf("/driver", stamp_ns + 2 * kHour, arrival), std::nullopt);
  EXPECT_NE(merger_.problem().find("3599970 ms from now by /driver"), std::string::npos)
      << merger_.problem();
  EXPECT_EQ(merger_.timeOf("/stranger", stamp_ns, arrival), std::nullopt) << "an hour ago";
}

TEST_F(FeedbackMergerTest, KeepsNothingOfSourcesThatAreGoneWhenAnotherComes) {
  say({"a"}, {1}, "/gone");
  ros_set_ns_ = 3'600'000 * kMs;
  now_ms_ += 60'000;
  EXPECT_EQ(say({"b"}, {1}, "/gone"), Result::kUsed) << "its clock went on as ours did";
  now_ms_ += 60'000;
  EXPECT_EQ(say({"c"}, {1}, "/new"), Result::kRefused);
  EXPECT_EQ(say({"b"}, {1}, "/gone"), Result::kRefused) << "a stranger, stamped an hour ago";
}

TEST(FeedbackMerger, RefusesTheSameNameTwice) {
  EXPECT_THROW(FeedbackMerger({"a", "a"}, 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
