#include "self_model/refinement.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <utility>

#include "self_model/belief_prior.h"

namespace hexapod {

Refinement::Refinement(std::shared_ptr<const Imagination> imagination, const Physics& nominal,
                       const Evidence& evidence)
    : imagination_(std::move(imagination)), nominal_(nominal), evidence_(evidence) {}

void Refinement::refine(const SeenBehavior& seen, double share, BelievedBody& body) const {
  if (body.imagined.verdict == Verdict::kDiverged) return;
  const std::optional<Slope> slope = slopeAt(seen, body);
  if (!slope) return;
  // What is not linear is noise to a linear update: a square of a normal variable has variance 2.
  body.scatter =
      slope->change * slope->change.transpose() + 2.0 * slope->bend * slope->bend.transpose();
  evidence_.judge(seen, body);
  if (body.misfit > kAccident) {
    body.covariance = 0.5 * (body.covariance + priorCovariance(share));
    return;
  }
  step(seen, *slope, body);
}

std::vector<Imagined> Refinement::imagineAt(const SeenBehavior& seen, const BelievedBody& body,
                                            const std::vector<BodyVector>& means,
                                            Imagination::Joints joints) const {
  std::vector<Imagination::Question> questions;
  for (const BodyVector& mean : means) {
    questions.push_back({physicsOf(nominal_, body.legs, mean), &body.state});
  }
  return imagination_->play(seen.genome, questions, joints);
}

std::optional<Refinement::Slope> Refinement::slopeAt(const SeenBehavior& seen,
                                                     const BelievedBody& body) const {
  Slope slope;
  slope.root = Eigen::LLT<BodyMatrix>(body.covariance).matrixL();
  std::vector<BodyVector> means;
  for (int j = 0; j < kBodyParameters; ++j) {
    means.push_back(body.mean + slope.root.col(j));
    means.push_back(body.mean - slope.root.col(j));
  }
  const std::vector<Imagined> around = imagineAt(seen, body, means, Imagination::Joints::kIgnored);
  const Pose2& middle = body.imagined.start_from_end;
  for (int j = 0; j < kBodyParameters; ++j) {
    const std::size_t side = 2 * static_cast<std::size_t>(j);
    const Imagined &up = around[side], &down = around[side + 1];
    if (up.verdict == Verdict::kDiverged || down.verdict == Verdict::kDiverged) return std::nullopt;
    slope.change.col(j) = 0.5 * difference(up.start_from_end, down.start_from_end);
    slope.bend.col(j) =
        0.5 * (difference(up.start_from_end, middle) + difference(down.start_from_end, middle));
  }
  return slope;
}

void Refinement::step(const SeenBehavior& seen, const Slope& slope, BelievedBody& body) const {
  const Pose2 measured = seen.startFromEnd();
  const Eigen::Matrix3d inverse_covariance = (body.scatter + evidence_.noise()).inverse();
  const BodyVector whole =
      slope.change.transpose() *
      (inverse_covariance * difference(measured, body.imagined.start_from_end));
  const std::vector<BodyVector> steps = {whole, 0.5 * whole};
  const std::vector<Imagined> ahead =
      imagineAt(seen, body, {body.mean + slope.root * steps[0], body.mean + slope.root * steps[1]},
                seen.jointsMatter());
  // What explains more and is less far from what was known.
  const Eigen::Matrix3d weight =
      (evidence_.noise() + 2.0 * slope.bend * slope.bend.transpose()).inverse();
  const auto cost = [&](const Imagined& imagined, const BodyVector& moved) {
    const Eigen::Vector3d left = difference(measured, imagined.start_from_end);
    return left.dot(weight * left) + moved.squaredNorm();
  };
  double least = cost(body.imagined, BodyVector::Zero());
  BodyVector taken = BodyVector::Zero();
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (ahead[k].verdict == Verdict::kDiverged || cost(ahead[k], steps[k]) >= least) continue;
    least = cost(ahead[k], steps[k]);
    taken = steps[k];
    body.imagined = ahead[k];
  }
  body.mean += slope.root * taken;
  const BodyMatrix kept =
      BodyMatrix::Identity() - slope.change.transpose() * inverse_covariance * slope.change;
  body.covariance = slope.root * kept * slope.root.transpose();
}

}  // namespace hexapod
