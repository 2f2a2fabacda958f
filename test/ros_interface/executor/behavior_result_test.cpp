#include "ros_interface/executor/behavior_result.h"

#include <gtest/gtest.h>

namespace hexapod {
namespace {

using Result = hexapod_repertoire::ExecuteBehaviorResult;

Result resultOf(Reason reason, std::uint32_t skipped = 0) {
  BehaviorEnd end;
  end.cause.reason = reason;
  end.cause.joint = 1;
  end.skipped = skipped;
  return behaviorResult(end, 130, {"hip", "knee"});
}

TEST(BehaviorResult, SucceededIsABehaviorOfWhichEveryCommandWasSent) {
  EXPECT_EQ(resultOf(Reason::kFinished).code, Result::SUCCEEDED);
  const Result late = resultOf(Reason::kFinished, 7);
  EXPECT_EQ(late.code, Result::SKIPPED);
  EXPECT_EQ(late.skipped, 7u);
  EXPECT_NE(late.message.find("7 of its 130 commands were skipped"), std::string::npos);
}

TEST(BehaviorResult, EveryOtherEndHasACodeOfItsOwnKind) {
  EXPECT_EQ(resultOf(Reason::kCancelled).code, Result::PREEMPTED);
  for (const Reason stop : {Reason::kStopRequested, Reason::kEStop, Reason::kEStopSilent,
                            Reason::kDisarmRequested, Reason::kShutDown}) {
    EXPECT_EQ(resultOf(stop).code, Result::STOPPED) << static_cast<int>(stop);
  }
  for (const Reason fault : {Reason::kFeedbackLost, Reason::kFeedbackFrozen, Reason::kNotFollowing,
                             Reason::kCommandRefused, Reason::kRobotReset, Reason::kTimeJumped}) {
    EXPECT_EQ(resultOf(fault).code, Result::FAULT) << static_cast<int>(fault);
  }
  EXPECT_NE(resultOf(Reason::kNotFollowing).message.find("'knee'"), std::string::npos);
  EXPECT_EQ(resultOf(Reason::kEStop, 7).code, Result::STOPPED) << "however late it was";
}

}  // namespace
}  // namespace hexapod
