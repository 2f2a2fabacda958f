#pragma once

#include <memory>
#include <vector>

#include "self_model/believed_body.h"
#include "self_model/body.h"
#include "self_model/imagination.h"

namespace hexapod {

/// What standard deviations of the parameters (body.h) a calibration thinks possible beforehand: a
/// robot that nobody has measured, on a floor that is meant to be level.
BodyVector possibleDeviations();

/// Behaviours that a robot played one after another, imagined in bodies that it may have: each from
/// the state in which the one before left that body, at the measured heading. Immutable; may be
/// shared by threads.
class TrialChain {
 public:
  TrialChain(std::shared_ptr<const Imagination> imagination, const Physics& nominal,
             std::vector<SeenBehavior> trials);

  const std::vector<SeenBehavior>& trials() const { return trials_; }

  /// Per body and trial, by how much the robot ended elsewhere than imagined: x, y [m] in the frame
  /// of the behaviour's start, and heading [rad]. Not finite where a body does not stand or blew
  /// up.
  std::vector<std::vector<Eigen::Vector3d>> misses(const std::vector<BodyVector>& bodies) const;

 private:
  std::shared_ptr<const Imagination> imagination_;
  Physics nominal_;
  std::vector<SeenBehavior> trials_;
};

}  // namespace hexapod
