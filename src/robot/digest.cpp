#include "robot/digest.h"

#include <cmath>
#include <cstdint>
#include <iomanip>
#include <locale>
#include <sstream>

namespace hexapod {
namespace {

// Collects the canonical text, one value a line.
class Canonical {
 public:
  Canonical() {
    text_.imbue(std::locale::classic());
    text_ << std::setprecision(12);
  }

  void add(double value) { text_ << (std::abs(value) < 1e-15 ? 0.0 : value) << '\n'; }
  void add(int value) { text_ << value << '\n'; }
  void add(std::size_t value) { text_ << value << '\n'; }
  // The length keeps two neighbouring texts apart.
  void add(const std::string& value) { text_ << value.size() << ' ' << value << '\n'; }
  template <typename Derived>
  void addMatrix(const Eigen::MatrixBase<Derived>& matrix) {
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      for (Eigen::Index column = 0; column < matrix.cols(); ++column) add(matrix(row, column));
    }
  }

  void add(const Body& body) {
    add(body.name);
    add(body.mass_kg);
    addMatrix(body.center_of_mass_m);
    addMatrix(body.inertia_kg_m2);
    add(body.shapes.size());
    for (const Shape& shape : body.shapes) {
      add(static_cast<int>(shape.kind));
      addMatrix(shape.body_from_shape.matrix());
      addMatrix(shape.size_m);
      add(shape.radius_m);
      add(shape.length_m);
    }
  }

  void add(const Joint& joint) {
    add(joint.name);
    addMatrix(joint.parent_from_joint.matrix());
    addMatrix(joint.axis);
    for (double value : {joint.lower_rad, joint.upper_rad, joint.max_torque_nm,
                         joint.max_velocity_rad_per_s, joint.neutral_rad, joint.amplitude_rad}) {
      add(value);
    }
    add(static_cast<int>(joint.signal));
  }

  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

std::uint64_t fnv1a(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

}  // namespace

std::string digestOf(const RobotDescription& robot) {
  Canonical canonical;
  canonical.add(robot.name);
  canonical.add(robot.base_link);
  canonical.add(robot.base);
  canonical.add(robot.legs.size());
  for (const Leg& leg : robot.legs) {
    canonical.add(leg.name);
    canonical.add(leg.segments.size());
    for (const Segment& segment : leg.segments) {
      canonical.add(segment.joint);
      canonical.add(segment.body);
    }
  }
  const Contact& contact = robot.contact;
  for (double value : {robot.servo.gain_per_s, robot.servo.dead_zone_rad_per_s, contact.friction,
                       contact.slip_per_n_s, contact.soft_erp, contact.soft_cfm,
                       contact.max_correcting_velocity_m_per_s, contact.joint_erp,
                       contact.joint_cfm, robot.failure.max_base_height_m}) {
    canonical.add(value);
  }
  std::ostringstream digits;
  digits.imbue(std::locale::classic());
  digits << std::hex << std::setfill('0') << std::setw(16) << fnv1a(canonical.text());
  return digits.str();
}

}  // namespace hexapod
