#include "execution/command_mailbox.h"

#include <cerrno>

namespace hexapod {

CommandMailbox::CommandMailbox(std::size_t joint_count)
    : draft_{0, {0, 0, 0, 0, false, std::vector<double>(joint_count, 0.0)}}, buffer_(draft_) {
  sem_init(&posted_, 0, 0);
}

CommandMailbox::~CommandMailbox() { sem_destroy(&posted_); }

void CommandMailbox::post(const OutgoingCommand& envelope, const std::vector<double>& angles_rad) {
  ++draft_.number;
  draft_.command.slot = envelope.slot;
  draft_.command.stamp_ns = envelope.stamp_ns;
  draft_.command.stops = envelope.stops;
  draft_.command.silences = envelope.silences;
  draft_.command.last_word = envelope.last_word;
  draft_.command.angles_rad = angles_rad;
  buffer_.write(draft_);
  sem_post(&posted_);
}

bool CommandMailbox::wait() {
  while (!closed_ && sem_wait(&posted_) != 0 && errno == EINTR) {
  }
  return !closed_;
}

const OutgoingCommand* CommandMailbox::take(std::uint64_t& overtaken) {
  overtaken = 0;
  if (!buffer_.update()) return nullptr;
  overtaken = buffer_.value().number - taken_ - 1;
  taken_ = buffer_.value().number;
  return &buffer_.value().command;
}

void CommandMailbox::close() {
  closed_ = true;
  sem_post(&posted_);
}

}  // namespace hexapod
