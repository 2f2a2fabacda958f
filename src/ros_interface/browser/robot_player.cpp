#include "ros_interface/browser/robot_player.h"

#include <utility>

namespace hexapod {

RobotPlayer::RobotPlayer(BehaviorPlayer& executor, const PoseSource& poses,
                         const ros::Duration& settle, Tell tell)
    : executor_(executor),
      poses_(poses),
      settle_(settle),
      tell_(std::move(tell)),
      thread_(&RobotPlayer::work, this) {}

RobotPlayer::~RobotPlayer() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    leaves_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::string RobotPlayer::play(const std::string& run_id, const Entry& entry) {
  if (!entry.usable()) return "It failed in its validation and is not played.";
  const std::uint64_t stops = executor_.stops();
  const std::string problem = executor_.whyNotReady();
  if (!problem.empty()) return problem;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (order_) return "Entry " + std::to_string(order_->entry.id) + " is still being played.";
    order_ = Order{run_id, entry, stops};
  }
  changed_.notify_all();
  return "";
}

bool RobotPlayer::isPlaying() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return order_.has_value();
}

bool RobotPlayer::leaves() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return leaves_;
}

void RobotPlayer::work() {
  for (;;) {
    std::optional<Order> order;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return order_ || leaves_; });
      if (leaves_) return;
      order = order_;
    }
    play(*order);
    const std::lock_guard<std::mutex> lock(mutex_);
    order_.reset();
  }
}

void RobotPlayer::play(const Order& order) {
  const PoseSource::Stop stop = [this] { return leaves(); };
  const auto tell = [&](const MeasuredBehavior& measured) { tell_({measured, order.entry}); };
  tell(playMeasured({executor_, poses_, settle_}, {order.entry, order.run_id, order.stops, stop},
                    tell));
}

}  // namespace hexapod
