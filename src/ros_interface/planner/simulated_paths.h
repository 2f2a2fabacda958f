#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "planning/adaptive_planner.h"
#include "robot/robot_description.h"

namespace hexapod {

/// Where base_footprint really is along each entry of the repertoire in use: simulated in the
/// background, by one thread, as the entries were learned; each gait once. The entries that are
/// planned with come first.
///
/// Where the robot is not the one the repertoire was learned for, or not known, no path is. What is
/// planned along then is the arc through the end pose with room beside it. From any thread.
class SimulatedPaths {
 public:
  explicit SimulatedPaths(std::optional<RobotDescription> robot);
  /// Gives up what is not simulated yet; waits for some tens of behaviours at most.
  ~SimulatedPaths();
  SimulatedPaths(const SimulatedPaths&) = delete;
  SimulatedPaths& operator=(const SimulatedPaths&) = delete;

  /// What is known by now, by index of the entry.
  EntryPaths known(const Repertoire& repertoire) const;

  /// Simulates what is missing and tells the planner; a newer planner takes the place of one that
  /// waits or is being served. Returns at once.
  void serve(std::shared_ptr<AdaptivePlanner> planner);

  /// Of the planner served last: all paths are known, or never will be.
  bool isDone() const;

  /// Entries with a known path.
  std::size_t count() const;

 private:
  class Simulation;
  using Known = std::map<Genome, std::vector<Pose2>>;

  bool canSimulate(const Repertoire& repertoire) const;
  void keepOnly(const Repertoire& repertoire);
  void work();
  void simulate(AdaptivePlanner& planner);
  bool simulateSome(Simulation& simulation, const std::vector<Genome>& genomes);
  std::vector<Genome> missing(const Repertoire& repertoire,
                              const std::vector<std::size_t>& entries) const;
  bool isOutdated() const;

  const std::optional<RobotDescription> robot_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<AdaptivePlanner> next_;  // guarded by mutex_, as all that follow
  bool busy_ = false;
  bool leaves_ = false;
  std::string run_id_;
  Known known_;  // of its gaits
  std::thread thread_;
};

}  // namespace hexapod
