#pragma once

#include <memory>
#include <optional>

#include "planning/way_field.h"

namespace hexapod {

/// The ways to a goal, or that there is none.
struct WaySearch {
  std::shared_ptr<const WayField> ways;   ///< to order a search by
  std::shared_ptr<const WayField> bound;  ///< with kPossibly; may be the same
  bool blocked = false;                   ///< proved: no path leads from the start to the goal
  bool cut_short = false;                 ///< stopped before there were any
};

/// First near start and goal and where there is surely room; then everywhere.
WaySearch findWays(const WayField::Question& question);

/// The free pose nearest to the goal, with its heading, to which there surely is a way from the
/// start; nothing when the start itself has no room, or when it was stopped.
std::optional<Pose2> nearestFreePose(const WayField::Question& question);

}  // namespace hexapod
