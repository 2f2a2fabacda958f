#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>

#include "learning/channel.h"

namespace hexapod {

/// A channel between two threads of one process. A message `kSilence` on it stands for an other
/// side that answers no more.
class QueueChannel : public Channel {
 public:
  static constexpr const char* kSilence = "silence";

  /// Both ends.
  static std::pair<std::shared_ptr<QueueChannel>, std::shared_ptr<QueueChannel>> makePair() {
    auto there = std::make_shared<Queue>();
    auto back = std::make_shared<Queue>();
    return {std::make_shared<QueueChannel>(there, back),
            std::make_shared<QueueChannel>(back, there)};
  }

  void send(const std::string& message) override {
    const std::lock_guard<std::mutex> lock(out_->mutex);
    out_->messages.push_back(message);
    out_->arrived.notify_one();
  }

  std::optional<std::string> receive(const std::atomic<bool>&, double) override {
    std::unique_lock<std::mutex> lock(in_->mutex);
    in_->arrived.wait(lock, [this] { return !in_->messages.empty(); });
    const std::string message = in_->messages.front();
    in_->messages.pop_front();
    return message == kSilence ? std::nullopt : std::optional<std::string>(message);
  }

 private:
  struct Queue {
    std::mutex mutex;
    std::condition_variable arrived;
    std::deque<std::string> messages;
  };

 public:
  QueueChannel(std::shared_ptr<Queue> out, std::shared_ptr<Queue> in)
      : out_(std::move(out)), in_(std::move(in)) {}

 private:
  std::shared_ptr<Queue> out_;
  std::shared_ptr<Queue> in_;
};

}  // namespace hexapod
