#include "execution/belief_judge.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <set>
#include <stdexcept>

#include "common/text.h"

namespace hexapod {
namespace {

// Three of its periods.
constexpr std::int64_t kFresh_ns = 3'000'000'000;

std::set<std::size_t> legsNamed(const RobotDescription& robot, const std::string& text) {
  std::vector<std::string> known;
  for (const Leg& leg : robot.legs) known.push_back(leg.name);
  std::set<std::size_t> legs;
  for (const std::string& word : separated(text)) {
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) {
      throw std::invalid_argument("dead_legs names the leg '" + word + "'; robot '" + robot.name +
                                  "' has " + listed(known) + ".");
    }
    legs.insert(static_cast<std::size_t>(found - known.begin()));
  }
  return legs;
}

}  // namespace

BeliefJudge::BeliefJudge(const RobotDescription& robot, std::int64_t max_dead_legs,
                         const std::string& dead_legs)
    : robot_id_(robot.digest), max_dead_legs_(max_dead_legs) {
  const std::set<std::size_t> gone = legsNamed(robot, dead_legs);
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    for (const Segment& segment : robot.legs[leg].segments) {
      joints_.emplace(segment.joint.name, leg_of_joint_.size());
      if (gone.count(leg) > 0) gone_.push_back(leg_of_joint_.size());
      leg_of_joint_.push_back(leg);
    }
  }
}

void BeliefJudge::hear(const ToldBelief& told) {
  for (auto it = heard_.begin(); it != heard_.end();) {
    it = told.steady_now_ns - it->second.steady_ns > kFresh_ns ? heard_.erase(it) : std::next(it);
  }
  const Heard unheard{{}, "", 0, SourceClock(kFresh_ns)};
  Heard& heard = heard_.emplace(told.publisher, unheard).first->second;
  heard.steady_ns = told.steady_now_ns;
  heard.tolerance = {};
  heard.problem = problemWith(told, heard.clock, heard.tolerance);
}

std::string BeliefJudge::problemWith(const ToldBelief& told, SourceClock& clock,
                                     JointTolerance& tolerance) const {
  const std::string who = "What " + told.publisher + " believes of the body is left out: ";
  if (told.robot_id != robot_id_) {
    return who + "it is about the robot " + told.robot_id + ", this one is " + robot_id_ +
           "; start both nodes with the same robot description.";
  }
  if (!clock.isFresh(told.stamp_ns, told.arrival)) {
    const std::int64_t age_ns = told.arrival.ros_ns - told.stamp_ns;
    return who + "it is stamped " + std::to_string(std::abs(age_ns) / 1'000'000) + " ms " +
           (age_ns > 0 ? "ago" : "from now") +
           "; expected a fresh stamp. Synchronise the clocks of the machines.";
  }
  std::vector<std::size_t> dead;
  std::set<std::size_t> legs;
  for (const std::string& name : told.dead_joints) {
    const auto joint = joints_.find(name);
    if (joint == joints_.end()) return who + "this robot has no joint '" + name + "'.";
    dead.push_back(joint->second);
    legs.insert(leg_of_joint_[joint->second]);
  }
  if (static_cast<std::int64_t>(legs.size()) > max_dead_legs_) {
    return who + std::to_string(legs.size()) + " legs are told dead, max_dead_legs is " +
           std::to_string(max_dead_legs_) + ".";
  }
  std::sort(dead.begin(), dead.end());
  dead.erase(std::unique(dead.begin(), dead.end()), dead.end());
  tolerance = {dead, true};
  return "";
}

std::vector<std::string> BeliefJudge::talking(std::int64_t steady_now_ns) const {
  std::vector<std::string> publishers;
  for (const auto& [publisher, heard] : heard_) {
    if (steady_now_ns - heard.steady_ns <= kFresh_ns) publishers.push_back(publisher);
  }
  return publishers;
}

JointTolerance BeliefJudge::tolerance(std::int64_t steady_now_ns) const {
  const std::vector<std::string> publishers = talking(steady_now_ns);
  if (publishers.size() != 1 || max_dead_legs_ == 0) return {gone_, false};
  JointTolerance tolerance = heard_.at(publishers.front()).tolerance;
  if (gone_.empty()) return tolerance;
  std::vector<std::size_t> both;
  std::set_union(gone_.begin(), gone_.end(), tolerance.dead.begin(), tolerance.dead.end(),
                 std::back_inserter(both));
  return {both, tolerance.watched};
}

std::string BeliefJudge::problem(std::int64_t steady_now_ns) const {
  const std::vector<std::string> publishers = talking(steady_now_ns);
  if (publishers.empty() || max_dead_legs_ == 0) return "";
  if (publishers.size() == 1) return heard_.at(publishers.front()).problem;
  return "Two nodes tell what they believe of the body: " + publishers[0] + " and " +
         publishers[1] + ". Nothing is tolerated while both do; stop one of them.";
}

}  // namespace hexapod
