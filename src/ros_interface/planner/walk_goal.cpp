#include "ros_interface/planner/walk_goal.h"

namespace hexapod {

WalkReport cancelledEarly() {
  WalkReport report;
  report.code = GoalCode::PREEMPTED;
  report.message = "Cancelled before it arrived.";
  return report;
}

std::uint8_t codeOf(PlanCode code) {
  switch (code) {
    case PlanCode::kFound:
    case PlanCode::kAlreadyThere:
      return GoalCode::SUCCEEDED;
    case PlanCode::kInvalidGoal:
      return GoalCode::INVALID_GOAL;
    case PlanCode::kNoRepertoire:
      return GoalCode::NO_REPERTOIRE;
    case PlanCode::kGoalOccupied:
      return GoalCode::GOAL_OCCUPIED;
    case PlanCode::kStartOccupied:
      return GoalCode::START_OCCUPIED;
    case PlanCode::kBlocked:
      return GoalCode::BLOCKED;
    case PlanCode::kTooManySteps:
      return GoalCode::TOO_MANY_STEPS;
    case PlanCode::kUnreachable:
      return GoalCode::UNREACHABLE;
    case PlanCode::kTimeout:
      return GoalCode::PLANNING_TIMEOUT;
  }
  return GoalCode::UNREACHABLE;
}

std::uint8_t codeOf(const Walk::Decision& decision) {
  switch (decision.state) {
    case WalkState::kArrived:
    case WalkState::kStep:
      return GoalCode::SUCCEEDED;
    case WalkState::kStuck:
      return GoalCode::STUCK;
    case WalkState::kPoseLost:
      return GoalCode::POSE_LOST;
    case WalkState::kNoPlan:
      break;
  }
  return codeOf(decision.plan.code);
}

std::uint8_t codeOf(BehaviorPlayer::End end) {
  switch (end) {
    case BehaviorPlayer::End::kPlayed:
      return GoalCode::SUCCEEDED;
    case BehaviorPlayer::End::kNotReady:
      return GoalCode::EXECUTOR_NOT_READY;
    case BehaviorPlayer::End::kTimeStands:
      return GoalCode::POSE_LOST;
    case BehaviorPlayer::End::kCancelled:
    case BehaviorPlayer::End::kFault:
      break;
  }
  return GoalCode::EXECUTOR_FAULT;
}

}  // namespace hexapod
