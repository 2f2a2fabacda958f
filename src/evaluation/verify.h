#pragma once

#include <memory>
#include <vector>

#include "evaluation/robust_worlds.h"
#include "gait/genome.h"
#include "gait/outcome.h"
#include "geometry/pose2.h"
#include "robot/robot_description.h"
#include "simulation/world.h"
#include "simulation/world_pool.h"

namespace hexapod {

/// How far an entry may end from where ODE ends it. Ten steps of the rounding of outcomes; the
/// engines differ by a hundredth of it at most where both solve the same equations, and what a
/// planner can make use of is a hundred times as much.
constexpr double kVerifiedWithin_m = 1e-4;
constexpr double kVerifiedWithin_rad = 1e-3;

/// How a behaviour ended from the settled stand, not rounded as an Outcome is.
struct End {
  Verdict verdict = Verdict::kDiverged;
  Pose2 pose;
};

/// Whether both came to the same verdict and, if they walked, to poses within kVerifiedWithin_m and
/// kVerifiedWithin_rad.
bool agree(const End& a, const End& b);

/// Plays every genome from the settled stand of the pool's worlds. Same result whatever the number
/// of threads. Throws as RobustWorlds does.
std::vector<End> playFromTheStand(const std::shared_ptr<WorldPool>& worlds,
                                  const BehaviorOptions& behavior,
                                  const std::vector<Genome>& genomes, const PlayHooks& hooks = {});

/// What ODE says to genomes that another engine has simulated.
struct Verification {
  std::vector<bool> holds;  ///< per genome
  /// The largest differences among those that hold and walk.
  double largest_difference_m = 0.0;
  double largest_difference_rad = 0.0;
};

/// Plays every genome in the pool's engine and in ODE, under the pool's physics and with as many
/// threads. A genome holds when both engines agree(). The hooks are told of ODE's runs.
Verification verifyInOde(const std::shared_ptr<WorldPool>& worlds, const BehaviorOptions& behavior,
                         const std::vector<Genome>& genomes, const PlayHooks& hooks = {});

}  // namespace hexapod
