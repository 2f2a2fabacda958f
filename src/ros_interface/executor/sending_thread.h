#pragma once

#include <thread>

#include "execution/shared_executor.h"
#include "ros_interface/executor/command_sender.h"

namespace hexapod {

/// The thread that publishes what the command loop decided, so that publish(), which allocates,
/// locks and wakes others, is none of the loop's business.
///
/// A command that is not published when the next one comes is left out and counts as skipped.
/// roscpp's own thread writes the sockets: with `realtime` it gets a real-time priority as well.
class SendingThread {
 public:
  /// The references must outlive it.
  SendingThread(SharedExecutor& executor, CommandSender& sender, bool realtime);
  /// Waits for the command under way; none follows.
  ~SendingThread();
  SendingThread(const SendingThread&) = delete;
  SendingThread& operator=(const SendingThread&) = delete;

 private:
  void run();

  SharedExecutor& executor_;
  CommandSender& sender_;
  bool realtime_;
  std::thread thread_;
};

}  // namespace hexapod
