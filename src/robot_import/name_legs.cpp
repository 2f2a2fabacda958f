#include "robot_import/name_legs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "robot/assemble_robot.h"
#include "robot_import/name_words.h"

namespace hexapod {
namespace {

Eigen::Vector2d hipOf(const Leg& leg) {
  return leg.segments.front().joint.parent_from_joint.translation().head<2>();
}

// Where the leg is, from the middle of the hips, as the base's origin may be beside the robot: its
// hip, or where it reaches at angle 0 when all hips are in one place.
std::vector<Eigen::Vector2d> placesOf(const RobotDescription& robot) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Leg& leg : robot.legs) middle += hipOf(leg) / static_cast<double>(robot.legs.size());
  std::vector<Eigen::Vector2d> places;
  for (const Leg& leg : robot.legs) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (const Segment& segment : leg.segments) pose = pose * segment.joint.parent_from_joint;
    const Eigen::Vector2d hip = hipOf(leg);
    places.push_back(hip - middle + 0.1 * (pose.translation().head<2>() - hip));
  }
  return places;
}

double widthOf(const std::vector<Eigen::Vector2d>& places) {
  double width_m = 0.0;
  for (const Eigen::Vector2d& place : places) width_m = std::max(width_m, place.norm());
  return width_m;
}

// Whether a coordinate of a place is nothing beside the robot's size.
bool isNone(double coordinate_m, double width_m) { return std::abs(coordinate_m) < 0.05 * width_m; }

// Mean place of the legs that `of` is said of less that of those that `against` is said of.
Eigen::Vector2d direction(const RobotDescription& robot, const std::vector<std::string>& of,
                          const std::vector<std::string>& against) {
  Eigen::Vector2d sums[2] = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double counts[2] = {0.0, 0.0};
  const std::vector<Eigen::Vector2d> places = placesOf(robot);
  for (std::size_t i = 0; i < robot.legs.size(); ++i) {
    std::set<std::string> words;
    for (const Segment& segment : robot.legs[i].segments) {
      for (const std::string& name : {segment.joint.name, segment.body.name}) {
        const std::set<std::string> more = wordsOf(name);
        words.insert(more.begin(), more.end());
      }
    }
    const bool is_of = hasAny(words, of), is_against = hasAny(words, against);
    if (is_of == is_against) continue;
    sums[is_of ? 0 : 1] += places[i];
    counts[is_of ? 0 : 1] += 1.0;
  }
  if (counts[0] == 0.0 || counts[1] == 0.0) return Eigen::Vector2d::Zero();
  return sums[0] / counts[0] - sums[1] / counts[1];
}

std::string axisOf(const Eigen::Vector2d& forward) {
  if (std::abs(forward.x()) >= std::abs(forward.y())) return forward.x() >= 0.0 ? "x" : "-x";
  return forward.y() >= 0.0 ? "y" : "-y";
}

// Ahead is where fewest legs are, as they stand to the sides, and along the longer axis of the
// hips. Where those are spread alike both ways the convention decides: x.
std::string axisByHips(const RobotDescription& robot) {
  constexpr double kAlike = 1.1;
  const std::vector<Eigen::Vector2d> places = placesOf(robot);
  const double width_m = widthOf(places);
  Eigen::Vector2d spread = Eigen::Vector2d::Zero();
  int on_x = 0, on_y = 0;
  for (const Eigen::Vector2d& place : places) {
    spread += place.cwiseAbs2();
    on_x += isNone(place.y(), width_m) ? 1 : 0;
    on_y += isNone(place.x(), width_m) ? 1 : 0;
  }
  if (spread.maxCoeff() <= kAlike * spread.minCoeff()) return "x";
  if (on_x != on_y) return on_x < on_y ? "x" : "y";
  return spread.y() > spread.x() ? "y" : "x";
}

// "left_front": one of the names of a side of `count` legs, from the front.
std::string nameOnSide(const std::string& side, std::size_t place, std::size_t count) {
  if (count == 1) return side;
  if (count == 2) return side + (place == 0 ? "_front" : "_rear");
  if (count == 3) return side + (place == 0 ? "_front" : place == 1 ? "_middle" : "_rear");
  return side + "_" + std::to_string(place + 1);
}

}  // namespace

