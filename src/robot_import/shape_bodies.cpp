#include "robot_import/shape_bodies.h"

#include <algorithm>

#include "robot_import/guess_shapes.h"
#include "simulation/kinematics.h"

namespace hexapod {
namespace {

constexpr std::size_t kMostShapesOfBase = 6;
constexpr std::size_t kMostShapesOfSegment = 3;

// Points that span a shape, for fitting another one around it.
Points spanOf(const Shape& shape) {
  Points points;
  for (const Eigen::Vector3d& core : corePoints(shape)) {
    if (shape.kind == Shape::Kind::kBox) {
      points.push_back(core);
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d out = shape.radius_m * shape.body_from_shape.linear().col(axis);
      points.push_back(core + out);
      points.push_back(core - out);
    }
  }
  return points;
}

void append(const Points& more, Points& points) {
  points.insert(points.end(), more.begin(), more.end());
}

Shape shapeOf(const urdf::Geometry& geometry, const Eigen::Isometry3d& body_from_shape) {
  Shape shape;
  shape.body_from_shape = body_from_shape;
  shape.kind = Shape::Kind::kBox;
  if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry)) {
    shape.size_m = Eigen::Vector3d(box->dim.x, box->dim.y, box->dim.z);
  } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry)) {
    shape.size_m =
        Eigen::Vector3d(2.0 * cylinder->radius, 2.0 * cylinder->radius, cylinder->length);
  } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&geometry)) {
    shape.kind = Shape::Kind::kSphere;
    shape.radius_m = sphere->radius;
  }
  return shape;
}

Points pointsOf(const std::vector<Look>& looks) {
  Points points;
  for (const Look& look : looks) {
    for (const Eigen::Vector3d& vertex : look.mesh.vertices) {
      points.push_back(look.body_from_look * vertex);
    }
    if (dynamic_cast<const urdf::Mesh*>(look.geometry.get()) != nullptr) continue;
    append(spanOf(shapeOf(*look.geometry, look.body_from_look)), points);
  }
  return points;
}

class Shaper {
 public:
  explicit Shaper(ImportReport& report) : report_(report) {}

  void shapeBase(Body& base, BodyExtras& extras) {
    takeLooksIfBare(base, extras);
    if (!extras.collision_points.empty()) base.shapes.push_back(fitBox(extras.collision_points));
    dropInner(base);
    if (base.shapes.size() <= kMostShapesOfBase) return;
    base.shapes = {fitBox(spanOfAll(base))};
    remark(base, "has more than 6 shapes: simulated as one box around them.");
  }

  void shapeSegment(Body& body, BodyExtras& extras, bool is_last) {
    takeLooksIfBare(body, extras);
    if (!extras.collision_points.empty()) {
      body.shapes.push_back(fit(extras.collision_points, is_last));
    }
    dropInner(body);
    if (body.shapes.size() <= kMostShapesOfSegment) return;
    body.shapes = {fit(spanOfAll(body), is_last)};
    remark(body, "has more than 3 shapes: simulated as one capsule.");
  }

 private:
  // The last link's root is its joint, the origin of its frame.
  static Shape fit(const Points& points, bool is_last) {
    return is_last ? fitTip(points, Eigen::Vector3d::Zero()) : fitCapsule(points);
  }

  static Points spanOfAll(const Body& body) {
    Points points;
    for (const Shape& shape : body.shapes) append(spanOf(shape), points);
    return points;
  }

  void takeLooksIfBare(const Body& body, BodyExtras& extras) {
    if (extras.meshes > 0 && !extras.collision_points.empty()) {
      remark(body, "has a mesh to collide with: simulated as a shape fitted to it.");
    }
    if (!body.shapes.empty() || !extras.collision_points.empty()) return;
    extras.collision_points = pointsOf(extras.looks);
    if (extras.collision_points.empty()) return;
    remark(body, "has no collision shape: simulated as a shape fitted to what it looks like.");
  }

  void dropInner(Body& body) {
    std::vector<Shape> kept;
    for (std::size_t i = 0; i < body.shapes.size(); ++i) {
      bool is_inner = false;
      for (std::size_t j = 0; j < body.shapes.size() && !is_inner; ++j) {
        if (i == j || !isInside(body.shapes[i], body.shapes[j])) continue;
        // Of two that are inside each other the first stays.
        is_inner = j < i || !isInside(body.shapes[j], body.shapes[i]);
      }
      if (!is_inner) kept.push_back(body.shapes[i]);
    }
    if (kept.size() < body.shapes.size()) remark(body, "has shapes inside others: left out.");
    body.shapes = kept;
  }

