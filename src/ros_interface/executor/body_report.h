#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <cstdint>
#include <string>
#include <vector>

#include "execution/executor_status.h"
#include "execution/shared_executor.h"
#include "robot/robot_description.h"
#include "ros_interface/executor/belief_listener.h"

namespace hexapod {

/// Tells which joints the executor goes on without: those that are believed dead, and those that
/// are in doubt. Used by one thread.
class BodyReport {
 public:
  /// The references must outlive it.
  BodyReport(const RobotDescription& robot, const SharedExecutor& executor,
             const BeliefListener& belief);

  /// Logs what is new. True when something is.
  bool poll(const ExecutorStatus& status);

  /// Names of the joints, as of the last poll().
  const std::vector<std::string>& tolerated() const { return tolerated_; }
  const std::vector<std::string>& doubted() const { return doubted_; }

  void report(diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

 private:
  std::vector<std::string> namesOfTolerated() const;
  std::vector<std::string> namesOfDoubted(std::uint64_t legs) const;

  const SharedExecutor& executor_;
  const BeliefListener& belief_;
  std::vector<std::string> joint_names_;
  std::vector<std::size_t> leg_of_joint_;
  std::vector<std::string> tolerated_;
  std::vector<std::string> doubted_;
  std::string problem_;
};

}  // namespace hexapod