void guessForward(ImportedRobot& imported) {
  const RobotDescription& robot = imported.robot;
  const Eigen::Vector2d ahead = direction(
      robot, {"front", "fore", "fl", "fr", "lf", "rf", "f"},
      {"rear", "hind", "back", "rl", "rr", "lr", "lh", "rh", "hl", "hr", "bl", "br", "lb", "rb"});
  const Eigen::Vector2d left =
      direction(robot, {"left", "l", "lf", "lm", "lr", "lh", "lb", "fl", "rl", "hl", "bl", "ml"},
                {"right", "r", "rf", "rm", "rr", "rh", "rb", "fr", "hr", "br", "mr"});
  // A quarter turn clockwise takes left to ahead.
  const Eigen::Vector2d by_sides(left.y(), -left.x());
  if (ahead.norm() > 1e-6) {
    imported.forward = axisOf(ahead);
    imported.forward_reason = "names of the front and rear legs";
  } else if (by_sides.norm() > 1e-6) {
    imported.forward = axisOf(by_sides);
    imported.forward_reason = "names of the left and right legs";
  } else {
    imported.forward = axisByHips(robot);
    imported.forward_reason = "the places of the hips; no names tell";
  }
}

void nameLegs(ImportedRobot& imported) {
  RobotDescription turned = imported.robot;
  turnForward(imported.forward, turned);
  const std::vector<Eigen::Vector2d> places = placesOf(turned);
  const double width_m = widthOf(places);
  // Clockwise from ahead, negative on the left: left rear comes last on its side.
  std::vector<std::size_t> left, right, middle;
  for (std::size_t i = 0; i < places.size(); ++i) {
    (isNone(places[i].y(), width_m) ? middle : places[i].y() > 0.0 ? left : right).push_back(i);
  }
  const auto from_front = [&](std::size_t a, std::size_t b) {
    return places[a].x() > places[b].x();
  };
  std::sort(left.begin(), left.end(), from_front);
  std::sort(right.begin(), right.end(), from_front);
  std::sort(middle.begin(), middle.end(), from_front);
  std::vector<std::pair<std::size_t, std::string>> order;
  for (std::size_t i = left.size(); i-- > 0;) {
    order.emplace_back(left[i], nameOnSide("left", i, left.size()));
  }
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const bool is_front = places[middle[i]].x() > 0.0;
    std::string name = is_front ? "front" : "rear";
    const bool is_crowded =
        middle.size() > 2 ||
        (middle.size() == 2 && places[middle[0]].x() * places[middle[1]].x() > 0.0);
    if (is_crowded) name = "middle_" + std::to_string(i + 1);
    const auto at =
        is_front ? order.begin() + static_cast<std::ptrdiff_t>(left.size()) : order.end();
    order.emplace(at, middle[i], name);
  }
  std::vector<std::pair<std::size_t, std::string>> of_right;
  for (std::size_t i = 0; i < right.size(); ++i) {
    of_right.emplace_back(right[i], nameOnSide("right", i, right.size()));
  }
  const auto rear = std::find_if(order.begin(), order.end(),
                                 [&](const auto& entry) { return entry.second == "rear"; });
  order.insert(rear, of_right.begin(), of_right.end());

  const std::vector<Leg> legs = imported.robot.legs;
  const std::vector<BodyExtras> extras = imported.extras;
  std::vector<std::size_t> first(legs.size(), 1);
  for (std::size_t i = 1; i < legs.size(); ++i)
    first[i] = first[i - 1] + legs[i - 1].segments.size();
  imported.robot.legs.clear();
  imported.extras = {extras[0]};
  for (const auto& [leg, name] : order) {
    imported.robot.legs.push_back(legs[leg]);
    imported.robot.legs.back().name = name;
    for (std::size_t s = 0; s < legs[leg].segments.size(); ++s) {
      imported.extras.push_back(extras[first[leg] + s]);
    }
  }
}

}  // namespace hexapod
