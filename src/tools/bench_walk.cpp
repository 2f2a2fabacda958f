// Walks to goals in the core with bodies that are otherwise than the one learned with.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "common/options_help.h"
#include "geometry/pose2.h"
#include "repertoire/repertoire_file.h"
#include "robot/load_robot.h"
#include "tools/command_line.h"
#include "tools/machine.h"
#include "tools/package_files.h"
#include "tools/walk_bodies.h"
#include "tools/walk_campaign.h"

namespace hexapod {
namespace {

struct BenchWalkOptions {
  CampaignOptions campaign;
  std::string file;
  std::string bodies = "all";
  std::string adaptations = "none, self_model, told";
  std::string write;
  std::string urdf = packageFolder() + "/urdf/hexapod.urdf";
  std::string robot_config = packageFolder() + "/config/hexapod.yaml";
  bool help = false;
};

std::vector<Option> declareOptions(BenchWalkOptions& options) {
  std::vector<Option> all = declareOptions(options.campaign);
  const std::vector<Option> others = {
      option("file", options.file, "The repertoire that is walked with."),
      option(
          "bodies", options.bodies,
          "Bodies with semicolons between them, as in 'intact; left_middle: limp, friction: 0.7'; "
          "all: those that the package is judged by."),
      option("adaptations", options.adaptations,
             "Comma separated: none, deviation, self_model, told, relearned."),
      option("write", options.write, "Markdown file to write the table to."),
      option("urdf", options.urdf, "Robot description."),
      option("robot_config", options.robot_config, "What the robot needs beside its URDF."),
      option("help", options.help, "Print this text.")};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::string textOf(const CampaignRow& row, const std::string& body, const std::string& adaptation) {
  char text[320];
  std::snprintf(
      text, sizeof text,
      "| %s | %s | %lld of %lld | %.2f | %lld | %lld | %lld | %lld | %.1f | %.2f | %.1f | "
      "%.1f | %.0f | %.0f |\n",
      body.c_str(), adaptation.c_str(), static_cast<long long>(row.arrived),
      static_cast<long long>(row.goals), row.behaviors, static_cast<long long>(row.given_up),
      static_cast<long long>(row.no_plan), static_cast<long long>(row.fell),
      static_cast<long long>(row.touched), 1e3 * row.off_m, row.off_rad / kDegree,
      100.0 * row.right_after_first, 100.0 * row.false_alarms, 1e3 * row.thought_s,
      1e3 * row.most_thought_s);
  return text;
}

constexpr const char* kHeading =
    "| body | adaptation | arrived | behaviours per goal | given up | no plan | fell | legs "
    "touched "
    "| prediction off, median [mm] | [deg] | legs right after the first [%] | false alarms [%] | "
    "thought "
    "per behaviour, one core: median [ms] | p95 [ms] |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";

int benchWalk(const std::vector<std::string>& words) {
  BenchWalkOptions options;
  applyOptions(declareOptions(options), valuesFromCommandLine(words, declareOptions(options)),
               kCommandLine);
  if (options.help || options.file.empty()) {
    std::cout << helpOn("usage: bench_walk --file FILE.db [--name value ...]\n",
                        declareOptions(options));
    return options.help ? 0 : 2;
  }
  const RobotDescription robot = loadRobot(options.urdf, options.robot_config);
  const Repertoire repertoire = loadRepertoire(options.file);
  if (robot.digest != repertoire.robot_id) {
    throw std::runtime_error("The repertoire was learned for another robot than that of " +
                             options.urdf + "; name its files with --urdf and --robot_config.");
  }
  std::ostringstream table;
  table << kHeading;
  std::cout << kHeading << std::flush;
  for (const TrueBody& body : bodiesFromText(robot, options.bodies)) {
    for (const std::string& name : splitList(options.adaptations)) {
      const double start_s = wall_s();
      const CampaignRow row = summarize(
          walkToGoals(robot, repertoire, body, adaptationFromText(name), options.campaign));
      const std::string line = textOf(row, body.name, name);
      table << line;
      std::cout << line << std::flush;
      std::cerr << row.goals / (wall_s() - start_s) * 60.0 << " goals per minute\n";
    }
  }
  if (options.write.empty()) return 0;
  std::ofstream(options.write) << table.str();
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  try {
    return hexapod::benchWalk({argv + 1, argv + argc});
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\nbench_walk --help lists the options.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
