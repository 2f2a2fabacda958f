#include "robot_import/repair_masses.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/text.h"
#include "robot/dimensions.h"
#include "robot/urdf_bodies.h"
#include "robot_import/fit_shape.h"

namespace hexapod {
namespace {

double densityOf(const Body& body) {
  double volume = 0.0;
  for (const Shape& shape : body.shapes) volume += volume_m3(shape);
  return volume > 0.0 ? body.mass_kg / volume : 0.0;
}

void inertiaFromShapes(Body& body, double smallest_m) {
  double volume = 0.0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Shape& shape : body.shapes) {
    volume += volume_m3(shape);
    center += volume_m3(shape) * shape.body_from_shape.translation();
  }
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  // Never less than a ball's of the smallest size.
  body.inertia_kg_m2 = 0.4 * body.mass_kg * smallest_m * smallest_m * one;
  if (volume <= 0.0) return;
  body.center_of_mass_m = center / volume;
  const double density = body.mass_kg / volume;
  for (const Shape& shape : body.shapes) {
    const Eigen::Vector3d arm = shape.body_from_shape.translation() - body.center_of_mass_m;
    body.inertia_kg_m2 +=
        density * solidInertia(shape) +
        density * volume_m3(shape) * (arm.squaredNorm() * one - arm * arm.transpose());
  }
}

}  // namespace

void repairMasses(ImportedRobot& imported, ImportReport& report) {
  constexpr double kDensity_kg_per_m3 = 500.0;
  constexpr double kLeastShare = 1e-3;
  constexpr double kSmallestShare = 0.02;
  std::vector<double> densities;
  double total_kg = 0.0;
  forEachBody(imported, [&](Body& body, BodyExtras&, bool, bool) {
    if (!(body.mass_kg > 0.0)) return;
    total_kg += body.mass_kg;
    if (densityOf(body) > 0.0) densities.push_back(densityOf(body));
  });
  std::sort(densities.begin(), densities.end());
  const double density = densities.empty()
                             ? kDensity_kg_per_m3
                             : std::clamp(densities[densities.size() / 2], 100.0, 3000.0);
  const double smallest_m = kSmallestShare * legReach_m(imported.robot);
  forEachBody(imported, [&](Body& body, BodyExtras&, bool, bool) {
    bool is_sound = body.mass_kg > 0.0 && isPossibleInertia(body.inertia_kg_m2);
    if (!(body.mass_kg > 0.0)) {
      for (const Shape& shape : body.shapes) body.mass_kg += density * volume_m3(shape);
      report.remarks.add("masses", {"link", body.name},
                         "has no mass: taken from its shapes with " +
                             numberText(std::round(density)) + " kg/m^3.");
    } else if (!is_sound) {
      report.remarks.add("masses", {"link", body.name},
                         "has no possible inertia: taken from its shapes and mass.");
    } else if (isAbsurdInertia(body)) {
      is_sound = false;
      report.remarks.add("masses", {"link", body.name},
                         "has an inertia far beyond its shapes: replaced by that of its shapes.");
    }
    if (body.mass_kg < kLeastShare * total_kg) {
      body.mass_kg = std::max(kLeastShare * total_kg, 1e-4);
      is_sound = false;
      report.remarks.add("masses", {"link", body.name},
                         "is lighter than a thousandth of the robot: taken as that heavy.");
    }
    if (!is_sound) inertiaFromShapes(body, smallest_m);
  });
}

}  // namespace hexapod
