#include "made_urdf.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace hexapod {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Five digits, as files round: 1.5708, 2.3562.
std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.5g", value);
  return text;
}

std::string vector(double x, double y, double z) {
  return number(x) + " " + number(y) + " " + number(z);
}

// A box from x = 0 on, in millimetres, as an ASCII STL.
void writeBoxMesh(const std::string& file, double length_m, double half_m) {
  const double l = 1e3 * length_m, h = 1e3 * half_m;
  const double corners[8][3] = {{0, -h, -h}, {l, -h, -h}, {l, h, -h}, {0, h, -h},
                                {0, -h, h},  {l, -h, h},  {l, h, h},  {0, h, h}};
  const int faces[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                            {2, 3, 7}, {2, 7, 6}, {1, 2, 6}, {1, 6, 5}, {0, 4, 7}, {0, 7, 3}};
  std::ofstream stl(file);
  stl << "solid box\n";
  for (const auto& face : faces) {
    stl << "facet normal 0 0 0\nouter loop\n";
    for (const int c : face) {
      stl << "vertex " << vector(corners[c][0], corners[c][1], corners[c][2]) << "\n";
    }
    stl << "endloop\nendfacet\n";
  }
  stl << "endsolid box\n";
}

class Writer {
 public:
  explicit Writer(const MadeRobot& robot)
      : robot_(robot), urdf_("<robot name='" + robot.name + "'>\n") {}

  double scaled(double value) const { return robot_.scale * value; }

  void world(const std::string& base) {
    if (!robot_.has_world) return;
    urdf_ +=
        "<link name='world'/><joint name='floating_base' type='floating'><parent "
        "link='world'/><child link='" +
        base + "'/></joint>\n";
  }

  void body(const std::string& name, double length_m, double width_m, double height_m) {
    const double l = scaled(length_m), w = scaled(width_m), h = scaled(height_m);
    const std::string geometry = robot_.has_disc_body ? "<cylinder radius='" + number(0.5 * l) +
                                                            "' length='" + number(h) + "'/>"
                                                      : "<box size='" + vector(l, w, h) + "'/>";
    const double mass = robot_.density_kg_per_m3 * l * w * h;
    const std::string at = vector(robot_.beside_x_m, 0, 0);
    link(name, geometry, at, "0 0 0", mass,
         {mass / 12 * (w * w + h * h), mass / 12 * (l * l + h * h), mass / 12 * (l * l + w * w)},
         at);
  }

  // Along x (out) or along -z (down) from its joint.
  void limb(const std::string& name, double length_m, double thickness_m, bool down) {
    const double l = scaled(length_m), t = scaled(thickness_m);
    std::string geometry =
        "<cylinder radius='" + number(0.5 * t) + "' length='" + number(l) + "'/>";
    std::string xyz = down ? vector(0, 0, -0.5 * l) : vector(0.5 * l, 0, 0);
    std::string rpy = down ? "0 0 0" : "0 1.5708 0";
    if (robot_.has_box_legs) {
      geometry = "<box size='" + (down ? vector(t, t, l) : vector(l, t, t)) + "'/>";
      rpy = "0 0 0";
    }
    const double mass = robot_.density_kg_per_m3 * l * t * t;
    const double along = mass * t * t / 6, across = mass * (l * l + t * t) / 12;
    const std::array<double, 3> moments = down ? std::array<double, 3>{across, across, along}
                                               : std::array<double, 3>{along, across, across};
    if (!robot_.mesh_folder.empty()) {
      writeBoxMesh(robot_.mesh_folder + "/" + name + ".stl", l, 0.5 * t);
      geometry = "<mesh filename='" + name + ".stl' scale='0.001 0.001 0.001'/>";
      rpy = down ? "0 1.5708 0" : "0 0 0";
      link(name, geometry, "0 0 0", rpy, mass, moments, xyz);
      return;
    }
    link(name, geometry, xyz, rpy, mass, moments, xyz);
  }

