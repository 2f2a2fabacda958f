#include "self_model/self_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "self_model/caution.h"

namespace hexapod {
namespace {

// Bodies less likely than this do not matter to what is expected.
constexpr double kUnlikely = 0.1;
// A body less likely is not worth following chains in.
constexpr double kLikelyEnough = 0.5;
// How far an expected end pose is off before anything was walked, worth kPriorCount behaviours.
constexpr double kPriorError_m = 0.005;
constexpr double kPriorError_rad = 0.012;
constexpr double kPriorCount = 4.0;
constexpr double kFadingOfMisses = 0.9;
// A planner shall trust these spreads as they are.
constexpr int kTrials = 50;

SeenBehavior seenBy(const WalkedStep& step) {
  return {step.entry.genome, step.world_from_before, step.world_from_after, step.joints};
}

// A weighted mean of poses, and how far they are apart.
class Mixture {
 public:
  void add(const Pose2& pose, double weight) {
    poses_.push_back(pose);
    weights_.push_back(weight);
  }

  Execution execution(double square_m2, double square_rad2) const {
    Execution execution;
    double sum = 0.0, x = 0.0, y = 0.0, c = 0.0, s = 0.0;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      sum += weights_[i];
      x += weights_[i] * poses_[i].x_m;
      y += weights_[i] * poses_[i].y_m;
      c += weights_[i] * std::cos(poses_[i].yaw_rad);
      s += weights_[i] * std::sin(poses_[i].yaw_rad);
    }
    execution.mean = {x / sum, y / sum, std::atan2(s, c)};
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const double share = weights_[i] / sum;
      square_m2 += share * std::pow(distance(poses_[i], execution.mean), 2);
      square_rad2 += share * std::pow(headingDistance(poses_[i], execution.mean), 2);
    }
    execution.spread_m = std::sqrt(square_m2);
    execution.spread_rad = std::sqrt(square_rad2);
    execution.trials = kTrials;
    return execution;
  }

 private:
  std::vector<Pose2> poses_;
  std::vector<double> weights_;
};

}  // namespace

SelfModel::SelfModel(const RobotDescription& robot, const LearnedWorld& learned,
                     const SelfModelOptions& options, const std::optional<Physics>& told)
    : imagination_(std::make_shared<Imagination>(
          robot, learned.behavior, chooseEngine(options.engine, robot).engine, options.threads)),
      planner_(options.planner),
      imagined_(imagination_, options.planner),
      belief_(told ? BodyBelief(imagination_, *told)
                   : BodyBelief(imagination_, learned.physics, options.belief)),
      first_belief_(belief_),
      square_m2_(kPriorCount * kPriorError_m * kPriorError_m),
      square_rad2_(kPriorCount * kPriorError_rad * kPriorError_rad),
      count_(kPriorCount) {}

SelfModel::SelfModel(const SelfModel& other)
    : SelfModel(other, std::lock_guard<std::mutex>(other.mutex_)) {}

SelfModel::SelfModel(const SelfModel& other, const std::lock_guard<std::mutex>&)
    : imagination_(other.imagination_),
      planner_(other.planner_),
      imagined_(other.imagined_),
      belief_(other.belief_),
      first_belief_(other.first_belief_),
      heading_rad_(other.heading_rad_),
      behaviors_(other.behaviors_),
      revision_(other.revision_),
      expected_(other.expected_),
      caution_(other.caution_),
      drift_m_(other.drift_m_),
      residual_(other.residual_),
      residual_legs_(other.residual_legs_),
      square_m2_(other.square_m2_),
      square_rad2_(other.square_rad2_),
      count_(other.count_) {}

BodyBelief SelfModel::belief() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return belief_;
}

int SelfModel::behaviors() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return behaviors_;
}

// The robot stands where it stands, in a state of which nothing is known.
void SelfModel::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  belief_ = first_belief_;
  drift_m_.setZero();
  residual_ = {};
  behaviors_ = 0;
  ++revision_;
}

// In the most likely body, if there is one.
std::vector<Pose2> SelfModel::follow(const Pose2& world_from_start,
                                     const std::vector<Entry>& chain) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (belief_.probability(0) < kLikelyEnough) return {};
  const BelievedBody& body = belief_.bodies().front();
  const Physics physics = belief_.physicsOf(body);
  const Deviation residual = residual_.deviation();
  WorldState state = body.state;
  std::vector<Pose2> poses;
  Pose2 pose = world_from_start;
  for (const Entry& entry : chain) {
    state = imagination_->turned(state, pose.yaw_rad);
    Imagined imagined = std::move(imagination_->play(entry.genome, {{physics, &state}}).front());
    if (imagined.verdict != Verdict::kWalked) return {};
    pose = pose * residual.apply(imagined.start_from_end);
    poses.push_back(pose);
    state = std::move(imagined.end);
  }
  return poses;
}

