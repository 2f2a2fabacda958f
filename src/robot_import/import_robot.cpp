#include "robot_import/import_robot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/text.h"
#include "gait/behavior_options.h"
#include "gait/symmetry.h"
#include "geometry/pose2.h"
#include "robot/dimensions.h"
#include "robot/load_robot.h"
#include "robot/urdf_bodies.h"
#include "robot_import/build_bodies.h"
#include "robot_import/choose_gait.h"
#include "robot_import/find_linkages.h"
#include "robot_import/fit_shape.h"
#include "robot_import/name_legs.h"
#include "robot_import/repair_masses.h"
#include "robot_import/shape_bodies.h"
#include "robot_import/write_robot.h"
#include "simulation/world.h"

namespace hexapod {
namespace {

constexpr int kMostGaitsInOde = 40;  // which take as long
// Strokes that are tried, and the share of gaits that has to walk for the first that does. Legs
// that touch are avoided by evolution once and for all; a robot that falls often also falls when it
// is pushed.
constexpr double kScales[] = {1.0, 0.75, 0.55, 0.4};
constexpr double kEnoughWalk = 0.12;
constexpr double kMostFall = 0.5;
constexpr double kFewWalk = 0.1;
constexpr double kMostTilt_rad = 0.2;
// Of the reach: gaits that lead less far than this lead nowhere.
constexpr double kLeastWay = 0.01;
constexpr double kLongestReach_m = 5.0;

// Which shape or joint reaches farthest from its link, where lengths are mixed up.
std::string farthestOf(const RobotDescription& robot) {
  double farthest_m = 0.0;
  std::string what;
  const auto look = [&](double far_m, const std::string& words) {
    if (far_m > farthest_m) farthest_m = far_m, what = words;
  };
  for (const Leg& leg : robot.legs) {
    for (const auto& [joint, body] : leg.segments) {
      look(joint.parent_from_joint.translation().norm(), "the origin of joint " + joint.name);
      for (const Shape& shape : body.shapes) {
        for (const Eigen::Vector3d& core : corePoints(shape)) {
          look(core.norm() + roundness_m(shape), "a shape of link " + body.name);
        }
      }
    }
  }
  return "Farthest is " + what + ", " + numberText(std::round(farthest_m)) + " m.";
}

void refuseOtherUnits(const ImportedRobot& imported, ImportReport& report) {
  const double reach_m = legReach_m(imported.robot);
  if (reach_m <= kLongestReach_m) return;
  report.problems.add(report.source, "has legs that reach " + numberText(std::round(reach_m)) +
                                         " m. Are its lengths in millimetres? Expected metres. " +
                                         farthestOf(imported.robot));
}

ImportedRobot read(const ImportRequest& request, ImportReport& report) {
  report.source = request.urdf_name;
  const auto model = parseUrdf(request.urdf_text, request.urdf_name, report.problems);
  report.problems.throwIfAny();
  const MeshFiles files(request.urdf_folder, request.mesh_path);
  const urdf::LinkSharedPtr base = findBaseLink(*model, report);
  const std::vector<JointChain> legs = findLegs(*model, base, report);
  report.problems.throwIfAny();
  ImportedRobot imported = buildBodies(*model, base, legs, files, report);
  if (request.forward.empty()) {
    guessForward(imported);
  } else {
    imported.forward = request.forward;
    imported.forward_reason = "its owner";
  }
  nameLegs(imported);
  shapeBodies(imported, report);
  refuseOtherUnits(imported, report);
  report.problems.throwIfAny();
  remarkLinkages(imported, report);
  repairMasses(imported, report);
  return imported;
}

// One try at a gait, as far as its simulation.
ImportResult tried(ImportedRobot imported, double scale, const ImportRequest& request,
                   ImportReport report) {
  chooseGait(imported, scale, report);
  report.problems.throwIfAny();
  separateLegs(imported, report);
  report.problems.throwIfAny();
  ImportResult result;
  result.urdf = urdfOf(imported, request.urdf_name);
  result.yaml = yamlOf(imported, request.urdf_name);
  result.robot = parseRobot(result.urdf, result.yaml, imported.robot.name + ".urdf",
                            imported.robot.name + ".yaml");
  result.imported = std::move(imported);
  result.remarks = report.remarks.sentences();
  result.standing = checkStanding(result.robot);
  if (!result.standing.failure.empty()) return result;
  const bool is_fast = chooseEngine(toString(Engine::kReduced), result.robot).remark.empty();
  result.gaits = checkRandomGaits(
      result.robot, is_fast ? request.gaits : std::min(request.gaits, kMostGaitsInOde));
  return result;
}

double walkingShare(const ImportResult& result) {
  if (result.gaits.gaits == 0) return 0.0;
  return static_cast<double>(result.gaits.walked()) / result.gaits.gaits;
}

double fallingShare(const ImportResult& result) {
  if (result.gaits.gaits == 0) return 1.0;
  return static_cast<double>(result.gaits.fell) / result.gaits.gaits;
}

// Links that the robot must not stand on.
std::vector<std::string> wronglyOnFloor(const ImportResult& result) {
  std::vector<std::string> names;
  for (const std::string& name : result.standing.on_floor) {
    const bool is_foot =
        std::any_of(result.robot.legs.begin(), result.robot.legs.end(),
                    [&](const Leg& leg) { return leg.segments.back().body.name == name; });
    if (!is_foot) names.push_back(name);
  }
  return names;
}

std::string percent(double share) {
  return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " %";
}

std::string line(const char* format, double a, double b = 0.0, double c = 0.0) {
  char text[256];
  std::snprintf(text, sizeof(text), format, a, b, c);
  return text;
}

std::string toChange(const ImportResult& result) {
  if (!result.standing.failure.empty()) return result.standing.failure;
  if (result.standing.tilt_rad > kMostTilt_rad) {
    return "it leans by " + numberText(std::round(result.standing.tilt_rad / kDegree)) +
           " degrees when it stands: check masses, centres of mass and efforts in the URDF, or the "
           "neutral angles in the YAML.";
  }
  const std::vector<std::string> on_floor = wronglyOnFloor(result);
  if (!on_floor.empty()) {
    return "it stands on " + namesText(on_floor) +
           ", too: check the neutral angles in the YAML, or the efforts if it sinks down.";
  }
  if (walkingShare(result) < kFewWalk) {
    return "only " + percent(walkingShare(result)) +
           " of random gaits walk: give the joints in the "
           "YAML smaller amplitudes or a lower stand.";
  }
  if (result.gaits.median_way_m < kLeastWay * legReach_m(result.robot)) {
    return line("random gaits lead nowhere, %.2g m in the median: ", result.gaits.median_way_m) +
           "check limits and velocities of the joints, and the amplitudes in the YAML.";
  }
  return "";
}

// What the learner's own options do not suit.
std::vector<std::string> hintsFor(const ImportResult& result) {
  constexpr double kMostShift = 0.1;  // of the reach
  const BehaviorOptions usual;
  std::vector<std::string> hints;
  if (result.gaits.median_shift_m > kMostShift * legReach_m(result.robot)) {
    hints.push_back("That is more than a tenth of the reach: learn with step_s 0.005.");
  }
  const double late_s =
      result.gaits.back_to_neutral_s - usual.return_duration_s - usual.rest_duration_s;
  if (late_s > 0.0) {
    const double commands = std::ceil(late_s / usual.command_period_s - 1e-9);
    hints.push_back(line("That is after the end of a behaviour: learn with rest_duration_s %.2f.",
                         usual.rest_duration_s + commands * usual.command_period_s));
  }
  return hints;
}

}  // namespace

ImportResult importRobot(const ImportRequest& request) {
  ImportReport report;
  const ImportedRobot imported = read(request, report);
  ImportResult best;
  double best_share = -1.0;
  for (const double scale : kScales) {
    ImportResult result = tried(imported, scale, request, report);
    const double share = walkingShare(result);
    if (share > best_share) {
      best_share = share;
      best = std::move(result);
      if (scale < 1.0) {
        best.remarks.push_back(
            line("gait: most random gaits fall, or legs touch, with wide strokes: strokes and "
                 "lifts are %.2f of the usual.",
                 scale));
      }
    }
    if (best_share >= kEnoughWalk && fallingShare(best) <= kMostFall) break;
  }
  best.not_mirrored = whyNotMirrored(best.robot);
  best.to_change = toChange(best);
  return best;
}

std::string reportOf(const ImportResult& result) {
  const RobotDescription& robot = result.robot;
  std::string text;
  const auto say = [&](const std::string& sentence) { text += sentence + "\n"; };
  say(robot.name + ": " + std::to_string(robot.legs.size()) + " legs, " +
      std::to_string(robot.jointCount()) + " joints, " +
      line("%.3g kg, legs reach %.3g m; forward is ", totalMass_kg(robot), legReach_m(robot)) +
      result.imported.forward + " of " + robot.base_link + ", by " +
      result.imported.forward_reason + ".");
  for (const std::string& remark : result.remarks) say("  " + remark);
  say("Feet move, in cm forward, left, up (signals at -1 .. 1):");
  for (const Leg& leg : robot.legs) say("  " + footWay(leg));
  if (result.standing.failure.empty()) {
    say(line("Stands %.3g m high, leaning %.1f degrees, joints sagging by at most %.1f degrees,",
             result.standing.height_m, result.standing.tilt_rad / kDegree,
             result.standing.sag_rad / kDegree));
    say(line("  with %.0f %% of the torque of the most loaded joint, on ",
             100.0 * result.standing.torque_share) +
        namesText(result.standing.on_floor) + ".");
  }
  say(result.not_mirrored.empty() ? "Left and right are mirror images."
                                  : "Left and right are no mirror images: " + result.not_mirrored +
                                        ". It will learn without their help.");
  const RandomGaitsCheck& gaits = result.gaits;
  if (gaits.gaits > 0) {
    say("Of " + std::to_string(gaits.gaits) + " random gaits " + percent(walkingShare(result)) +
        " walk (" + std::to_string(gaits.fell) + " fell, " + std::to_string(gaits.self_collided) +
        " touched a leg with another, " + std::to_string(gaits.diverged) + " blew up), " +
        line("%.3g m in the median, %.3g m at most;", gaits.median_way_m, gaits.largest_way_m));
    say(
        line("  ends shift by %.1f mm between steps of 15 and 5 ms; joints are back %.2f s after a "
             "gait.",
             1e3 * gaits.median_shift_m, gaits.back_to_neutral_s));
    for (const std::string& hint : hintsFor(result)) say("  " + hint);
    say("Engine " + gaits.engine +
        line(", %.0f gaits per second and core here.", gaits.evaluations_per_s) +
        (gaits.engine_remark.empty() ? "" : " " + gaits.engine_remark));
  }
  say(result.to_change.empty() ? "Ready to learn." : "Not yet: " + result.to_change);
  return text;
}

}  // namespace hexapod
