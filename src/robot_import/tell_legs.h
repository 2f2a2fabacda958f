#pragma once

#include <urdf_model/types.h>

#include <cstddef>
#include <vector>

namespace hexapod {

/// Joints that follow one another, from the base outwards.
using JointChain = std::vector<urdf::JointSharedPtr>;

/// A chain of hinges that starts at the base.
struct Chain {
  JointChain joints;
  std::size_t hinges = 0;  ///< of the file, with those that are not simulated
};

/// Which of a robot's chains are legs. An arm, a head, an antenna is told from them by what sets it
/// apart from the other chains: a single hinge where those have more; a name of its own; a number
/// of hinges that hardly any other has; no other chain as long, where the others have twins.
std::vector<bool> tellLegs(const std::vector<Chain>& chains);

}  // namespace hexapod
