#pragma once

#include <cstddef>
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

/// The entries of a repertoire, their genomes told in so many levels. `source` stands for it in
/// messages. Throws std::invalid_argument when it has none, genomes of another number of legs than
/// the robot's, or some that cannot be told so.
WarmStart warmStart(const RobotDescription& robot, const Repertoire& repertoire,
                    const std::string& source, std::size_t gene_levels);

/// Those of a file. Throws std::runtime_error as loadRepertoire() does, too.
WarmStart warmStart(const RobotDescription& robot, const std::string& file,
                    std::size_t gene_levels);

}  // namespace hexapod
