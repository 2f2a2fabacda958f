#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "repertoire/repertoire.h"
#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// How long and with how much a repertoire is relearned.
struct RelearnOptions {
  std::int64_t evaluations = 30000;  ///< the entries there are included
  std::int64_t threads = 0;          ///< 0: all cores
};

/// Evolution that goes on from what a repertoire is to a robot with another body: its entries are
/// evaluated anew in `body`, those that still walk are the first of the new archive, and the
/// options are the repertoire's own. Each entry is validated in that body; ODE and other worlds are
/// not asked. Deterministic, whatever the number of threads.
///
/// Returns a run of its own, or nothing when it was cancelled, which takes no longer than a
/// behaviour. Throws std::invalid_argument for a repertoire of another kind of robot, or one whose
/// options are out of range.
std::optional<Repertoire> relearn(const RobotDescription& robot, const Repertoire& repertoire,
                                  const Physics& body, const RelearnOptions& options,
                                  const std::atomic<bool>& cancelled);

}  // namespace hexapod
