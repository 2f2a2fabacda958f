#include "ros_interface/planner/walker.h"

#include <ros/console.h>

#include <exception>

#include "ros_interface/common/realtime.h"
#include "ros_interface/planner/twist_walk.h"

namespace hexapod {
namespace {

// One goal may take its planning time; a newer one need not wait for it.
constexpr int kExaminers = 2;

WalkReport internalError(const std::exception& error) {
  WalkReport report;
  report.code = GoalCode::INTERNAL_ERROR;
  report.message = std::string("Internal error of the planner: ") + error.what();
  return report;
}

void log(const std::string& id, const WalkReport& report) {
  if (report.success()) {
    ROS_INFO_STREAM(id << ": " << report.message);
  } else {
    ROS_WARN_STREAM(id << ": " << report.message);
  }
}

}  // namespace

Walker::Walker(const Means& means)
    : means_(means),
      examiner_({means.options, means.clock, means.poses, means.repertoire, means.player,
                 means.obstacles, means.obstacle_problem}) {
  for (int i = 0; i < kExaminers; ++i) threads_.emplace_back(&Walker::examineGoals, this);
  threads_.emplace_back(&Walker::walkToGoals, this);
}

Walker::~Walker() {
  close(GoalCode::SHUTDOWN, "The planner is shutting down.");
  for (std::thread& thread : threads_) thread.join();
}

std::string Walker::submit(const GoalRequest& request, const GoalListener& listener,
                           const std::string& id) {
  const auto is_cancelled = [&] {
    return cancels_.covers(request.sent, means_.clock.steadyNow_ns());
  };
  const auto answer = is_cancelled() ? std::optional(cancelledEarly()) : std::nullopt;
  const GoalBook::Goal goal = book_.enter(id, request, listener, means_.player.stops(), answer);
  // A cancel that came since then has not found it in the book.
  if (is_cancelled()) goal->end(cancelledEarly());
  return goal->id;
}

bool Walker::cancelAll() {
  if (!means_.clock.isSimulated()) {
    cancels_.cancelAll(means_.clock.rosNow(), means_.clock.steadyNow_ns());
  }
  return book_.cancelAll() > 0;
}

void Walker::look() {
  const std::string why = means_.player.whyNotReady();  // always: who is not listened to is silent
  const GoalBook::Goal goal = book_.walked();
  if (why.empty() || !goal || !goal->is_thought_about) return;
  if (goal->end(GoalCode::EXECUTOR_NOT_READY, "The walk ended, no behaviour is played: " + why)) {
    log(goal->id, goal->report());
  }
}

void Walker::examineGoals() {
  beLessUrgent(Niceness::kThinking);
  while (const GoalBook::Goal goal = book_.takeToExamine()) {
    if (!goal->ended()) {
      try {
        examine(goal);
      } catch (const std::exception& error) {
        goal->end(internalError(error));
      }
    }
    // An accepted one is struck when it was walked to.
    if (goal->ended()) book_.strike(goal);
  }
}

void Walker::examine(const GoalBook::Goal& goal) {
  const auto examination = examiner_.examine(goal->request, [&] { return goal->ended(); });
  if (!examination.report.success()) {
    if (!goal->end(examination.report)) return;
    log(goal->id, examination.report);
    if (examination.is_goal_known) showIfRefused(examination.goal, examination.report);
    return;
  }
  if (!goal->request.plan_only) {
    book_.accept(goal, examination.report, examination.goal);
    return;
  }
  means_.watcher.showPlan(examination.start, examination.plan, {}, examination.goal.pose,
                          examination.goal.tolerance.xy_m);
  goal->accept(examination.report, examination.goal, [] { return true; });
  goal->end(examination.report);
}

void Walker::walkToGoals() {
  while (const GoalBook::Goal goal = book_.takeToWalk()) {
    if (!goal->ended()) {
      try {
        const WalkReport report = walkTo(*goal);
        goal->end(report);
        // What the walk told by itself, now or before it was over; not a cancel.
        if (goal->report().code == report.code) log(goal->id, report);
        means_.watcher.reportWalk(goal->id, goal->report());
        if (!goal->request.twist) showIfRefused(goal->goal(), goal->report());
      } catch (const std::exception& error) {
        goal->end(internalError(error));
      }
    }
    book_.strike(goal);
  }
}

// Not what somebody called off.
void Walker::showIfRefused(const WalkGoal& goal, const WalkReport& report) {
  if (report.success() || report.code == GoalCode::PREEMPTED || report.code == GoalCode::SHUTDOWN) {
    return;
  }
  means_.watcher.showRefused(goal.pose, goal.tolerance.xy_m, report);
}

WalkReport Walker::walkTo(OpenGoal& goal) {
  const WalkMeans means{means_.options,  means_.clock,   means_.poses,
                        means_.player,   means_.watcher, [this] { return book_.newerIsNext(); },
                        means_.obstacles};
  if (goal.request.twist) return TwistWalk(means, goal, means_.repertoire.planner()).run();
  // One repertoire for the whole walk; the goal was examined with it or an earlier one.
  return WalkRun(means, goal, means_.repertoire.planner()).run();
}

}  // namespace hexapod
