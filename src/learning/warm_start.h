#pragma once

#include <string>
#include <vector>

#include "gait/genome.h"
#include "repertoire/repertoire.h"
#include "robot/robot_description.h"

namespace hexapod {

/// What a run begins with instead of random candidates.
struct WarmStart {
  std::string name;  ///< the run they come from, their number and their digest
  std::vector<Genome> genomes;
};

/// The entries of a repertoire. `source` stands for it in messages. Throws std::invalid_argument
/// when it has none, or genomes of another number of legs than the robot's.
WarmStart warmStart(const RobotDescription& robot, const Repertoire& repertoire,
                    const std::string& source);

/// Those of a file. Throws std::runtime_error as loadRepertoire() does, too.
WarmStart warmStart(const RobotDescription& robot, const std::string& file);

}  // namespace hexapod
