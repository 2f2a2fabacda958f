#include "ros_interface/executor/body_report.h"

#include <ros/console.h>

#include "common/text.h"

namespace hexapod {
namespace {

void logTolerated(const std::vector<std::string>& joints) {
  if (joints.empty()) {
    ROS_INFO_STREAM("Every joint is watched again.");
  } else {
    ROS_INFO_STREAM("Going on without " << listed(joints) << ", which are believed dead.");
  }
}

void logDoubted(const std::vector<std::string>& joints) {
  if (joints.empty()) return;
  ROS_WARN_STREAM("These joints belong to a leg that does not follow or is not read: "
                  << listed(joints)
                  << ". Going on until a whole behaviour has shown whether it is dead.");
}

}  // namespace

BodyReport::BodyReport(const RobotDescription& robot, const SharedExecutor& executor,
                       const BeliefListener& belief)
    : executor_(executor), belief_(belief), joint_names_(robot.jointNames()) {
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    leg_of_joint_.insert(leg_of_joint_.end(), robot.legs[leg].segments.size(), leg);
  }
}

bool BodyReport::poll(const ExecutorStatus& status) {
  const std::string problem = belief_.problem();
  const std::vector<std::string> tolerated = namesOfTolerated();
  const std::vector<std::string> doubted = namesOfDoubted(status.doubted_legs);
  if (problem != problem_ && !problem.empty()) ROS_ERROR_STREAM(problem);
  if (doubted != doubted_) logDoubted(doubted);
  if (tolerated != tolerated_) logTolerated(tolerated);
  const bool is_new = problem != problem_ || doubted != doubted_ || tolerated != tolerated_;
  problem_ = problem;
  tolerated_ = tolerated;
  doubted_ = doubted;
  return is_new;
}

std::vector<std::string> BodyReport::namesOfTolerated() const {
  std::vector<std::string> names;
  for (const std::size_t joint : executor_.toleratedJoints()) {
    names.push_back(joint_names_[joint]);
  }
  return names;
}

std::vector<std::string> BodyReport::namesOfDoubted(std::uint64_t legs) const {
  std::vector<std::string> names;
  for (std::size_t joint = 0; joint < joint_names_.size(); ++joint) {
    const bool is_doubted = leg_of_joint_[joint] < 64 && (legs >> leg_of_joint_[joint] & 1u) != 0;
    if (is_doubted) names.push_back(joint_names_[joint]);
  }
  return names;
}

void BodyReport::report(diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  using Status = diagnostic_msgs::DiagnosticStatus;
  const bool whole = tolerated_.empty() && doubted_.empty();
  diagnostics.summary(
      whole ? Status::OK : Status::WARN,
      whole ? "Every joint is watched." : "Some joints need neither follow nor be read.");
  if (!problem_.empty()) diagnostics.mergeSummary(Status::ERROR, problem_);
  diagnostics.add("Believed dead", listed(tolerated_));
  diagnostics.add("In doubt", listed(doubted_));
}

}  // namespace hexapod