  void remark(const Body& body, const std::string& sentence) {
    report_.remarks.add("shapes", {"link", body.name}, sentence);
  }

  ImportReport& report_;
};

// Shapes of one body, posed in the base.
std::vector<Shape> posed(const Body& body, const Eigen::Isometry3d& base_from_body) {
  std::vector<Shape> shapes = body.shapes;
  for (Shape& shape : shapes) shape.body_from_shape = base_from_body * shape.body_from_shape;
  return shapes;
}

struct Placed {
  std::size_t leg;
  Body* body;
  Eigen::Isometry3d base_from_body;
};

std::vector<Placed> segmentsInNeutralPose(RobotDescription& robot) {
  const auto poses = baseFromBodies(robot, robot.neutralPose());
  std::vector<Placed> placed;
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    for (Segment& segment : robot.legs[leg].segments) {
      placed.push_back({leg, &segment.body, poses[placed.size() + 1]});
    }
  }
  return placed;
}

// The pair of shapes of different legs that touch, or nullptrs.
std::pair<Shape*, Shape*> touching(const std::vector<Placed>& segments, double least_gap_m,
                                   std::pair<Body*, Body*>& of) {
  for (const Placed& a : segments) {
    for (const Placed& b : segments) {
      if (a.leg >= b.leg) continue;
      const auto first = posed(*a.body, a.base_from_body);
      const auto second = posed(*b.body, b.base_from_body);
      for (std::size_t i = 0; i < first.size(); ++i) {
        for (std::size_t j = 0; j < second.size(); ++j) {
          if (gap_m(first[i], second[j]) >= least_gap_m) continue;
          of = {a.body, b.body};
          return {&a.body->shapes[i], &b.body->shapes[j]};
        }
      }
    }
  }
  return {nullptr, nullptr};
}

}  // namespace

void shapeBodies(ImportedRobot& imported, ImportReport& report) {
  Shaper shaper(report);
  forEachBody(imported, [&](Body& body, BodyExtras& extras, bool is_last, bool is_base) {
    if (is_base) {
      shaper.shapeBase(body, extras);
    } else {
      shaper.shapeSegment(body, extras, is_last);
    }
  });
  guessShapes(imported, report);
  for (const Leg& leg : imported.robot.legs) {
    const bool has_shape = std::any_of(leg.segments.begin(), leg.segments.end(),
                                       [](const Segment& s) { return !s.body.shapes.empty(); });
    if (has_shape) continue;
    report.problems.add(report.source, {"leg", leg.segments.front().joint.name},
                        "has neither shape nor mass in any of its links; expected something to "
                        "stand on.");
  }
  if (imported.robot.base.shapes.empty()) {
    report.problems.add(report.source, {"link", imported.robot.base_link},
                        "has neither shape nor mass; expected a body, so that a fall is seen.");
  }
}

void separateLegs(ImportedRobot& imported, ImportReport& report) {
  constexpr double kLeastGap_m = 0.001;
  constexpr double kThinner = 0.85;
  constexpr double kThinnest_m = 0.006;
  const std::vector<Placed> segments = segmentsInNeutralPose(imported.robot);
  std::pair<Body*, Body*> of;
  for (auto pair = touching(segments, kLeastGap_m, of); pair.first != nullptr;
       pair = touching(segments, kLeastGap_m, of)) {
    for (const auto& [shape, body] : {std::pair{pair.first, of.first}, {pair.second, of.second}}) {
      report.remarks.add("shapes", {"link", body->name},
                         "touches another leg in the neutral pose: made thinner, or left out.");
      *shape = thinner(*shape, kThinner);
      if (thickness_m(*shape) > kThinnest_m) continue;
      if (body->shapes.size() == 1) {
        report.problems.add(report.source, {"link", body->name},
                            "touches another leg in the best stand that was found: check the "
                            "limits, or which axis points ahead (--forward).");
        return;
      }
      body->shapes.erase(body->shapes.begin() + (shape - body->shapes.data()));
    }
  }
}

}  // namespace hexapod
