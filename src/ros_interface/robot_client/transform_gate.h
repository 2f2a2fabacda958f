#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <cstdint>
#include <string>
#include <unordered_map>

namespace hexapod {

/// Which of the transforms that arrive are given to tf2. It leaves out itself what is not finite or
/// no rotation; but a stamp at the end of its range ends the process, a frame that was made static
/// never moves again, one that two nodes move jumps between them, and no frame is ever forgotten.
///
/// Let through are stamps and names of sensible size, the first kMostFrames frames, and of each
/// frame what the node sends that moves it, until that has been silent for kPatience_ns. Used by
/// one thread.
class TransformGate {
 public:
  static constexpr std::size_t kMostFrames = 1000;
  static constexpr std::size_t kLongestName = 250;
  static constexpr std::int64_t kPatience_ns = 2'000'000'000;

  struct Source {
    std::string node;
    bool is_static = false;
    std::int64_t arrival_ns = 0;  ///< steady time
  };

  /// A sentence why it is left out; empty: let through, and noted.
  std::string whyRefused(const geometry_msgs::TransformStamped& transform, const Source& source);

 private:
  std::unordered_map<std::string, Source> movers_;  // by child frame
};

}  // namespace hexapod
