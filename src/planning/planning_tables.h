#pragma once

#include <vector>

#include "planning/move.h"
#include "planning/pose_table.h"
#include "planning/steps_bound.h"
#include "planning/steps_to_go.h"

namespace hexapod {

/// What is computed once per repertoire. Immutable.
struct PlanningTables {
  PlanningTables(const Repertoire& repertoire, const PlannerOptions& options,
                 const EntryPaths& paths);

  std::vector<Move> moves;
  /// Indices of few moves that stand for all: evenly spread ones, and those that reach farthest.
  std::vector<std::size_t> representatives;
  PoseTable singles;  ///< all moves
  PoseTable pairs;    ///< all pairs of moves
  StepsToGo steps_to_go;
  StepsBound steps_bound;
};

}  // namespace hexapod
