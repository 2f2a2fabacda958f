#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/robot_description.h"

namespace hexapod {

using Points = std::vector<Eigen::Vector3d>;

/// Corners of a box, centres of the caps of a capsule, centre of a sphere, in the body's frame.
Points corePoints(const Shape& shape);

/// How far beyond its corePoints() a shape reaches: 0 for a box.
double roundness_m(const Shape& shape);

/// The box of the points, along the axes of their frame or along their own principal axes,
/// whichever is smaller. At least 1 mm thick.
Shape fitBox(const Points& points);

/// A capsule as long as the points along the axis on which they reach farthest (one of the frame's
/// or of their own), as thick as they are on the geometric mean across it; a sphere where that is
/// no longer than thick.
Shape fitCapsule(const Points& points);

/// A capsule from `root` to the tip, where the points are farthest away from it: of the last link
/// of a leg, whose root is its joint. It ends where they end and is as thick as most of them need.
Shape fitTip(const Points& points, const Eigen::Vector3d& root);

/// A capsule of this radius from the origin to `end`, which is farther away than its diameter.
Shape rod(const Eigen::Vector3d& end, double radius_m);

/// A shape as long and thinner by this factor across its longest side.
Shape thinner(const Shape& shape, double factor);

/// Of a capsule or sphere twice its radius, of a box its shortest side [m].
double thickness_m(const Shape& shape);

/// Whether `inner` is within `outer`, but for 1 mm.
bool isInside(const Shape& inner, const Shape& outer);

/// How far two shapes posed in one frame are apart [m]: not more than their distance, 0 or less
/// when they touch.
double gap_m(const Shape& a, const Shape& b);

double volume_m3(const Shape& shape);

/// Inertia of a solid of unit density and this shape about its centre, in its body's axes [m^5].
Eigen::Matrix3d solidInertia(const Shape& shape);

}  // namespace hexapod
