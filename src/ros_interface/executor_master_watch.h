#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hexapod {

/// Asks the master now and then, in a thread of its own: is it still the same, and does anybody
/// else publish on the command topics?
class ExecutorMasterWatch {
 public:
  /// `topics`: resolved names.
  explicit ExecutorMasterWatch(std::vector<std::string> topics);
  /// Waits for the question under way, some milliseconds unless the master hangs.
  ~ExecutorMasterWatch();

  /// True once the master has been silent for several questions, or is another process than at the
  /// start: this node is then registered nowhere.
  bool masterIsLost() const { return lost_; }

  /// Other publishers of the command topics: "node on topic, ..", empty when there is none.
  std::string foreignPublishers() const;

 private:
  void run();
  void askOnce();

  std::vector<std::string> topics_;
  std::atomic<bool> running_{true};
  std::atomic<bool> lost_{false};
  int master_pid_ = 0;  // watching thread
  int silent_ = 0;      // watching thread
  mutable std::mutex mutex_;
  std::string foreign_;  // guarded by mutex_
  std::thread thread_;
};

}  // namespace hexapod
