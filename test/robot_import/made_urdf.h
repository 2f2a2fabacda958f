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

/// `legs` legs as the hexapod's around the body, evenly, the first at `first_rad` from ahead.
std::string roundUrdf(const MadeRobot& robot, int legs, double first_rad);

}  // namespace hexapod
