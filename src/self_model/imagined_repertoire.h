#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "planning/planner_options.h"
#include "repertoire/repertoire.h"
#include "self_model/body.h"
#include "self_model/imagination.h"

namespace hexapod {

/// Those entries of a repertoire that are planned with, played in bodies that the robot may have.
///
/// What a slope does to all of them alike, whatever the robot's heading, is told apart from where
/// they lead. What was played is kept for the last few bodies: one that differs from one of them by
/// no more than what a behaviour teaches of it is answered with what that one did, from the state
/// in which it stood then; but not where a leg is limp. Used by one thread at a time.
class ImaginedRepertoire {
 public:
  /// In one body.
  struct Played {
    Physics body;
    double heading_rad;             ///< in which it stood
    Eigen::Vector2d drift_m;        ///< what every behaviour moves the robot downhill, in the world
    std::vector<Outcome> outcomes;  ///< per entry, without that; stopped at the first failure
  };

  ImaginedRepertoire(std::shared_ptr<const Imagination> imagination, const PlannerOptions& planner);

  /// Turns to a repertoire; of the one that it has, nothing is lost.
  void take(const std::shared_ptr<const Repertoire>& repertoire);

  /// Indices of the entries.
  const std::vector<std::size_t>& entries() const { return entries_; }

  /// What they lead to in a body that stands in a state with a heading. Valid until the next call.
  const Played& in(const Physics& body, const WorldState& state, double heading_rad);

 private:
  Played play(const Physics& body, const WorldState& state, double heading_rad) const;
  Eigen::Vector2d driftOf(const Physics& sloping, const WorldState& state) const;

  std::shared_ptr<const Imagination> imagination_;
  PlannerOptions planner_;
  std::shared_ptr<const Repertoire> repertoire_;
  std::vector<std::size_t> entries_;
  std::vector<Genome> genomes_;
  std::vector<Played> kept_;  // the latest last
};

}  // namespace hexapod
