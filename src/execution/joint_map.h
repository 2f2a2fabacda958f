#pragma once

#include <string>
#include <vector>

namespace hexapod {

/// How one joint of the description is called and counted by the servo driver.
struct WireJoint {
  std::string joint;        ///< name in the robot description
  std::string name;         ///< name on the wire
  double sign = 1.0;        ///< +1 or -1
  double offset_rad = 0.0;  ///< wire = sign * angle + offset
};

/// Names, signs and offsets between the robot description and the servo driver: their only home.
/// Immutable; const functions may be called from any thread and do not allocate once the output
/// has its size.
class JointMap {
 public:
  /// Same names, sign +1, offset 0.
  static JointMap identity(const std::vector<std::string>& joint_names);

  /// Reads the YAML form (config/joint_map_hexapod.yaml documents it); `source` names it in
  /// messages. Throws std::runtime_error with a sentence per problem: not YAML, unknown key, joint
  /// missing, unknown or twice, wire name twice, sign other than 1 or -1, offset not finite.
  static JointMap fromYaml(const std::string& text, const std::vector<std::string>& joint_names,
                           const std::string& source);

  /// In the order of the robot description.
  const std::vector<WireJoint>& joints() const { return joints_; }
  std::vector<std::string> wireNames() const;

  /// Robot angles [rad] to the driver's; both in joint order.
  void toWire(const std::vector<double>& angles_rad, std::vector<double>& wire_rad) const;
  void fromWire(const std::vector<double>& wire_rad, std::vector<double>& angles_rad) const;

 private:
  explicit JointMap(std::vector<WireJoint> joints) : joints_(std::move(joints)) {}

  std::vector<WireJoint> joints_;
};

}  // namespace hexapod
