#pragma once

#include <vector>

#include "planning/route.h"

namespace hexapod {

/// Parts of a waypoint's tolerance to arrive in, with a view to what comes after, from where the
/// robot leaves in `onward_rad`: headings, of which the tolerance leaves a choice, and the side
/// that lies nearer to the next waypoint. The whole of it is not among them.
std::vector<Waypoint> arrivalsAt(const Waypoint& waypoint, double onward_rad);

}  // namespace hexapod
