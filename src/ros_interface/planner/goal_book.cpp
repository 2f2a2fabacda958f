#include "ros_interface/planner/goal_book.h"

#include <utility>

namespace hexapod {

GoalBook::Goal GoalBook::enter(std::string id, const GoalRequest& request,
                               const GoalListener& listener, std::uint64_t stops,
                               std::optional<WalkReport> answer) {
  Goal goal;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::uint64_t number = ++numbers_;
    if (id.empty()) id = "goal_" + std::to_string(number);
    goal = std::make_shared<OpenGoal>(number, std::move(id), request, listener, stops);
    if (closed_) answer = closing_;
    if (!answer) {
      goals_.push_back(goal);
      unexamined_.push_back(goal);
      changed_.notify_all();
      return goal;
    }
  }
  goal->end(*answer);
  return goal;
}

GoalBook::Goal GoalBook::takeToExamine() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return closed_ || !unexamined_.empty(); });
  if (closed_) return nullptr;
  Goal goal = unexamined_.back();
  unexamined_.pop_back();
  return goal;
}

bool GoalBook::accept(const Goal& goal, const WalkReport& report, const WalkGoal& target) {
  std::vector<Goal> outdated;
  const bool accepted = goal->accept(report, target, [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (closed_ || goal->number < newest_accepted_) return false;
    newest_accepted_ = goal->number;
    for (const Goal& other : goals_) {
      if (other->number < goal->number && !other->request.plan_only && other != walked_) {
        outdated.push_back(other);
      }
    }
    if (next_) goals_.remove(next_);
    next_ = goal;
    return true;
  });
  changed_.notify_all();
  for (const Goal& other : outdated) {
    other->end(GoalCode::PREEMPTED, "A newer goal came before this one was begun.");
  }
  if (!accepted && !isClosed()) {
    goal->end(GoalCode::PREEMPTED, "A newer goal was accepted while this one was examined.");
  }
  return accepted;
}

GoalBook::Goal GoalBook::takeToWalk() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return closed_ || next_; });
  if (closed_) return nullptr;
  walked_ = std::exchange(next_, nullptr);
  return walked_;
}

GoalBook::Goal GoalBook::walked() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return walked_;
}

bool GoalBook::newerIsNext() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return next_ && !next_->ended();
}

void GoalBook::strike(const Goal& goal) {
  const std::lock_guard<std::mutex> lock(mutex_);
  goals_.remove(goal);
  if (walked_ == goal) walked_.reset();
}

std::size_t GoalBook::cancelAll() { return cancelWhere(""); }

std::size_t GoalBook::cancel(const std::string& id) { return id.empty() ? 0 : cancelWhere(id); }

std::size_t GoalBook::cancelWhere(const std::string& id) {
  std::vector<Goal> cancelled;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const Goal& goal : goals_) {
      if (id.empty() || goal->id == id) cancelled.push_back(goal);
    }
  }
  std::size_t count = 0;
  for (const Goal& goal : cancelled) count += goal->end(GoalCode::PREEMPTED, "Cancelled.") ? 1 : 0;
  return count;
}

void GoalBook::close(std::uint8_t code, const std::string& message) {
  std::list<Goal> left;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (closed_) return;
    closed_ = true;
    closing_.code = code;
    closing_.message = message;
    left = goals_;
    unexamined_.clear();
    next_.reset();
  }
  changed_.notify_all();
  for (const Goal& goal : left) goal->end(code, message);
}

bool GoalBook::isClosed() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return closed_;
}

std::size_t GoalBook::open() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::size_t count = 0;
  for (const Goal& goal : goals_) count += goal->ended() ? 0 : 1;
  return count;
}

}  // namespace hexapod
