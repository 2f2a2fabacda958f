#include "ros_interface/executor/sending_thread.h"

#include "ros_interface/common/clock.h"
#include "ros_interface/common/realtime.h"

namespace hexapod {
SendingThread::SendingThread(SharedExecutor& executor, CommandSender& sender, bool realtime)
    : executor_(executor), sender_(sender), realtime_(realtime), thread_([this] { run(); }) {}

SendingThread::~SendingThread() {
  executor_.stopSending();
  thread_.join();
}

void SendingThread::run() {
  if (realtime_) {
    askForRealtimePriority(RealtimePriority::kSending);
    raiseTransportPriority();
  }
  const SharedExecutor::Send send = [this](const OutgoingCommand& command) {
    sender_.send(timeFromNs(command.stamp_ns), command.angles_rad);
  };
  while (executor_.sendNext(send)) {
  }
}

}  // namespace hexapod
