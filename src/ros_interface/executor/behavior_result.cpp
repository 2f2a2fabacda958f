#include "ros_interface/executor/behavior_result.h"

namespace hexapod {
namespace {

using Result = hexapod_repertoire::ExecuteBehaviorResult;

std::uint8_t codeOf(const BehaviorEnd& end) {
  switch (end.cause.reason) {
    case Reason::kFinished:
      return end.skipped > 0 ? Result::SKIPPED : Result::SUCCEEDED;
    case Reason::kCancelled:
      return Result::PREEMPTED;
    case Reason::kStopRequested:
    case Reason::kEStop:
    case Reason::kEStopSilent:
    case Reason::kDisarmRequested:
    case Reason::kShutDown:
      return Result::STOPPED;
    default:
      return Result::FAULT;
  }
}

}  // namespace

Result behaviorResult(const BehaviorEnd& end, std::size_t command_count,
                      const std::vector<std::string>& joint_names) {
  Result result;
  result.code = codeOf(end);
  result.message = sentence(end.cause, joint_names);
  result.skipped = end.skipped;
  if (result.code == Result::SKIPPED) {
    result.message += " " + std::to_string(end.skipped) + " of its " +
                      std::to_string(command_count) +
                      " commands were skipped because the executor was late.";
  }
  return result;
}

}  // namespace hexapod
