#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

namespace hexapod {

/// A collision primitive, posed in its body's frame. A URDF cylinder is simulated as the capsule of
/// the same overall length and radius (URDF has no capsule, and a capsule's contact with the floor
/// is smooth).
struct Shape {
  enum class Kind { kBox, kCapsule, kSphere };
  Kind kind = Kind::kSphere;
  Eigen::Isometry3d body_from_shape = Eigen::Isometry3d::Identity();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  ///< box: full edge lengths
  double radius_m = 0.0;                             ///< capsule, sphere
  double length_m = 0.0;  ///< capsule: distance between the centres of its caps, along its z
};

/// A rigid body: one URDF link with everything fixed to it, in the frame of that link.
struct Body {
  std::string name;
  double mass_kg = 0.0;
  Eigen::Vector3d center_of_mass_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();  ///< about the centre of mass, body axes
  std::vector<Shape> shapes;
};

/// Which of a leg's control signals moves a joint: two in the paper (Cully & Mouret 2013, appendix
/// B), further ones are numbered on.
enum class Signal : int { kFirst = 1, kSecond = 2 };

constexpr int kMostSignals = 4;

/// A hinge with its servo and its part in the gait.
struct Joint {
  std::string name;
  Eigen::Isometry3d parent_from_joint = Eigen::Isometry3d::Identity();  ///< at angle 0
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();                      ///< unit, joint frame
  double lower_rad = 0.0;
  double upper_rad = 0.0;
  double max_torque_nm = 0.0;
  double max_velocity_rad_per_s = 0.0;
  double neutral_rad = 0.0;    ///< angle in the neutral pose
  double amplitude_rad = 0.0;  ///< target = neutral_rad + amplitude_rad * gamma; signed
  Signal signal = Signal::kFirst;
};

/// A hinge and the body it moves; the body's frame is the joint's child frame.
struct Segment {
  Joint joint;
  Body body;
};

struct Leg {
  std::string name;
  std::vector<Segment> segments;  ///< from the base outwards
};

/// Position servo: velocity = gain * (target - angle), clamped to the joint's velocity limit and to
/// zero below the dead zone, driven with at most the joint's torque.
struct Servo {
  double gain_per_s = 16.0;
  double dead_zone_rad_per_s = 1e-5;
};

/// Contact of legs and floor and the constants of the velocity-level solver (ODE's names).
struct Contact {
  double friction = 0.9;       ///< Coulomb coefficient mu
  double slip_per_n_s = 0.02;  ///< force-dependent slip, both tangents [m/(N s)]
  double soft_erp = 0.1;
  double soft_cfm = 0.001;
  double max_correcting_velocity_m_per_s = 100.0;
  double joint_erp = 0.2;
  double joint_cfm = 1e-10;
};

/// What makes a simulated behaviour fail.
struct FailureRules {
  double max_base_height_m = 0.5;  ///< base origin above this: fell (thrown up)
};

/// Everything known about one robot: immutable, shared by simulation, gait, planner limits and
/// rviz. Built by loadRobot() from a URDF and a YAML. Joints are numbered leg by leg, from the base
/// outwards: index = first joint of the leg + segment.
struct RobotDescription {
  std::string name;
  std::string base_link;  ///< name of the URDF's link that carries the legs
  Body base;
  std::vector<Leg> legs;
  Servo servo;
  Contact contact;
  FailureRules failure;
  /// The frame of `base` and of all that hangs on it is that of the root link turned about z by
  /// this, so that x is forward [rad].
  double link_from_base_yaw_rad = 0.0;
  std::string digest;  ///< robot id: hexadecimal digest over everything above
  /// What the files say and was taken otherwise, a sentence each, for the user.
  std::vector<std::string> remarks;

  std::size_t jointCount() const;
  std::vector<std::string> jointNames() const;
  /// Pointers into this description, in joint order; valid as long as it lives.
  std::vector<const Joint*> joints() const;
  std::vector<double> neutralPose() const;  ///< [rad], in joint order
  /// The highest signal that moves a joint, 2 or more; every leg has as many.
  std::size_t signalsPerLeg() const;
  /// An amplitude and a phase for each signal.
  std::size_t genesPerLeg() const { return 2 * signalsPerLeg(); }
  /// Number of genes of a gait.
  std::size_t geneCount() const { return genesPerLeg() * legs.size(); }
};

}  // namespace hexapod