  void frame(const std::string& name, const std::string& parent, double x, double z) {
    if (!robot_.has_frames) return;
    urdf_ += "<link name='" + name +
             "'><inertial><mass value='0'/><inertia ixx='0' iyy='0' izz='0' ixy='0' ixz='0' "
             "iyz='0'/></inertial></link><joint name='" +
             name + "_mount' type='fixed'><parent link='" + parent + "'/><child link='" + name +
             "'/><origin xyz='" + vector(scaled(x), 0, scaled(z)) + "'/></joint>\n";
  }

  void hinge(const std::string& name, const std::string& parent, const std::string& child,
             const std::string& xyz, double yaw_rad, const std::string& axis) {
    urdf_ += "<joint name='" + name + "' type='revolute'><parent link='" + parent +
             "'/><child link='" + child + "'/><origin xyz='" + xyz + "' rpy='0 0 " +
             number(yaw_rad) + "'/><axis xyz='" + axis + "'/><limit lower='" +
             number(-robot_.limit_rad) + "' upper='" + number(robot_.limit_rad) + "' effort='" +
             number(robot_.effort_nm * std::pow(robot_.scale, 4)) + "' velocity='" +
             number(robot_.velocity_rad_per_s) + "'/></joint>\n";
  }

  std::string end() { return urdf_ + "</robot>\n"; }

 private:
  void link(const std::string& name, const std::string& geometry, const std::string& xyz,
            const std::string& rpy, double mass_kg, const std::array<double, 3>& moments,
            const std::string& center = "0 0 0") {
    const double share = robot_.has_inertias ? 1.0 : name.find("femur") == 0 ? 1e5 : 0.0;
    const std::string shape =
        "<origin xyz='" + xyz + "' rpy='" + rpy + "'/><geometry>" + geometry + "</geometry>";
    urdf_ += "<link name='" + name + "'><inertial><origin xyz='" + center + "'/><mass value='" +
             number(mass_kg) + "'/><inertia ixx='" + number(share * moments[0]) + "' iyy='" +
             number(share * moments[1]) + "' izz='" + number(share * moments[2]) +
             "' ixy='0' ixz='0' iyz='0'/></inertial><visual>" + shape + "</visual>";
    if (robot_.has_collisions) urdf_ += "<collision>" + shape + "</collision>";
    urdf_ += "</link>\n";
  }

  const MadeRobot& robot_;
  std::string urdf_;
};

// Flat out along `azimuth_rad` from a hip.
void addFlatLeg(Writer& writer, const std::string& id, double x_m, double y_m, double azimuth_rad) {
  const std::string coxa = "coxa_" + id, femur = "femur_" + id, tibia = "tibia_" + id;
  writer.hinge("j_" + coxa, "base", coxa, vector(writer.scaled(x_m), writer.scaled(y_m), 0),
               azimuth_rad, "0 0 1");
  writer.limb(coxa, 0.05, 0.03, false);
  writer.hinge("j_" + femur, coxa, femur, vector(writer.scaled(0.05), 0, 0), 0, "0 1 0");
  writer.limb(femur, 0.09, 0.03, false);
  writer.hinge("j_" + tibia, femur, tibia, vector(writer.scaled(0.09), 0, 0), 0, "0 1 0");
  writer.limb(tibia, 0.13, 0.025, false);
  writer.frame("foot_" + id, tibia, 0.13, 0.0);
}

}  // namespace

std::string hexapodUrdf(const MadeRobot& robot) {
  Writer writer(robot);
  writer.world("base");
  if (robot.y_forward) {
    writer.body("base", 0.16, 0.24, 0.05);
  } else {
    writer.body("base", 0.24, 0.16, 0.05);
  }
  writer.frame("imu", "base", 0.0, 0.03);
  const double turn = robot.y_forward ? kPi / 2.0 : 0.0;
  for (int i = 0; i < robot.legs_per_side; ++i) {
    for (const int side : {1, -1}) {
      const double along = 0.2 * i / (robot.legs_per_side - 1) - 0.1;
      const double across = 0.5 * robot.hips_apart_m * side;
      const double azimuth = side * (kPi / 2.0 - 4.0 * along);
      const std::string id = (robot.has_sides ? side > 0 ? "l" : "r"
                              : side > 0      ? "1"
                                              : "2") +
                             std::to_string(robot.legs_per_side - i);
      addFlatLeg(writer, id, robot.beside_x_m + std::cos(turn) * along - std::sin(turn) * across,
                 std::sin(turn) * along + std::cos(turn) * across, azimuth + turn);
    }
  }
  return writer.end();
}

