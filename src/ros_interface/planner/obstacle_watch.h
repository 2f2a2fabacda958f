#pragma once

#include <memory>
#include <utility>

#include "planning/planner.h"
#include "ros_interface/planner/walk_goal.h"

namespace hexapod {

/// The obstacles that the behaviour under way was judged by, and whether newer ones are in its way.
/// Used by one thread.
class ObstacleWatch {
 public:
  /// The source may be empty: then there are never any.
  explicit ObstacleWatch(ObstacleSource source) : source_(std::move(source)) {}

  /// Those of now, by which is judged from now on; null: everything is free.
  const std::shared_ptr<const Obstacles>& look();

  /// Those of the last look.
  const std::shared_ptr<const Obstacles>& seen() const { return seen_; }

  /// Whether others are known by now than at the last look.
  bool isOutdated() const { return source_ && source_() != seen_; }

  /// Whether a behaviour that began at that pose would touch what was not known at the last look.
  /// Where the robot stood within its margin before, it does not touch by being there.
  bool touchesNews(const Planner& planner, const Pose2& world_from_start, std::size_t entry);

 private:
  ObstacleSource source_;
  std::shared_ptr<const Obstacles> seen_;
};

}  // namespace hexapod
