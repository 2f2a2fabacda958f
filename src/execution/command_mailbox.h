#pragma once

#include <semaphore.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "execution/triple_buffer.h"

namespace hexapod {

/// A command on its way from the command loop to the thread that sends it.
struct OutgoingCommand {
  std::int64_t slot = 0;           ///< command period
  std::int64_t stamp_ns = 0;       ///< nominal time of that period, ROS time
  std::uint64_t stops = 0;         ///< stops there had been when it was made
  std::uint64_t silences = 0;      ///< times the executor had fallen silent by then
  bool last_word = false;          ///< sent in spite of a stop: the one that holds the robot
  std::vector<double> angles_rad;  ///< in joint order
};

/// The newest command of one posting thread for one taking thread. Posting neither allocates,
/// locks, waits nor does I/O; it wakes the taker through a semaphore, as a signal handler may.
class CommandMailbox {
 public:
  explicit CommandMailbox(std::size_t joint_count);
  ~CommandMailbox();
  CommandMailbox(const CommandMailbox&) = delete;
  CommandMailbox& operator=(const CommandMailbox&) = delete;

  /// Posting thread: `envelope` is the command without its angles.
  void post(const OutgoingCommand& envelope, const std::vector<double>& angles_rad);

  /// Taking thread: waits until a command was posted; false once close() was called.
  bool wait();

  /// Taking thread: the newest command if it was not taken before, else nullptr; valid until the
  /// next call. `overtaken` is how many were posted since the last one taken and are lost.
  const OutgoingCommand* take(std::uint64_t& overtaken);

  /// Any thread.
  void close();

 private:
  struct Numbered {
    std::uint64_t number = 0;  // of commands posted, from 1
    OutgoingCommand command;
  };

  Numbered draft_;  // posting thread
  TripleBuffer<Numbered> buffer_;
  std::uint64_t taken_ = 0;  // taking thread: number of the last one
  std::atomic<bool> closed_{false};
  sem_t posted_;
};

}  // namespace hexapod
