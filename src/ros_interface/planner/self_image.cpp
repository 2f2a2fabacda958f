#include "ros_interface/planner/self_image.h"

#include <ros/console.h>

#include <cmath>
#include <exception>
#include <utility>

#include "planning/deviation.h"
#include "self_model/describe_belief.h"

namespace hexapod {
namespace {

// Legs less surely out of order than this are not given up.
constexpr double kSure = 0.9;

// In whatever way.
double probabilityOutOfOrder(const BodyBelief& belief, std::size_t leg) {
  double probability = 0.0;
  for (std::size_t i = 0; i < belief.bodies().size(); ++i) {
    if (belief.bodies()[i].legs[leg].condition != LegCondition::kIntact) {
      probability += belief.probability(i);
    }
  }
  return probability;
}

std::vector<std::string> jointsOutOfOrder(const RobotDescription& robot, const BodyBelief& belief) {
  std::vector<std::string> joints;
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    if (probabilityOutOfOrder(belief, leg) < kSure) continue;
    for (const Segment& segment : robot.legs[leg].segments) joints.push_back(segment.joint.name);
  }
  return joints;
}

std::optional<Physics> sureBody(const BodyBelief& belief) {
  if (belief.probability(0) < kSure) return std::nullopt;
  Physics body = belief.physicsOf(belief.bodies().front());
  body.slope_x_rad = body.slope_y_rad = 0.0;
  return body;
}

}  // namespace

// A self-model that tells what it believes whenever it has seen more.
class SelfImage::Told : public SelfModel {
 public:
  Told(SelfImage& image, const LearnedWorld& learned)
      : SelfModel(*image.robot_, learned, SelfModelOptions()), image_(image) {}

  void observe(const WalkedStep& step) override {
    SelfModel::observe(step);
    tell();
  }

  void tell() { image_.tell(belief(), behaviors()); }

 private:
  SelfImage& image_;
};

SelfImage::SelfImage(const Clock& clock, std::optional<RobotDescription> robot, Tell tell)
    : clock_(clock), robot_(std::move(robot)), tell_(std::move(tell)) {}

std::shared_ptr<Foresight> SelfImage::foresightFor(const Repertoire& repertoire) {
  std::shared_ptr<Told> fresh;
  try {
    if (robot_ && robot_->digest == repertoire.robot_id) {
      fresh = std::make_shared<Told>(*this, learnedWorldOf(*robot_, repertoire));
    }
  } catch (const std::exception& error) {
    ROS_WARN_STREAM("The robot cannot simulate itself: " << error.what());
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    current_ = fresh;
  }
  if (fresh) {
    fresh->tell();
    return fresh;
  }
  const std::lock_guard<std::mutex> lock(tell_mutex_);
  told_ = {};
  sure_body_.reset();
  return std::make_shared<DeviationForesight>();
}

void SelfImage::tell(const BodyBelief& belief, int behaviors) {
  const hexapod_repertoire::BodyBelief message = messageOf(belief, behaviors);
  const std::lock_guard<std::mutex> lock(tell_mutex_);
  told_ = message;
  sure_body_ = hexapod::sureBody(belief);
  tell_(told_);
}

hexapod_repertoire::BodyBelief SelfImage::told() const {
  const std::lock_guard<std::mutex> lock(tell_mutex_);
  return told_;
}

void SelfImage::tellAgain() {
  const std::lock_guard<std::mutex> lock(tell_mutex_);
  if (told_.sentence.empty()) return;
  told_.header.stamp = clock_.rosNow();
  tell_(told_);
}

std::optional<Physics> SelfImage::sureBody() const {
  const std::lock_guard<std::mutex> lock(tell_mutex_);
  return sure_body_;
}

std::string SelfImage::forget() {
  std::shared_ptr<Told> image;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    image = current_;
  }
  if (!image) return "Nothing is believed of the robot's body: it is not simulated.";
  image->forget();
  image->tell();
  return "The robot is believed to be as it was learned for.";
}

hexapod_repertoire::BodyBelief SelfImage::messageOf(const BodyBelief& belief, int behaviors) const {
  hexapod_repertoire::BodyBelief message;
  message.header.stamp = clock_.rosNow();
  message.robot_id = robot_->digest;
  for (const LikelyLegs& one : likelyLegs(*robot_, belief)) {
    message.bodies.push_back(one.legs);
    message.probabilities.push_back(one.probability);
  }
  const BelievedBody& best = belief.bodies().front();
  for (int i = 0; i < kBodyParameters; ++i) {
    const bool is_scale = std::string(bodyParameters()[i].unit).empty();
    message.parameters.push_back(bodyParameters()[i].name);
    message.values.push_back(is_scale ? std::exp(best.mean[i]) : best.mean[i]);
    message.standard_deviations.push_back(std::sqrt(best.covariance(i, i)));
  }
  message.dead_joints = jointsOutOfOrder(*robot_, belief);
  message.behaviors = static_cast<std::uint32_t>(behaviors);
  message.sentence = describe(*robot_, belief);
  return message;
}

}  // namespace hexapod
