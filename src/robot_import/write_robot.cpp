#include "robot_import/write_robot.h"

#include <locale>
#include <sstream>

#include "robot/assemble_robot.h"

namespace hexapod {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// Writes elements of a URDF; lengths to 0.1 um.
class UrdfWriter {
 public:
  UrdfWriter() {
    text_.imbue(std::locale::classic());
    text_.precision(10);
  }

  void begin(const ImportedRobot& imported, const std::string& urdf_name) {
    text_ << "<?xml version=\"1.0\"?>\n<!-- Made by import_robot from " << commented(urdf_name)
          << ": bodies, shapes and masses as they are simulated. -->\n<robot name=\""
          << escaped(imported.robot.name) << "\">\n";
  }

  void writeBody(const Body& body, const BodyExtras& extras) {
    text_ << "  <link name=\"" << escaped(body.name) << "\">\n    <inertial>\n      ";
    writeOrigin(Eigen::Isometry3d(Eigen::Translation3d(body.center_of_mass_m)));
    const Eigen::Matrix3d& i = body.inertia_kg_m2;
    text_ << "\n      <mass value=\"" << body.mass_kg << "\"/>\n      <inertia ixx=\"" << i(0, 0)
          << "\" iyy=\"" << i(1, 1) << "\" izz=\"" << i(2, 2) << "\" ixy=\"" << i(0, 1)
          << "\" ixz=\"" << i(0, 2) << "\" iyz=\"" << i(1, 2) << "\"/>\n    </inertial>\n";
    for (const Look& look : extras.looks) writeLook(look);
    for (const Shape& shape : body.shapes) writeShape(shape);
    text_ << "  </link>\n";
    for (const Frame& frame : extras.frames) writeFrame(body.name, frame);
  }

  void writeJoint(const Joint& joint, const std::string& parent, const std::string& child) {
    text_ << "  <joint name=\"" << escaped(joint.name)
          << "\" type=\"revolute\">\n    <parent link=\"" << escaped(parent)
          << "\"/>\n    <child link=\"" << escaped(child) << "\"/>\n    ";
    writeOrigin(joint.parent_from_joint);
    text_ << "\n    <axis xyz=\"" << joint.axis.x() << " " << joint.axis.y() << " "
          << joint.axis.z() << "\"/>\n    <limit lower=\"" << joint.lower_rad << "\" upper=\""
          << joint.upper_rad << "\" effort=\"" << joint.max_torque_nm << "\" velocity=\""
          << joint.max_velocity_rad_per_s << "\"/>\n  </joint>\n";
  }

  std::string end() {
    text_ << "</robot>\n";
    return text_.str();
  }

 private:
  static std::string commented(std::string text) {
    for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--")) {
      text.replace(at, 2, "-");
    }
    return text;
  }

  void writeOrigin(const Eigen::Isometry3d& pose) {
    const Eigen::Matrix3d r = pose.linear();
    // Fixed axes x, y, z as URDF has them.
    const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
    const bool is_upright = std::hypot(r(0, 0), r(1, 0)) > 1e-9;
    const double roll = is_upright ? std::atan2(r(2, 1), r(2, 2)) : 0.0;
    const double yaw = is_upright ? std::atan2(r(1, 0), r(0, 0)) : std::atan2(-r(0, 1), r(1, 1));
    const Eigen::Vector3d p = pose.translation();
    text_ << "<origin xyz=\"" << p.x() << " " << p.y() << " " << p.z() << "\" rpy=\"" << roll << " "
          << pitch << " " << yaw << "\"/>";
  }

  void writeShape(const Shape& shape) {
    text_ << "    <collision>\n      ";
    writeOrigin(shape.body_from_shape);
    text_ << "\n      <geometry>";
    if (shape.kind == Shape::Kind::kBox) {
      text_ << "<box size=\"" << shape.size_m.x() << " " << shape.size_m.y() << " "
            << shape.size_m.z() << "\"/>";
    } else if (shape.kind == Shape::Kind::kCapsule) {
      text_ << "<cylinder radius=\"" << shape.radius_m << "\" length=\""
            << shape.length_m + 2.0 * shape.radius_m << "\"/>";
    } else {
      text_ << "<sphere radius=\"" << shape.radius_m << "\"/>";
    }
    text_ << "</geometry>\n    </collision>\n";
  }

