#include "robot_import/guess_shapes.h"

#include <algorithm>
#include <vector>

#include "robot_import/fit_shape.h"

namespace hexapod {
namespace {

// Shapes of a robot whose meshes are not at hand, from its joints and masses alone.
class ShapeGuesser {
 public:
  ShapeGuesser(ImportedRobot& imported, ImportReport& report)
      : imported_(imported), report_(report) {}

  void guess() {
    const Body& base = imported_.robot.base;
    const bool is_known = base.mass_kg > 0.0 || imported_.extras[0].lost_meshes > 0;
    if (base.shapes.empty() && is_known) guessBase();
    std::size_t b = 1;
    for (Leg& leg : imported_.robot.legs) {
      const std::size_t first = b;
      b += leg.segments.size();
      guessLeg(leg, first);
    }
  }

 private:
  // A plate between the hips.
  void guessBase() {
    Body& base = imported_.robot.base;
    Points hips;
    for (const Leg& leg : imported_.robot.legs) {
      hips.push_back(leg.segments.front().joint.parent_from_joint.translation());
    }
    Shape plate = fitBox(hips);
    plate.size_m.z() = std::max(plate.size_m.z(), 0.15 * plate.size_m.maxCoeff());
    base.shapes.push_back(plate);
    remark(base);
  }

  // Rods from joint to joint, and on to where the last link must end; of a leg with some shapes
  // only where meshes are missing, and of a last link that its centre of mass tells to be a limb.
  void guessLeg(Leg& leg, std::size_t first) {
    const bool has_shape = std::any_of(leg.segments.begin(), leg.segments.end(),
                                       [](const Segment& s) { return !s.body.shapes.empty(); });
    const bool has_mass = std::any_of(leg.segments.begin(), leg.segments.end(),
                                      [](const Segment& s) { return s.body.mass_kg > 0.0; });
    double length_m = 0.0;
    for (std::size_t s = 1; s < leg.segments.size(); ++s) {
      length_m += leg.segments[s].joint.parent_from_joint.translation().norm();
    }
    const double radius_m = std::max(0.002, 0.05 * length_m);
    for (std::size_t s = 0; s < leg.segments.size(); ++s) {
      Body& body = leg.segments[s].body;
      const bool is_last = s + 1 == leg.segments.size();
      const bool is_limb = is_last && body.mass_kg > 0.0 && body.center_of_mass_m.norm() > radius_m;
      const bool is_guessed =
          imported_.extras[first + s].lost_meshes > 0 || (!has_shape && has_mass) || is_limb;
      if (!body.shapes.empty() || !is_guessed) continue;
      const Eigen::Vector3d end = is_last
                                      ? tipOf(leg.segments, imported_.extras[first + s])
                                      : leg.segments[s + 1].joint.parent_from_joint.translation();
      if (end.norm() < 2.0 * radius_m) continue;
      body.shapes.push_back(rod(end, radius_m));
      remark(body);
    }
  }

  // Of the last segment: the farthest frame that is fixed to it, or twice as far as its centre of
  // mass; where there is neither, as far and in the same direction as the joint on the link before.
  Eigen::Vector3d tipOf(const std::vector<Segment>& segments, const BodyExtras& extras) {
    const Body& body = segments.back().body;
    Eigen::Vector3d tip = 2.0 * body.center_of_mass_m;
    double farthest_m = body.center_of_mass_m.norm();
    for (const Frame& frame : extras.frames) {
      const Eigen::Vector3d at = frame.body_from_link.translation();
      if (at.norm() <= farthest_m) continue;
      farthest_m = at.norm();
      tip = at;
    }
    if (farthest_m > 0.0 || segments.size() < 2) return tip;
    report_.remarks.add("shapes", {"link", body.name},
                        "has nothing that tells where it ends: taken as long as the link before "
                        "it. What is learned depends on that: find its mesh.");
    return segments.back().joint.parent_from_joint.translation();
  }

  void remark(const Body& body) {
    report_.remarks.add("shapes", {"link", body.name},
                        "has no shape that could be read: guessed from the joints, from the frames "
                        "fixed to it and its centre of mass. Check the picture.");
  }

  ImportedRobot& imported_;
  ImportReport& report_;
};

}  // namespace

void guessShapes(ImportedRobot& imported, ImportReport& report) {
  ShapeGuesser(imported, report).guess();
}

}  // namespace hexapod
