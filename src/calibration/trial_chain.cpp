#include "calibration/trial_chain.h"

#include <limits>
#include <utility>

#include "self_model/evidence.h"

namespace hexapod {

BodyVector possibleDeviations() {
  BodyVector deviations;
  deviations << 0.25, 0.25, 0.25, 0.2, 0.01, 0.01;
  return deviations;
}

TrialChain::TrialChain(std::shared_ptr<const Imagination> imagination, const Physics& nominal,
                       std::vector<SeenBehavior> trials)
    : imagination_(std::move(imagination)), nominal_(nominal), trials_(std::move(trials)) {}

std::vector<std::vector<Eigen::Vector3d>> TrialChain::misses(
    const std::vector<BodyVector>& bodies) const {
  const Eigen::Vector3d unknown =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<Physics> physics;
  for (const BodyVector& body : bodies) physics.push_back(physicsOf(nominal_, nominal_.legs, body));
  const std::vector<std::optional<WorldState>> stands = imagination_->stands(physics);
  std::vector<std::vector<Eigen::Vector3d>> misses(
      bodies.size(), std::vector<Eigen::Vector3d>(trials_.size(), unknown));
  std::vector<std::size_t> standing;
  std::vector<WorldState> states;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!stands[b]) continue;
    standing.push_back(b);
    states.push_back(*stands[b]);
  }
  for (std::size_t t = 0; t < trials_.size(); ++t) {
    std::vector<Imagination::Question> questions;
    for (std::size_t k = 0; k < standing.size(); ++k) {
      states[k] = imagination_->turned(states[k], trials_[t].world_from_before.yaw_rad);
      questions.push_back({physics[standing[k]], &states[k]});
    }
    const std::vector<Imagined> imagined =
        imagination_->play(trials_[t].genome, questions, Imagination::Joints::kIgnored);
    for (std::size_t k = 0; k < standing.size(); ++k) {
      const std::size_t b = standing[k];
      const bool walked = imagined[k].verdict == Verdict::kWalked;
      if (imagined[k].verdict != Verdict::kDiverged) {
        misses[b][t] = difference(trials_[t].startFromEnd(), imagined[k].start_from_end);
      }
      // The robot stands there; so does the next behaviour's body.
      states[k] = walked ? imagined[k].end : *stands[b];
    }
  }
  return misses;
}

}  // namespace hexapod
