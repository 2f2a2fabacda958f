#include "gait/mirror.h"

#include <algorithm>
#include <cmath>

#include "common/problems.h"
#include "common/text.h"
#include "robot/dimensions.h"

namespace hexapod {
namespace {

// What files round away: far above the last digit, far below what a gait feels.
constexpr double kTolerance = 1e-3;         // of angles [rad], axes, and lengths per size
constexpr double kMassTolerance = 0.01;     // per mass
constexpr double kInertiaTolerance = 0.05;  // per largest moment

constexpr double kRounding = 1e-9;  // of sums, in any unit

bool same(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance + kRounding; }

template <typename Derived>
bool same(const Eigen::MatrixBase<Derived>& a, const Eigen::MatrixBase<Derived>& b,
          double tolerance) {
  return (a - b).cwiseAbs().maxCoeff() <= tolerance + kRounding;
}

// "x is 0.1 m, its image 0.2 m"
std::string differs(const std::string& what, double value, double image, const std::string& unit) {
  return what + " is " + numberText(value) + " " + unit + ", that of its image " +
         numberText(image) + " " + unit;
}

std::string pointText(const Eigen::Vector3d& point) {
  return "(" + numberText(point.x()) + " " + numberText(point.y()) + " " + numberText(point.z()) +
         ")";
}

Eigen::Matrix3d inFrame(const Eigen::Matrix3d& rotation, const Eigen::Matrix3d& tensor) {
  return rotation * tensor * rotation.transpose();
}

// A shape's extent as a tensor that reflections and half turns of the shape itself leave alone.
Eigen::Matrix3d extent(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::kBox:
      return shape.size_m.asDiagonal();
    case Shape::Kind::kCapsule:
      return Eigen::Vector3d(shape.radius_m, shape.radius_m, shape.radius_m + shape.length_m)
          .asDiagonal();
    case Shape::Kind::kSphere:
      break;
  }
  return shape.radius_m * Eigen::Matrix3d::Identity();
}

Eigen::Isometry3d neutralTurn(const Joint& joint) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(joint.neutral_rad, joint.axis));
}

// Whether the signals of a leg have to be negated; all joints of one signal must agree.
class SignalSigns {
 public:
  explicit SignalSigns(std::size_t signals) : signs_(signals, 0) {}

  // `product` tells by its sign. False when the joint contradicts an earlier one.
  bool add(const Joint& joint, double product) {
    if (std::abs(joint.amplitude_rad) <= kRounding) return true;
    int& sign = signs_[static_cast<std::size_t>(joint.signal) - 1];
    const int wanted = product < 0.0 ? -1 : 1;
    if (sign == 0) sign = wanted;
    return sign == wanted;
  }
  std::vector<bool> negated() const {
    std::vector<bool> negated;
    for (const int sign : signs_) negated.push_back(sign < 0);
    return negated;
  }

 private:
  std::vector<int> signs_;  // 0: no joint moves at this signal
};

}  // namespace

Mirror::Mirror(const RobotDescription& robot, double x_sign, double y_sign)
    : robot_(robot), flip_(x_sign, y_sign, 1.0) {
  double size_m = 0.0;
  for (const Leg& leg : robot.legs) {
    if (leg.segments.empty()) continue;
    size_m = std::max(size_m, leg.segments[0].joint.parent_from_joint.translation().norm());
  }
  length_tolerance_m_ = kTolerance * std::max(size_m, legReach_m(robot));
}

std::optional<std::vector<Symmetry::LegImage>> Mirror::legImages() {
  const Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  difference_ = bodyDifference(robot_.base, base, robot_.base, base);
  if (!difference_.empty()) return std::nullopt;
  std::vector<Symmetry::LegImage> images;
  for (const Leg& leg : robot_.legs) {
    Comparison nearest;
    for (std::size_t other = 0; other < robot_.legs.size() && !nearest.image; ++other) {
      Comparison comparison = compare(leg, robot_.legs[other]);
      if (comparison.image) comparison.image->leg = other;
      const bool is_nearer = nearest.difference.empty() ||
                             comparison.agreeing_parts > nearest.agreeing_parts ||
                             (comparison.agreeing_parts == nearest.agreeing_parts &&
                              comparison.apart_m < nearest.apart_m);
      if (comparison.image || is_nearer) nearest = comparison;
    }
    if (!nearest.image) {
      difference_ = "leg " + leg.name + " has no image: " + nearest.difference;
      return std::nullopt;
    }
    images.push_back(*nearest.image);
  }
  // Twice the image is the robot itself, unless legs coincide.
  for (std::size_t leg = 0; leg < images.size(); ++leg) {
    if (images[images[leg].leg].leg == leg) continue;
    difference_ = "two legs are where leg " + robot_.legs[leg].name + " has its image";
    return std::nullopt;
  }
  return images;
}