std::string quadrupedUrdf(const MadeRobot& robot) {
  Writer writer(robot);
  writer.world("trunk");
  writer.body("trunk", 0.36, 0.16, 0.08);
  for (const std::string name : {"FL", "FR", "RL", "RR"}) {
    const double x = name[0] == 'F' ? 0.18 : -0.18;
    const double side = name[1] == 'L' ? 1.0 : -1.0;
    writer.hinge(name + "_abduction", "trunk", name + "_hip",
                 vector(writer.scaled(x), writer.scaled(0.07 * side), 0), 0, "1 0 0");
    writer.limb(name + "_hip", 0.045, 0.035, true);
    writer.hinge(name + "_thigh_joint", name + "_hip", name + "_thigh",
                 vector(0, writer.scaled(0.04 * side), 0), 0, "0 1 0");
    writer.limb(name + "_thigh", 0.15, 0.03, true);
    writer.hinge(name + "_calf_joint", name + "_thigh", name + "_calf",
                 vector(0, 0, writer.scaled(-0.15)), 0, "0 1 0");
    writer.limb(name + "_calf", 0.15, 0.025, true);
    writer.frame(name + "_foot", name + "_calf", 0.0, -0.15);
  }
  return writer.end();
}

std::string twoHingeUrdf(const MadeRobot& robot, int legs) {
  constexpr double kThigh_m = 0.13, kUp_m = 0.09;
  Writer writer(robot);
  writer.body("base", 0.18, 0.18, 0.16);
  for (int i = 0; i < legs; ++i) {
    const double azimuth = 2.0 * kPi * (i + 0.5) / legs;
    const std::string thigh = "thigh_" + std::to_string(i), shin = "shin_" + std::to_string(i);
    writer.hinge("j_" + thigh, "base", thigh,
                 vector(0.09 * std::cos(azimuth), 0.09 * std::sin(azimuth), 0), azimuth, "0 0 1");
    writer.limb(thigh, kThigh_m, 0.03, false);
    writer.hinge("j_" + shin, thigh, shin, vector(kThigh_m, 0, kUp_m), 0, "0 1 0");
    writer.limb(shin, 0.26, 0.025, true);
  }
  return writer.end();
}

std::string chainUrdf(const std::string& name, int hinges, double x_m, double length_m) {
  std::string urdf, parent = "base";
  for (int i = 0; i < hinges; ++i) {
    const std::string link = name + "_" + std::to_string(i);
    urdf += "<joint name='" + link + "_joint' type='revolute'><parent link='" + parent +
            "'/><child link='" + link + "'/><origin xyz='" +
            (i == 0 ? vector(x_m, 0, 0.03) : vector(0, 0, length_m)) + "'/><axis xyz='" +
            (i == 0 ? "0 0 1" : "0 1 0") +
            "'/><limit lower='-1.6' upper='1.6' effort='3' velocity='3'/></joint><link name='" +
            link +
            "'><inertial><mass value='0.02'/><inertia ixx='1e-5' iyy='1e-5' izz='1e-5' "
            "ixy='0' ixz='0' iyz='0'/></inertial></link>\n";
    parent = link;
  }
  return urdf + "</robot>";
}

std::string roundUrdf(const MadeRobot& robot, int legs, double first_rad) {
  Writer writer(robot);
  writer.body("base", 0.24, 0.24, 0.05);
  for (int i = 0; i < legs; ++i) {
    const double azimuth = first_rad + 2.0 * kPi * i / legs;
    addFlatLeg(writer, std::to_string(i), 0.12 * std::cos(azimuth), 0.12 * std::sin(azimuth),
               azimuth);
  }
  return writer.end();
}

}  // namespace hexapod
