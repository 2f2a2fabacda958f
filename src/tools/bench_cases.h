#pragma once

#include <string>
#include <vector>

#include "common/random.h"
#include "gait/genome.h"
#include "gait/outcome.h"
#include "repertoire/entry.h"
#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// A robot and a step to measure.
struct BenchCase {
  std::string name;  ///< "2013, 15 ms"
  RobotDescription robot;
  Physics physics;
};

/// The shipped robot, which is that of 2013, and the lighter one with the short tibia of 2015, both
/// at 15 and 5 ms; the shipped one at 15 ms first. The robot must be the shipped one.
std::vector<BenchCase> benchCases(const RobotDescription& shipped);

/// The robot of 2015: body 1.031 kg, femur 0.184 kg, tibia 0.095 m and 0.040 kg. Inertias follow
/// masses and lengths as those of bodies of the same proportions.
RobotDescription laterRobot(RobotDescription robot);

/// Genomes drawn uniformly, in canonical form.
std::vector<Genome> randomGenomes(std::size_t count, std::size_t gene_count, std::uint64_t seed);

/// An outcome that ends anywhere on a disc of 0.9 m, with any heading.
Outcome anywhere(Random& random);

/// So many entries that end anywhere on that disc, as well aligned as in a repertoire that has been
/// worked on for long.
std::vector<Entry> spreadArchive(std::size_t size, std::size_t gene_count);

}  // namespace hexapod
