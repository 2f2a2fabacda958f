// Plays entries of a repertoire one after another and prints how body and legs move, as JSON.
#include <algorithm>
#include <exception>
#include <iostream>
#include <iterator>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "common/options_help.h"
#include "common/text.h"
#include "geometry/pose2.h"
#include "repertoire/repertoire_file.h"
#include "robot/load_robot.h"
#include "self_model/learned_world.h"
#include "simulation/foot.h"
#include "simulation/kinematics.h"
#include "simulation/recording.h"
#include "tools/command_line.h"
#include "tools/package_files.h"

namespace hexapod {
namespace {

constexpr const char* kUsage =
    "usage: record_entries FILE.db --entries 3,17,3 [--name value ...]\n\n"
    "Prints as JSON, for every command of those behaviours: the joints of each leg from body to "
    "foot [m], and whether the foot stands.\n";

struct RecordOptions {
  std::string entries;
  std::string engine = "reduced";
  std::string urdf = packageFolder() + "/urdf/hexapod.urdf";
  std::string robot_config = packageFolder() + "/config/hexapod.yaml";
};

std::vector<Option> declareOptions(RecordOptions& options) {
  return {option("entries", options.entries, "Ids of the entries, with commas between them."),
          option("engine", options.engine, "Simulation engine.", engineNames()),
          option("urdf", options.urdf, "Robot description."),
          option("robot_config", options.robot_config, "What the robot needs beside its URDF.")};
}

std::vector<Entry> chosenEntries(const Repertoire& repertoire, const std::string& ids) {
  std::vector<Entry> chosen;
  std::istringstream words(ids);
  for (std::string word; std::getline(words, word, ',');) {
    const auto id = integerFromText(word);
    const auto found =
        std::find_if(repertoire.entries.begin(), repertoire.entries.end(),
                     [&](const Entry& entry) { return id.has_value() && entry.id == *id; });
    if (found == repertoire.entries.end()) {
      throw std::invalid_argument("The repertoire has no entry '" + word + "'; it has " +
                                  std::to_string(repertoire.entries.size()) +
                                  " entries, which repertoire_csv lists.");
    }
    chosen.push_back(*found);
  }
  if (chosen.empty()) throw std::invalid_argument("No entry is named; expected --entries 3,17,3.");
  return chosen;
}

void print(std::ostream& out, const Eigen::Vector3d& point) {
  out << "[" << point.x() << "," << point.y() << "," << point.z() << "]";
}

/// {"legs": [[joints of the first leg, and its foot], ..], "stands": [true, ..]}
void print(std::ostream& out, const RobotDescription& robot, RecordedPose pose,
           const Eigen::Isometry3d& world_from_frame) {
  pose.world_from_base = world_from_frame * pose.world_from_base;
  const std::vector<Eigen::Isometry3d> base_from_bodies = baseFromBodies(robot, pose.angles_rad);
  const std::vector<Foot> feet = feetOf(robot, pose);
  const double standing_m = standingFootHeight(robot);
  std::ostringstream stands;
  std::size_t body = 1;
  out << "{\"legs\":[";
  for (std::size_t i = 0; i < robot.legs.size(); ++i) {
    out << (i == 0 ? "[" : ",[");
    for (std::size_t k = 0; k < robot.legs[i].segments.size(); ++k) {
      print(out, pose.world_from_base * base_from_bodies[body++].translation());
      out << ",";
    }
    print(out, feet[i].place);
    out << "]";
    stands << (i == 0 ? "" : ",") << (feet[i].height_m < standing_m ? "true" : "false");
  }
  out << "],\"stands\":[" << stands.str() << "]}";
}

void print(std::ostream& out, const Pose2& pose) {
  out << "[" << pose.x_m << "," << pose.y_m << "," << pose.yaw_rad << "]";
}

void printHeader(std::ostream& out, const RobotDescription& robot, double period_s) {
  out << "{\"period_s\":" << period_s << ",\"legs\":[";
  for (std::size_t i = 0; i < robot.legs.size(); ++i) {
    out << (i == 0 ? "\"" : ",\"") << robot.legs[i].name << "\"";
  }
  out << "],\"behaviours\":[";
}

/// One behaviour from `world_from_start` on; returns where it ended.
Pose2 print(std::ostream& out, const RobotDescription& robot, const Entry& entry,
            const Recording& recording, const Pose2& world_from_start) {
  const Pose2 world_from_frame = world_from_start * inverse(recording.world_from_start);
  out << "{\"id\":" << entry.id << ",\"start\":";
  print(out, world_from_start);
  out << ",\"predicted\":";
  print(out, world_from_start * entry.expectedPose());
  out << ",\"frames\":[";
  for (std::size_t k = 0; k < recording.poses.size(); ++k) {
    out << (k == 0 ? "" : ",");
    print(out, robot, recording.poses[k], inSpace(world_from_frame));
  }
  const Pose2 end = recording.poses.empty()
                        ? world_from_start
                        : world_from_frame * footprint(recording.poses.back().world_from_base);
  out << "],\"end\":";
  print(out, end);
  out << "}";
  return end;
}

/// Each from the settled stand, put where the one before ended.
void print(std::ostream& out, const Repertoire& repertoire, const RecordOptions& options) {
  const RobotDescription robot = loadRobot(options.urdf, options.robot_config);
  if (robot.digest != repertoire.robot_id) {
    throw std::invalid_argument("The repertoire was learned for another robot than that of " +
                                options.urdf + "; name its files with --urdf and --robot_config.");
  }
  const LearnedWorld learned = learnedWorldOf(robot, repertoire);
  const auto world = makeWorld(chooseEngine(options.engine, robot).engine, robot, learned.physics);
  const double period_s = learned.behavior.command_period_s;
  printHeader(out, robot, period_s);
  Pose2 world_from_start;
  bool is_first = true;
  for (const Entry& entry : chosenEntries(repertoire, options.entries)) {
    const Behavior behavior(robot, entry.genome, learned.behavior);
    out << (is_first ? "\n" : ",\n");
    world_from_start =
        print(out, robot, entry, record(*world, behavior, period_s), world_from_start);
    is_first = false;
  }
  out << "]}\n";
}

RecordOptions optionsFrom(const std::vector<std::string>& words) {
  RecordOptions options;
  applyOptions(declareOptions(options), valuesFromCommandLine(words, declareOptions(options)),
               kCommandLine);
  return options;
}

int run(const std::vector<std::string>& words) {
  if (words.empty() || words[0].rfind('-', 0) == 0) {
    RecordOptions options;
    std::cerr << helpOn(kUsage, declareOptions(options));
    return 2;
  }
  try {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(5);
    print(out, loadRepertoire(words[0]), optionsFrom({words.begin() + 1, words.end()}));
    std::cout << out.str() << std::flush;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return std::cout ? 0 : 1;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) { return hexapod::run({argv + 1, argv + argc}); }