Mirror::Comparison Mirror::compare(const Leg& leg, const Leg& other) const {
  Comparison result;
  const auto fail = [&](const std::string& difference) {
    result.difference = difference;
    return result;
  };
  if (leg.segments.size() != other.segments.size()) {
    return fail("no leg beside it has as many joints");
  }
  SignalSigns signs(robot_.signalsPerLeg());
  Eigen::Isometry3d base_from_body = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d base_from_twin = Eigen::Isometry3d::Identity();
  for (std::size_t s = 0; s < leg.segments.size(); ++s) {
    const auto& [joint, body] = leg.segments[s];
    const auto& [twin, twin_body] = other.segments[s];
    base_from_body = base_from_body * joint.parent_from_joint;
    base_from_twin = base_from_twin * twin.parent_from_joint;
    // An axis is a pseudovector: a reflection turns the sense of rotation about its image.
    const Eigen::Vector3d axis = flip_.prod() * imageOf(base_from_body.linear() * joint.axis);
    const Eigen::Vector3d twin_axis = base_from_twin.linear() * twin.axis;
    const double sense = axis.dot(twin_axis) > 0.0 ? 1.0 : -1.0;
    const Eigen::Vector3d origin = imageOf(base_from_body.translation());
    const Eigen::Vector3d twin_origin = base_from_twin.translation();
    if (s == 0) result.apart_m = (origin - twin_origin).norm();
    if (!same(origin, twin_origin, length_tolerance_m_)) {
      return fail("joint " + joint.name + " would be at " + pointText(origin) +
                  " m, the nearest, " + twin.name + ", is at " + pointText(twin_origin) + " m");
    }
    ++result.agreeing_parts;
    if (!same(axis, (sense * twin_axis).eval(), kTolerance)) {
      return fail("the axis of joint " + joint.name + " would be " + pointText(axis) +
                  ", that of " + twin.name + " is " + pointText(twin_axis));
    }
    ++result.agreeing_parts;
    const std::string difference = jointDifference(joint, twin, sense);
    if (!difference.empty()) return fail(difference);
    if (!signs.add(joint, sense * joint.amplitude_rad * twin.amplitude_rad)) {
      return fail("the joints of " + leg.name + " and " + other.name +
                  " have amplitudes of signs that do not go together");
    }
    base_from_body = base_from_body * neutralTurn(joint);
    base_from_twin = base_from_twin * neutralTurn(twin);
    const std::string of_body = bodyDifference(body, base_from_body, twin_body, base_from_twin);
    if (!of_body.empty()) return fail(of_body);
    ++result.agreeing_parts;
  }
  result.image = Symmetry::LegImage{0, signs.negated()};
  return result;
}

std::string Mirror::jointDifference(const Joint& joint, const Joint& other, double sense) const {
  const double down_rad = joint.lower_rad - joint.neutral_rad;
  const double up_rad = joint.upper_rad - joint.neutral_rad;
  const std::string of = " of joint " + joint.name;
  if (joint.signal != other.signal) return "the signal" + of + " is another than that of its image";
  const auto compared = [&](const std::string& what, double value, double image, double tolerance,
                            const std::string& unit) {
    return same(value, image, tolerance) ? "" : differs(what + of, value, image, unit);
  };
  for (const std::string& difference :
       {compared("the amplitude", std::abs(joint.amplitude_rad), std::abs(other.amplitude_rad),
                 kTolerance, "rad"),
        compared("the torque", joint.max_torque_nm, other.max_torque_nm,
                 kMassTolerance * joint.max_torque_nm, "N m"),
        compared("the velocity", joint.max_velocity_rad_per_s, other.max_velocity_rad_per_s,
                 kMassTolerance * joint.max_velocity_rad_per_s, "rad/s"),
        compared("the way from neutral to one limit", sense > 0.0 ? down_rad : -up_rad,
                 other.lower_rad - other.neutral_rad, kTolerance, "rad"),
        compared("the way from neutral to one limit", sense > 0.0 ? up_rad : -down_rad,
                 other.upper_rad - other.neutral_rad, kTolerance, "rad")}) {
    if (!difference.empty()) return difference;
  }
  return "";
}

std::string Mirror::bodyDifference(const Body& body, const Eigen::Isometry3d& base_from_body,
                                   const Body& other,
                                   const Eigen::Isometry3d& base_from_other) const {
  const std::string of = " of link " + body.name;
  if (!same(body.mass_kg, other.mass_kg, kMassTolerance * body.mass_kg)) {
    return differs("the mass" + of, body.mass_kg, other.mass_kg, "kg");
  }
  const Eigen::Vector3d center = imageOf(base_from_body * body.center_of_mass_m);
  const Eigen::Vector3d twin_center = base_from_other * other.center_of_mass_m;
  if (!same(center, twin_center, length_tolerance_m_)) {
    return "the centre of mass" + of + " would be at " + pointText(center) +
           " m, that of its image is at " + pointText(twin_center) + " m";
  }
  if (!same(imageOfTensor(inFrame(base_from_body.linear(), body.inertia_kg_m2)),
            inFrame(base_from_other.linear(), other.inertia_kg_m2),
            kInertiaTolerance * body.inertia_kg_m2.cwiseAbs().maxCoeff())) {
    return "the inertia" + of + " is another than that of its image";
  }
  if (body.shapes.size() != other.shapes.size()) {
    return "the shapes" + of + " are more or fewer than those of its image";
  }
  std::vector<const Shape*> left;
  for (const Shape& shape : other.shapes) left.push_back(&shape);
  for (const Shape& shape : body.shapes) {
    const auto match = std::find_if(left.begin(), left.end(), [&](const Shape* candidate) {
      return shapesMatch(shape, base_from_body, *candidate, base_from_other);
    });
    if (match == left.end()) return "a shape" + of + " has no image";
    left.erase(match);
  }
  return "";
}

bool Mirror::shapesMatch(const Shape& shape, const Eigen::Isometry3d& base_from_body,
                         const Shape& other, const Eigen::Isometry3d& base_from_other) const {
  const Eigen::Isometry3d base_from_shape = base_from_body * shape.body_from_shape;
  const Eigen::Isometry3d base_from_twin = base_from_other * other.body_from_shape;
  const Eigen::Vector3d center = base_from_shape.translation();
  return shape.kind == other.kind &&
         same(imageOf(center), base_from_twin.translation().eval(), length_tolerance_m_) &&
         same(imageOfTensor(inFrame(base_from_shape.linear(), extent(shape))),
              inFrame(base_from_twin.linear(), extent(other)), length_tolerance_m_);
}

}  // namespace hexapod
