#include "robot/urdf_bodies.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Eigenvalues>
#include <utility>
#include <vector>

#include "common/text.h"
#include "robot/check_source.h"
#include "robot/dimensions.h"

namespace hexapod {
namespace {

// Catches urdfdom's console messages while it lives.
class ConsoleCapture : public console_bridge::OutputHandler {
 public:
  ConsoleCapture() : previous_level_(console_bridge::getLogLevel()) {
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
    console_bridge::useOutputHandler(this);
  }
  ~ConsoleCapture() override {
    console_bridge::restorePreviousOutputHandler();
    console_bridge::setLogLevel(previous_level_);
  }
  ConsoleCapture(const ConsoleCapture&) = delete;
  ConsoleCapture& operator=(const ConsoleCapture&) = delete;

  void log(const std::string& text, console_bridge::LogLevel, const char*, int) override {
    messages_.push_back(text);
  }
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  console_bridge::LogLevel previous_level_;
  std::vector<std::string> messages_;
};

// The mass of one link in the frame of its body.
struct MassPart {
  double mass_kg;
  Eigen::Vector3d center_m;
  Eigen::Matrix3d inertia_kg_m2;  // about center_m, body axes
};

// Bars across a disc: so many that its rim is touched where it comes down, few enough to be fast.
constexpr int kBarsOfDisc = 3;

class Lumper {
 public:
  Lumper(const Findings& findings, TakeMesh take) : findings_(findings), take_(std::move(take)) {}

  LumpedBody lump(const urdf::Link& link) {
    lumped_.body.name = link.name;
    addLink(link, Eigen::Isometry3d::Identity());
    combineMasses();
    // Who makes shapes of meshes judges with those.
    if (sound_ && !take_) judgeBody();
    return lumped_;
  }

 private:
  void addLink(const urdf::Link& link, const Eigen::Isometry3d& body_from_link) {
    lumped_.body_from_link.emplace(link.name, body_from_link);
    if (link.inertial) addInertial(link, body_from_link);
    for (const auto& collision : link.collision_array) {
      addShape(link.name, *collision, body_from_link);
    }
    for (const auto& joint : link.child_joints) {
      if (joint->type != urdf::Joint::FIXED) continue;
      for (const auto& child : link.child_links) {
        if (child->name != joint->child_link_name) continue;
        addLink(*child, body_from_link * toIsometry(joint->parent_to_joint_origin_transform));
      }
    }
  }

  void addInertial(const urdf::Link& link, const Eigen::Isometry3d& body_from_link) {
    const urdf::Inertial& inertial = *link.inertial;
    Eigen::Matrix3d inertia;
    inertia << inertial.ixx, inertial.ixy, inertial.ixz,  //
        inertial.ixy, inertial.iyy, inertial.iyz,         //
        inertial.ixz, inertial.iyz, inertial.izz;
    if (!(inertial.mass >= 0.0) || !inertia.allFinite()) {
      addProblem(link.name,
                 inertial.mass >= 0.0
                     ? "has an inertia that is not finite; expected numbers."
                     : "has mass " + numberText(inertial.mass) + " kg; expected 0 or more.");
      sound_ = false;
      return;
    }
    if (inertial.mass == 0.0) return;  // a frame
    const Eigen::Isometry3d body_from_inertial = body_from_link * toIsometry(inertial.origin);
    const Eigen::Matrix3d rotation = body_from_inertial.linear();
    masses_.push_back({inertial.mass, body_from_inertial.translation(),
                       rotation * inertia * rotation.transpose()});
  }

