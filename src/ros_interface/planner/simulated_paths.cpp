#include "ros_interface/planner/simulated_paths.h"

#include <ros/console.h>

#include <algorithm>
#include <exception>
#include <numeric>
#include <utility>

#include "ros_interface/common/realtime.h"
#include "self_model/learned_world.h"
#include "simulation/base_path.h"

namespace hexapod {
namespace {

// So many are simulated before it is asked whether they are still wanted.
constexpr std::size_t kAtOnce = 32;
// The robot has other things to do.
constexpr int kThreads = 1;

std::vector<std::size_t> allEntries(const Repertoire& repertoire) {
  std::vector<std::size_t> all(repertoire.entries.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace

/// One repertoire's world.
class SimulatedPaths::Simulation {
 public:
  Simulation(const RobotDescription& robot, const Repertoire& repertoire)
      : learned_(learnedWorldOf(robot, repertoire)),
        worlds_(chooseEngine("reduced", robot).engine, robot, learned_.physics, kThreads) {}

  EntryPaths operator()(const std::vector<Genome>& genomes) {
    return basePaths(worlds_, learned_.behavior, genomes);
  }

 private:
  LearnedWorld learned_;
  WorldPool worlds_;
};

SimulatedPaths::SimulatedPaths(std::optional<RobotDescription> robot)
    : robot_(std::move(robot)), thread_(&SimulatedPaths::work, this) {}

SimulatedPaths::~SimulatedPaths() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    leaves_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

EntryPaths SimulatedPaths::known(const Repertoire& repertoire) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  EntryPaths paths(repertoire.entries.size());
  if (repertoire.run_id != run_id_) return paths;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto found = known_.find(repertoire.entries[i].genome);
    if (found != known_.end()) paths[i] = found->second;
  }
  return paths;
}

void SimulatedPaths::serve(std::shared_ptr<AdaptivePlanner> planner) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    next_ = std::move(planner);
  }
  changed_.notify_all();
}

bool SimulatedPaths::isDone() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return !next_ && !busy_;
}

std::size_t SimulatedPaths::count() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return known_.size();
}

bool SimulatedPaths::isOutdated() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return next_ || leaves_;
}

bool SimulatedPaths::canSimulate(const Repertoire& repertoire) const {
  return robot_ && robot_->digest == repertoire.robot_id;
}

void SimulatedPaths::work() {
  beLessUrgent(Niceness::kThinking);
  for (;;) {
    std::shared_ptr<AdaptivePlanner> planner;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      busy_ = false;
      changed_.wait(lock, [this] { return next_ || leaves_; });
      if (leaves_) return;
      planner = std::exchange(next_, nullptr);
      busy_ = true;
    }
    try {
      if (canSimulate(planner->repertoire())) simulate(*planner);
      planner->prepare([this] { return isOutdated(); });
    } catch (const std::exception& error) {
      ROS_WARN_STREAM(
          "The ways of the repertoire's entries cannot be simulated, plans keep room "
          "beside arcs instead: "
          << error.what());
    }
  }
}

void SimulatedPaths::simulate(AdaptivePlanner& planner) {
  const Repertoire& repertoire = planner.repertoire();
  keepOnly(repertoire);
  Simulation simulation(*robot_, repertoire);
  for (const auto& entries : {planner.planner()->entries(), allEntries(repertoire)}) {
    const std::vector<Genome> genomes = missing(repertoire, entries);
    if (genomes.empty()) continue;
    if (!simulateSome(simulation, genomes)) return;
    planner.setPaths(known(repertoire));
    ROS_INFO_STREAM("Planning along the simulated ways of " << count() << " entries.");
  }
}

/// Forgets other runs, and gaits that have left a repertoire that is still being learned.
void SimulatedPaths::keepOnly(const Repertoire& repertoire) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Known kept;
  if (repertoire.run_id == run_id_) {
    for (const Entry& entry : repertoire.entries) {
      const auto found = known_.find(entry.genome);
      if (found != known_.end()) kept.insert(*found);
    }
  }
  known_ = std::move(kept);
  run_id_ = repertoire.run_id;
}

/// False when nobody waits for it any more.
bool SimulatedPaths::simulateSome(Simulation& simulation, const std::vector<Genome>& genomes) {
  for (std::size_t begin = 0; begin < genomes.size(); begin += kAtOnce) {
    if (isOutdated()) return false;
    const auto from = genomes.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto count = std::min(kAtOnce, genomes.size() - begin);
    const std::vector<Genome> some(from, from + static_cast<std::ptrdiff_t>(count));
    const EntryPaths paths = simulation(some);
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::size_t i = 0; i < count; ++i) known_[some[i]] = paths[i];
  }
  return true;
}

std::vector<Genome> SimulatedPaths::missing(const Repertoire& repertoire,
                                            const std::vector<std::size_t>& entries) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<Genome> genomes;
  for (const std::size_t entry : entries) {
    const Genome& genome = repertoire.entries[entry].genome;
    if (known_.count(genome) == 0) genomes.push_back(genome);
  }
  return genomes;
}

}  // namespace hexapod
