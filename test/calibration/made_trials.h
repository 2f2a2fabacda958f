#pragma once

#include <memory>
#include <vector>

#include "calibration/play_simulated.h"
#include "self_model/imagination.h"
#include "self_model/walked_body.h"

namespace hexapod {

inline std::shared_ptr<const Imagination> imaginationOf(int threads = 1) {
  return std::make_shared<Imagination>(shippedRobot(), BehaviorOptions(), Engine::kReduced,
                                       threads);
}

/// What a body does, gait after gait.
inline std::vector<Trial> trialsOf(const Physics& body, std::size_t count,
                                   const PoseNoise& noise = {}) {
  std::vector<Trial> plan(count);
  for (std::size_t i = 0; i < count; ++i) {
    plan[i].seen.genome = walkingGaits()[i % walkingGaits().size()];
  }
  Random random(3);
  return playSimulated(*makeWorld(Engine::kReduced, shippedRobot(), body), BehaviorOptions(), plan,
                       noise, random);
}

inline std::vector<SeenBehavior> seenOf(const std::vector<Trial>& trials) {
  std::vector<SeenBehavior> seen;
  for (const Trial& trial : trials) seen.push_back(trial.seen);
  return seen;
}

}  // namespace hexapod
