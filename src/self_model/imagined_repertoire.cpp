#include "self_model/imagined_repertoire.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planning/move.h"

namespace hexapod {
namespace {

constexpr std::size_t kKept = 4;
// Bodies that differ by no more are one: scales by a share, slopes by an angle; on a slope the
// heading matters, too.
constexpr double kSameScale = 0.02;
constexpr double kSameSlope_rad = 0.003;
constexpr double kSameHeading_rad = 0.2;
// Slopes that move the robot less than its errors do are none [rad].
constexpr double kFlat_rad = 0.004;
// The drift on a slope is the mean over so many entries and headings.
constexpr std::size_t kDriftEntries = 24;
constexpr int kDriftHeadings = 4;

// A limp leg swings free: how it lies decides of what comes of a behaviour.
bool hasLimpLeg(const Physics& body) {
  return std::any_of(body.legs.begin(), body.legs.end(),
                     [](const LegState& leg) { return leg.condition == LegCondition::kLimp; });
}

bool isSame(const Physics& a, const Physics& b) {
  if (a.legs != b.legs || hasLimpLeg(a)) return false;
  const BodyVector difference = parametersOf(a, b);
  for (const BodyParameter scale : {kFriction, kServoGain, kTorque, kMass}) {
    if (std::abs(difference[scale]) > kSameScale) return false;
  }
  return std::abs(a.slope_x_rad - b.slope_x_rad) <= kSameSlope_rad &&
         std::abs(a.slope_y_rad - b.slope_y_rad) <= kSameSlope_rad;
}

bool isFlat(const Physics& body) {
  return std::hypot(body.slope_x_rad, body.slope_y_rad) < kFlat_rad;
}

Physics levelled(Physics body) {
  body.slope_x_rad = body.slope_y_rad = 0.0;
  return body;
}

}  // namespace

ImaginedRepertoire::ImaginedRepertoire(std::shared_ptr<const Imagination> imagination,
                                       const PlannerOptions& planner)
    : imagination_(std::move(imagination)), planner_(planner) {}

void ImaginedRepertoire::take(const std::shared_ptr<const Repertoire>& repertoire) {
  if (repertoire == repertoire_) return;
  repertoire_ = repertoire;
  entries_.clear();
  genomes_.clear();
  kept_.clear();
  for (const Move& move : usableMoves(*repertoire, planner_, {})) {
    entries_.push_back(move.entry);
    genomes_.push_back(repertoire->entries[move.entry].genome);
  }
}

const ImaginedRepertoire::Played& ImaginedRepertoire::in(const Physics& body,
                                                         const WorldState& state,
                                                         double heading_rad) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Played& played) {
    return isSame(played.body, body) &&
           (isFlat(body) ||
            std::abs(wrapAngle(played.heading_rad - heading_rad)) <= kSameHeading_rad);
  });
  if (found != kept_.end()) {
    std::rotate(found, found + 1, kept_.end());
  } else {
    Played played = play(body, state, heading_rad);
    if (kept_.size() == kKept) kept_.erase(kept_.begin());
    kept_.push_back(std::move(played));
  }
  return kept_.back();
}

ImaginedRepertoire::Played ImaginedRepertoire::play(const Physics& body, const WorldState& state,
                                                    double heading_rad) const {
  const auto other_heading = std::find_if(
      kept_.begin(), kept_.end(), [&](const Played& played) { return isSame(played.body, body); });
  Played played{body, heading_rad,
                other_heading != kept_.end() ? other_heading->drift_m : driftOf(body, state),
                imagination_->playAll(genomes_, {body, &state})};
  const Pose2 heading{0.0, 0.0, heading_rad};
  const Pose2 drift = inverse(heading) * Pose2{played.drift_m.x(), played.drift_m.y(), heading_rad};
  for (Outcome& outcome : played.outcomes) {
    outcome.end_pose.x_m -= drift.x_m;
    outcome.end_pose.y_m -= drift.y_m;
  }
  return played;
}

Eigen::Vector2d ImaginedRepertoire::driftOf(const Physics& sloping, const WorldState& state) const {
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  if (isFlat(sloping)) return sum_m;
  std::vector<Genome> genomes;
  const std::size_t every = std::max<std::size_t>(1, genomes_.size() / kDriftEntries);
  for (std::size_t i = 0; i < genomes_.size(); i += every) genomes.push_back(genomes_[i]);
  double count = 0.0;
  for (int i = 0; i < kDriftHeadings; ++i) {
    const double heading_rad = 2.0 * M_PI * i / kDriftHeadings;
    const WorldState start = imagination_->turned(state, heading_rad);
    const std::vector<Outcome> there = imagination_->playAll(genomes, {levelled(sloping), &start});
    const std::vector<Outcome> here = imagination_->playAll(genomes, {sloping, &start});
    const Pose2 heading{0.0, 0.0, heading_rad};
    for (std::size_t k = 0; k < genomes.size(); ++k) {
      if (!here[k].walked() || !there[k].walked()) continue;
      const Pose2 drifted = heading * here[k].end_pose, level = heading * there[k].end_pose;
      sum_m += Eigen::Vector2d(drifted.x_m - level.x_m, drifted.y_m - level.y_m);
      count += 1.0;
    }
  }
  return count > 0.0 ? Eigen::Vector2d(sum_m / count) : sum_m;
}

}  // namespace hexapod
