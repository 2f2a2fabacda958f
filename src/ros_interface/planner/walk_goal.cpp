#include "ros_interface/planner/walk_goal.h"

namespace hexapod {

using Code = hexapod_repertoire::GoTo::Response;

std::uint8_t codeOf(PlanCode code) {
  switch (code) {
    case PlanCode::kFound:
    case PlanCode::kAlreadyThere:
      return Code::SUCCEEDED;
    case PlanCode::kInvalidGoal:
      return Code::INVALID_GOAL;
    case PlanCode::kNoRepertoire:
      return Code::NO_REPERTOIRE;
    case PlanCode::kUnreachable:
      return Code::UNREACHABLE;
    case PlanCode::kTimeout:
      return Code::PLANNING_TIMEOUT;
  }
  return Code::UNREACHABLE;
}

std::uint8_t codeOf(const Walk::Decision& decision) {
  switch (decision.state) {
    case WalkState::kArrived:
    case WalkState::kStep:
      return Code::SUCCEEDED;
    case WalkState::kStuck:
      return Code::STUCK;
    case WalkState::kPoseLost:
      return Code::POSE_LOST;
    case WalkState::kNoPlan:
      break;
  }
  return codeOf(decision.plan.code);
}

}  // namespace hexapod
