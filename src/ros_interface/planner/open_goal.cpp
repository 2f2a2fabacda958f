#include "ros_interface/planner/open_goal.h"

#include <utility>

namespace hexapod {

OpenGoal::OpenGoal(std::uint64_t number, std::string id, GoalRequest request, GoalListener listener,
                   std::uint64_t stops)
    : number(number),
      id(std::move(id)),
      request(std::move(request)),
      stops(stops),
      listener_(std::move(listener)) {}

bool OpenGoal::accept(const WalkReport& report, const WalkGoal& goal,
                      const std::function<bool()>& may_begin) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ended_) return false;
  goal_ = goal;
  so_far_ = report;
  if (!may_begin()) return false;
  if (listener_.accepted) listener_.accepted(report);
  return true;
}

void OpenGoal::note(const WalkReport& so_far) {
  const std::lock_guard<std::mutex> lock(mutex_);
  WalkReport report = so_far;
  if (ended_) {  // how it ended is not for who walks to say any more
    report.code = so_far_.code;
    report.message = so_far_.message;
  }
  so_far_ = std::move(report);
}

void OpenGoal::tellProgress(const WalkProgress& progress) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!ended_ && listener_.progress) listener_.progress(progress);
}

bool OpenGoal::end(const WalkReport& report) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ended_) return false;
  ended_ = true;
  so_far_ = report;
  if (listener_.ended) listener_.ended(report);
  return true;
}

WalkReport OpenGoal::report() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return so_far_;
}

bool OpenGoal::end(std::uint8_t code, const std::string& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ended_) return false;
  ended_ = true;
  so_far_.code = code;
  so_far_.message = message;
  if (listener_.ended) listener_.ended(so_far_);
  return true;
}

}  // namespace hexapod