Eigen::Vector2d SelfModel::drift_m() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return drift_m_;
}

std::shared_ptr<const std::vector<double>> SelfModel::caution(
    const std::shared_ptr<const Repertoire>& repertoire) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return behaviors_ == 0 && caution_.of == repertoire ? caution_.prices : nullptr;
}

// Without the lock for the most part: planning goes on meanwhile.
void SelfModel::prepare(const std::shared_ptr<const Repertoire>& repertoire,
                        const std::function<bool()>& stop) {
  if (behaviors() > 0) return;
  Caution caution{repertoire, cautionOf(*imagination_, first_belief_, *repertoire, planner_, stop)};
  const std::lock_guard<std::mutex> lock(mutex_);
  caution_ = std::move(caution);
}

void SelfModel::observe(const WalkedStep& step) {
  const std::lock_guard<std::mutex> lock(mutex_);
  learnErrors(step);
  const SeenBehavior seen = seenBy(step);
  belief_.observe(seen);
  learnResidual(seen);
  heading_rad_ = step.world_from_after.yaw_rad;
  ++behaviors_;
  ++revision_;
}

// Of the body that is believed now: what it has just learned of this behaviour is no residual.
void SelfModel::learnResidual(const SeenBehavior& seen) {
  const BelievedBody& best = belief_.bodies().front();
  if (best.legs != residual_legs_) residual_ = {};
  residual_legs_ = best.legs;
  residual_.observe(best.imagined.start_from_end, seen.startFromEnd());
}

void SelfModel::learnErrors(const WalkedStep& step) {
  if (!expected_.repertoire) return;
  for (const Entry& entry : expected_.repertoire->entries) {
    if (entry.genome != step.entry.genome || !entry.execution) continue;
    Pose2 predicted = step.world_from_before * entry.execution->mean;
    predicted.x_m += drift_m_.x();
    predicted.y_m += drift_m_.y();
    // What was far off has changed the belief, and says little of how good the new one is.
    const double off_m = std::min(distance(predicted, step.world_from_after), 3.0 * kPriorError_m);
    const double off_rad =
        std::min(headingDistance(predicted, step.world_from_after), 3.0 * kPriorError_rad);
    square_m2_ = kFadingOfMisses * square_m2_ + off_m * off_m;
    square_rad2_ = kFadingOfMisses * square_rad2_ + off_rad * off_rad;
    count_ = kFadingOfMisses * count_ + 1.0;
    return;
  }
}

std::shared_ptr<const Repertoire> SelfModel::expected(
    const std::shared_ptr<const Repertoire>& repertoire) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (expected_.of == repertoire && expected_.revision == revision_) return expected_.repertoire;
  imagined_.take(repertoire);
  expected_ = {repertoire, imagine(*repertoire), revision_};
  return expected_.repertoire;
}

std::shared_ptr<const Repertoire> SelfModel::imagine(const Repertoire& repertoire) {
  const std::vector<std::size_t>& entries = imagined_.entries();
  std::vector<Mixture> ends(entries.size());
  std::vector<bool> fails(entries.size(), false);
  const Deviation residual = residual_.deviation();
  for (std::size_t b = 0; b < belief_.bodies().size(); ++b) {
    const double probability = belief_.probability(b);
    if (b > 0 && probability < kUnlikely) break;
    const BelievedBody& body = belief_.bodies()[b];
    const ImaginedRepertoire::Played& played =
        imagined_.in(belief_.physicsOf(body), body.state, heading_rad_);
    if (b == 0) drift_m_ = played.drift_m;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Pose2 end = residual.apply(played.outcomes[i].end_pose);
      fails[i] = fails[i] || !played.outcomes[i].walked();
      ends[i].add(end, probability);
    }
  }
  auto expected = std::make_shared<Repertoire>(repertoire);
  for (Entry& entry : expected->entries) entry.execution = Execution{{}, 0.0, 0.0, kTrials, 1};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    // Half of what the start states scattered it by remains when the start state is known.
    const Execution stored = repertoire.entries[entries[i]].execution.value_or(Execution{});
    Execution execution =
        ends[i].execution(square_m2_ / count_ + std::pow(0.5 * stored.spread_m, 2),
                          square_rad2_ / count_ + std::pow(0.5 * stored.spread_rad, 2));
    execution.falls = fails[i] ? 1 : 0;
    expected->entries[entries[i]].execution = execution;
  }
  return expected;
}

}  // namespace hexapod