  void writeLook(const Look& look) {
    text_ << "    <visual>\n      ";
    writeOrigin(look.body_from_look);
    text_ << "\n      <geometry>";
    if (const auto* box = dynamic_cast<const urdf::Box*>(look.geometry.get())) {
      text_ << "<box size=\"" << box->dim.x << " " << box->dim.y << " " << box->dim.z << "\"/>";
    } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(look.geometry.get())) {
      text_ << "<cylinder radius=\"" << cylinder->radius << "\" length=\"" << cylinder->length
            << "\"/>";
    } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(look.geometry.get())) {
      text_ << "<sphere radius=\"" << sphere->radius << "\"/>";
    } else if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(look.geometry.get())) {
      text_ << "<mesh filename=\"" << escaped(mesh->filename) << "\" scale=\"" << mesh->scale.x
            << " " << mesh->scale.y << " " << mesh->scale.z << "\"/>";
    }
    text_ << "</geometry>\n    </visual>\n";
  }

  void writeFrame(const std::string& body, const Frame& frame) {
    text_ << "  <link name=\"" << escaped(frame.link) << "\"/>\n  <joint name=\""
          << escaped(body + "_to_" + frame.link) << "\" type=\"fixed\">\n    <parent link=\""
          << escaped(body) << "\"/>\n    <child link=\"" << escaped(frame.link) << "\"/>\n    ";
    writeOrigin(frame.body_from_link);
    text_ << "\n  </joint>\n";
  }

  std::ostringstream text_;
};

// A text for YAML, in double quotes where it could be read as anything else.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

void writeLegs(const RobotDescription& robot, std::ostream& yaml) {
  for (const Leg& leg : robot.legs) {
    yaml << "  - name: " << leg.name << "\n    joints: [";
    for (std::size_t s = 0; s < leg.segments.size(); ++s) {
      yaml << (s == 0 ? "" : ", ") << quoted(leg.segments[s].joint.name);
    }
    yaml << "]\n    gait:\n";
    for (const Segment& segment : leg.segments) {
      const Joint& joint = segment.joint;
      yaml << "      - {signal: " << static_cast<int>(joint.signal)
           << ", neutral_rad: " << joint.neutral_rad << ", amplitude_rad: " << joint.amplitude_rad
           << "}\n";
    }
  }
}

}  // namespace

std::string urdfOf(const ImportedRobot& imported, const std::string& urdf_name) {
  UrdfWriter writer;
  writer.begin(imported, urdf_name);
  writer.writeBody(imported.robot.base, imported.extras[0]);
  std::size_t b = 1;
  for (const Leg& leg : imported.robot.legs) {
    std::string parent = imported.robot.base.name;
    for (const Segment& segment : leg.segments) {
      writer.writeJoint(segment.joint, parent, segment.body.name);
      writer.writeBody(segment.body, imported.extras[b++]);
      parent = segment.body.name;
    }
  }
  return writer.end();
}

std::string yamlOf(const ImportedRobot& imported, const std::string& urdf_name) {
  const RobotDescription& robot = imported.robot;
  std::ostringstream yaml;
  yaml.imbue(std::locale::classic());
  yaml.precision(10);
  yaml << "# Made by import_robot for " << urdf_name
       << ". What the keys mean: config/hexapod.yaml.\n"
       << "name: " << quoted(robot.name) << "\nbase_link: " << quoted(robot.base_link)
       << "\n# Chosen by " << imported.forward_reason << ".\nforward: " << quoted(imported.forward)
       << "\n\n# Neutral pose and signs were chosen from limits, torques and kinematics.\nlegs:\n";
  writeLegs(robot, yaml);
  const Servo servo;
  const Contact contact;
  yaml << "\nservo:\n  gain_per_s: " << servo.gain_per_s << "\n  dead_zone_rad_per_s: 1.0e-5\n"
       << "\n# slip_per_n_s and soft_cfm suit the robot's mass unless they are given "
          "here.\ncontact:\n"
       << "  friction: " << contact.friction << "\n  soft_erp: " << contact.soft_erp
       << "\n  max_correcting_velocity_m_per_s: 100.0\n  joint_erp: " << contact.joint_erp
       << "\n  joint_cfm: 1.0e-14\n"
       << "\n# max_base_height_m suits the robot's legs unless it is given here.\nfailure: {}\n";
  return yaml.str();
}

}  // namespace hexapod