  void addShape(const std::string& link, const urdf::Collision& collision,
                const Eigen::Isometry3d& body_from_link) {
    Shape shape;
    shape.body_from_shape = body_from_link * toIsometry(collision.origin);
    const urdf::Geometry* geometry = collision.geometry.get();
    std::string problem;
    if (const auto* box = dynamic_cast<const urdf::Box*>(geometry)) {
      problem = fillBox(*box, shape);
    } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(geometry)) {
      problem = fillSphere(*sphere, shape);
    } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(geometry)) {
      problem = fillCapsule(*cylinder, shape);
      if (problem.empty() && shape.length_m <= 0.0) return addDisc(link, *cylinder, shape);
    } else if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(geometry); mesh && take_) {
      problem = take_(*mesh, shape.body_from_shape);
      if (problem.empty()) return;
    } else {
      problem =
          "is a mesh or nothing; expected a box, a sphere or a cylinder (import_robot makes "
          "such shapes of meshes)";
    }
    if (problem.empty()) lumped_.body.shapes.push_back(shape);
    if (!problem.empty()) addProblem(link, "has a collision shape that " + problem + ".");
  }

  // Bars: capsules as thick as the disc, from rim to rim.
  void addDisc(const std::string& link, const urdf::Cylinder& cylinder, Shape shape) {
    const Eigen::Isometry3d body_from_disc = shape.body_from_shape;
    shape.radius_m = 0.5 * cylinder.length;
    shape.length_m = 2.0 * cylinder.radius - cylinder.length;
    shape.kind = shape.length_m > 0.0 ? Shape::Kind::kCapsule : Shape::Kind::kSphere;
    const int bars = shape.kind == Shape::Kind::kSphere ? 1 : kBarsOfDisc;
    for (int bar = 0; bar < bars; ++bar) {
      shape.body_from_shape = body_from_disc *
                              Eigen::AngleAxisd(bar * M_PI / bars, Eigen::Vector3d::UnitZ()) *
                              Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitY());
      lumped_.body.shapes.push_back(shape);
    }
    findings_.remarks.add(findings_.source, {"link", link},
                          "has a cylinder no longer than its diameter: simulated as bars across it "
                          "as thick as it is long.");
  }

  static std::string fillBox(const urdf::Box& box, Shape& shape) {
    shape.kind = Shape::Kind::kBox;
    shape.size_m = Eigen::Vector3d(box.dim.x, box.dim.y, box.dim.z);
    return shape.size_m.minCoeff() > 0.0 ? "" : "is a box without size; expected edges above 0 m";
  }

  static std::string fillSphere(const urdf::Sphere& sphere, Shape& shape) {
    shape.kind = Shape::Kind::kSphere;
    shape.radius_m = sphere.radius;
    return sphere.radius > 0.0
               ? ""
               : "is a sphere of radius " + numberText(sphere.radius) + " m; expected above 0 m";
  }

  static std::string fillCapsule(const urdf::Cylinder& cylinder, Shape& shape) {
    shape.kind = Shape::Kind::kCapsule;
    shape.radius_m = cylinder.radius;
    shape.length_m = cylinder.length - 2.0 * cylinder.radius;
    if (cylinder.radius > 0.0 && cylinder.length > 0.0) return "";
    return "is a cylinder of radius " + numberText(cylinder.radius) + " m and length " +
           numberText(cylinder.length) + " m; expected both above 0 m";
  }

  // Parallel axes: each part turns about the common centre of mass.
  void combineMasses() {
    Body& body = lumped_.body;
    for (const MassPart& part : masses_) {
      body.mass_kg += part.mass_kg;
      body.center_of_mass_m += part.mass_kg * part.center_m;
    }
    if (masses_.empty()) {
      // What has been rejected has been told.
      if (sound_) {
        addProblem(body.name,
                   "and what is fixed to it have no mass; expected an <inertial> with mass and "
                   "inertia in at least one of these links (import_robot makes one of shapes).");
      }
      sound_ = false;
      return;
    }
    body.center_of_mass_m /= body.mass_kg;
    for (const MassPart& part : masses_) {
      const Eigen::Vector3d arm = part.center_m - body.center_of_mass_m;
      body.inertia_kg_m2 +=
          part.inertia_kg_m2 +
          part.mass_kg * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
    }
  }

  void judgeBody() {
    const Body& body = lumped_.body;
    if (!isPossibleInertia(body.inertia_kg_m2)) {
      addProblem(body.name,
                 "has, with what is fixed to it, an impossible inertia; expected positive "
                 "principal moments, none of them larger than the sum of the other two. Check ixx "
                 ".. izz [kg m^2], or let import_robot replace them.");
    } else if (isAbsurdInertia(body)) {
      findings_.remarks.add(
          findings_.source, {"link", body.name},
          "has an inertia that its mass could only have far outside of its collision shapes; it "
          "will move as if it were that large. import_robot replaces it.");
    }
  }

  void addProblem(const std::string& link, const std::string& sentence) {
    findings_.problems.add(findings_.source, {"link", link}, sentence);
  }

  const Findings& findings_;
  TakeMesh take_;
  bool sound_ = true;  // nothing was rejected
  LumpedBody lumped_;
  std::vector<MassPart> masses_;
};

}  // namespace

urdf::ModelInterfaceSharedPtr parseUrdf(const std::string& text, const std::string& source,
                                        Problems& problems) {
  if (!isReadable(text, source, "URDF", problems)) return nullptr;
  if (text.find("<xacro:") != std::string::npos) {
    problems.add(source, "is xacro, not URDF; expand it (xacro " + source +
                             " > robot.urdf), or let import_robot do so.");
    return nullptr;
  }
  urdf::ModelInterfaceSharedPtr model;
  std::vector<std::string> errors;
  {
    const ConsoleCapture console;
    try {
      model = urdf::parseURDF(text);
    } catch (const std::exception& error) {
      errors.emplace_back(error.what());
    }
    errors.insert(errors.end(), console.messages().begin(), console.messages().end());
  }
  if (!model && errors.empty()) errors.emplace_back("it has no robot element.");
  for (const std::string& error : errors) {
    problems.add(source, "this is not a usable URDF: " + error);
  }
  // urdfdom only logs a link it could not read whole, and returns the robot without that part.
  return errors.empty() ? model : nullptr;
}

// Eigenvalues of a solid's inertia are positive, and none is larger than the other two together.
bool isPossibleInertia(const Eigen::Matrix3d& inertia) {
  constexpr double kRounding = 0.05;
  if (!inertia.allFinite()) return false;
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  return moments[0] > 0.0 && moments[2] <= (moments[0] + moments[1]) * (1.0 + kRounding);
}

Eigen::Isometry3d toIsometry(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  isometry.translation() = Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z);
  return isometry;
}

LumpedBody lumpFixedLinks(const urdf::Link& link, const Findings& findings) {
  return Lumper(findings, nullptr).lump(link);
}

LumpedBody lumpFixedLinks(const urdf::Link& link, const Findings& findings, const TakeMesh& take) {
  return Lumper(findings, take).lump(link);
}

}  // namespace hexapod
