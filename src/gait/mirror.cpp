#include "gait/mirror.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// In metres, radians, kilograms ..: far above rounding, far below what matters.
constexpr double kTolerance = 1e-6;

bool same(double a, double b) { return std::abs(a - b) <= kTolerance; }

template <typename Derived>
bool same(const Eigen::MatrixBase<Derived>& a, const Eigen::MatrixBase<Derived>& b) {
  return (a - b).cwiseAbs().maxCoeff() <= kTolerance;
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

// Whether the two signals of a leg have to be negated; all joints of one signal must agree.
class SignalSigns {
 public:
  // `product` tells by its sign. False when the joint contradicts an earlier one.
  bool add(const Joint& joint, double product) {
    if (std::abs(joint.amplitude_rad) <= kTolerance) return true;
    int& sign = signs_[joint.signal == Signal::kFirst ? 0 : 1];
    const int wanted = product < 0.0 ? -1 : 1;
    if (sign == 0) sign = wanted;
    return sign == wanted;
  }
  std::array<bool, 2> negated() const { return {signs_[0] < 0, signs_[1] < 0}; }

 private:
  std::array<int, 2> signs_ = {0, 0};  // 0: no joint moves at this signal
};

}  // namespace

std::optional<std::vector<Symmetry::LegImage>> Mirror::legImages(
    const RobotDescription& robot) const {
  const Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  if (!bodiesMatch(robot.base, base, robot.base, base)) return std::nullopt;
  std::vector<Symmetry::LegImage> images;
  for (const Leg& leg : robot.legs) {
    std::optional<Symmetry::LegImage> image;
    for (std::size_t other = 0; other < robot.legs.size() && !image; ++other) {
      image = legImage(leg, robot.legs[other]);
      if (image) image->leg = other;
    }
    if (!image) return std::nullopt;
    images.push_back(*image);
  }
  // Twice the image is the robot itself, unless legs coincide.
  for (std::size_t leg = 0; leg < images.size(); ++leg) {
    if (images[images[leg].leg].leg != leg) return std::nullopt;
  }
  return images;
}

std::optional<Symmetry::LegImage> Mirror::legImage(const Leg& leg, const Leg& other) const {
  if (leg.segments.size() != other.segments.size()) return std::nullopt;
  SignalSigns signs;
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
    if (!same(axis, (sense * twin_axis).eval()) ||
        !same(origin, base_from_twin.translation().eval()) || !jointsMatch(joint, twin, sense) ||
        !signs.add(joint, sense * joint.amplitude_rad * twin.amplitude_rad)) {
      return std::nullopt;
    }
    base_from_body = base_from_body * neutralTurn(joint);
    base_from_twin = base_from_twin * neutralTurn(twin);
    if (!bodiesMatch(body, base_from_body, twin_body, base_from_twin)) return std::nullopt;
  }
  return Symmetry::LegImage{0, signs.negated()};
}

bool Mirror::jointsMatch(const Joint& joint, const Joint& other, double sense) const {
  const double down_rad = joint.lower_rad - joint.neutral_rad;
  const double up_rad = joint.upper_rad - joint.neutral_rad;
  return joint.signal == other.signal &&
         same(std::abs(joint.amplitude_rad), std::abs(other.amplitude_rad)) &&
         same(joint.max_torque_nm, other.max_torque_nm) &&
         same(joint.max_velocity_rad_per_s, other.max_velocity_rad_per_s) &&
         same(sense > 0.0 ? down_rad : -up_rad, other.lower_rad - other.neutral_rad) &&
         same(sense > 0.0 ? up_rad : -down_rad, other.upper_rad - other.neutral_rad);
}

bool Mirror::bodiesMatch(const Body& body, const Eigen::Isometry3d& base_from_body,
                         const Body& other, const Eigen::Isometry3d& base_from_other) const {
  if (!same(body.mass_kg, other.mass_kg) || body.shapes.size() != other.shapes.size() ||
      !same(imageOf(base_from_body * body.center_of_mass_m),
            base_from_other * other.center_of_mass_m) ||
      !same(imageOfTensor(inFrame(base_from_body.linear(), body.inertia_kg_m2)),
            inFrame(base_from_other.linear(), other.inertia_kg_m2))) {
    return false;
  }
  std::vector<const Shape*> left;
  for (const Shape& shape : other.shapes) left.push_back(&shape);
  for (const Shape& shape : body.shapes) {
    const auto match = std::find_if(left.begin(), left.end(), [&](const Shape* candidate) {
      return shapesMatch(shape, base_from_body, *candidate, base_from_other);
    });
    if (match == left.end()) return false;
    left.erase(match);
  }
  return true;
}

bool Mirror::shapesMatch(const Shape& shape, const Eigen::Isometry3d& base_from_body,
                         const Shape& other, const Eigen::Isometry3d& base_from_other) const {
  const Eigen::Isometry3d base_from_shape = base_from_body * shape.body_from_shape;
  const Eigen::Isometry3d base_from_twin = base_from_other * other.body_from_shape;
  const Eigen::Vector3d center = base_from_shape.translation();
  return shape.kind == other.kind && same(imageOf(center), base_from_twin.translation().eval()) &&
         same(imageOfTensor(inFrame(base_from_shape.linear(), extent(shape))),
              inFrame(base_from_twin.linear(), extent(other)));
}

}  // namespace hexapod
