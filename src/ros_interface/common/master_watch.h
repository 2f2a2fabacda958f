#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hexapod {

/// Asks the master twice a second, in a thread of its own: is it still the same, and who else
/// publishes on the topics that matter to this node? Public functions from any thread.
class MasterWatch {
 public:
  /// `topics`: resolved names of the topics to look at.
  explicit MasterWatch(std::vector<std::string> topics);
  /// Waits for the question under way, some milliseconds unless the master hangs.
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  /// True once the master has been silent for about a second, or is another process than at the
  /// start: this node is then registered nowhere, and must be started anew.
  bool masterIsLost() const { return lost_; }

  /// The nodes, this one left out, that publish on one of the topics; as the master last said.
  std::vector<std::string> otherPublishers(const std::string& topic) const;

 private:
  using Publishers = std::map<std::string, std::vector<std::string>>;  // nodes by topic

  void run();
  void askOnce();

  std::vector<std::string> topics_;
  std::atomic<bool> running_{true};
  std::atomic<bool> lost_{false};
  int master_pid_ = 0;  // watching thread
  int silent_ = 0;      // watching thread
  mutable std::mutex mutex_;
  Publishers publishers_;  // guarded by mutex_
  std::thread thread_;
};

}  // namespace hexapod
