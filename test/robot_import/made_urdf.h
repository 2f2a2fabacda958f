#pragma once

#include <string>

namespace hexapod {

/// Robots in the style of public descriptions, written out by the tests.

/// How a robot of this file is described; the defaults are a plain one.
struct MadeRobot {
  std::string name = "made";
  int legs_per_side = 3;
  double scale = 1.0;
  double density_kg_per_m3 = 400.0;
  double limit_rad = 1.6;
  double effort_nm = 2.0;  ///< at scale 1; grows with its fourth power, as weight times lever does
  double velocity_rad_per_s = 6.0;
  bool y_forward = false;
  double hips_apart_m = 0.16;  ///< of a hexapod's left from its right ones, at scale 1
  bool has_sides = true;       ///< false: names do not tell left from right
  double beside_x_m = 0.0;     ///< of the hexapod from the origin of its base link
  bool has_disc_body = false;  ///< a flat cylinder instead of a box
  bool has_box_legs = false;   ///< boxes instead of cylinders
  bool has_frames = false;     ///< massless links fixed to body and feet
  bool has_world = false;      ///< a floating joint above the base
  bool has_inertias = true;    ///< false: zeros, and absurd ones in the femurs
  bool has_collisions = true;  ///< false: only something to see
  std::string mesh_folder;     ///< with a name: limbs are STL meshes, written there
};

/// Coxa, femur, tibia around a body; angle 0 is flat out, as CAD exports have it.
std::string hexapodUrdf(const MadeRobot& robot);

/// Trunk, and per leg abduction, hip and knee, straight down at angle 0.
std::string quadrupedUrdf(const MadeRobot& robot);

/// A body on `legs` legs of two hinges, which sit on thighs that point up and outwards.
std::string twoHingeUrdf(const MadeRobot& robot, int legs);

/// What to put before </robot>: `hinges` links of `length_m` on top of each other above `base` at
/// (x, 0, 0.03), with joints called name_0_joint and so on.
std::string chainUrdf(const std::string& name, int hinges, double x_m, double length_m);

/// `legs` legs as the hexapod's around the body, evenly, the first at `first_rad` from ahead.
std::string roundUrdf(const MadeRobot& robot, int legs, double first_rad);

}  // namespace hexapod
