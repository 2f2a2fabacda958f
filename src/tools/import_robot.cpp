// Makes of somebody's URDF the two files that learner and executor need, and tries them.
#include "robot_import/import_robot.h"

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "common/options_help.h"
#include "robot_import/picture_data.h"
#include "tools/command_line.h"
#include "tools/text_file.h"

namespace hexapod {
namespace {

struct Arguments {
  bool help = false;
  std::string urdf;
  std::string source;
  std::string mesh_path;
  std::string forward;
  std::string output = ".";
};

std::vector<Option> declareOptions(Arguments& arguments) {
  return {
      option("help", arguments.help, "Print this text."),
      option("urdf", arguments.urdf, "URDF of the robot; the first word may be it."),
      option("source", arguments.source,
             "File that the URDF was made from, whose folder relative meshes start in; empty: the "
             "URDF itself."),
      option("mesh_path", arguments.mesh_path,
             "Folder of the meshes, or of the packages that package:// names."),
      option("forward", arguments.forward,
             "Axis of the base link that points ahead: x, y, -x or -y; empty: guessed."),
      option("output", arguments.output, "Folder that the two files are written to."),
  };
}

Arguments argumentsFrom(std::vector<std::string> words) {
  Arguments arguments;
  if (!words.empty() && words.front().rfind("--", 0) != 0) {
    arguments.urdf = words.front();
    words.erase(words.begin());
  }
  applyOptions(declareOptions(arguments),
               valuesFromCommandLine(words, declareOptions(arguments), {}), kCommandLine);
  if (arguments.help) return arguments;
  if (arguments.urdf.empty()) {
    throw std::invalid_argument(kCommandLine + ": give the robot's URDF, e.g. my.urdf.");
  }
  const std::string& axis = arguments.forward;
  if (!axis.empty() && axis != "x" && axis != "y" && axis != "-x" && axis != "-y") {
    throw std::invalid_argument(kCommandLine + ": forward is '" + axis +
                                "', expected x, y, -x or -y.");
  }
  return arguments;
}

// A robot's name as a file's.
std::string fileName(std::string name) {
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  }
  return name.empty() ? "robot" : name;
}

int runImport(const Arguments& arguments) {
  const std::string source = arguments.source.empty() ? arguments.urdf : arguments.source;
  ImportRequest request;
  request.urdf_text = textOfFile(arguments.urdf);
  request.urdf_name = source;
  request.urdf_folder = std::filesystem::absolute(source).parent_path().string();
  request.mesh_path = arguments.mesh_path;
  request.forward = arguments.forward;
  const ImportResult result = importRobot(request);
  std::filesystem::create_directories(arguments.output);
  const std::filesystem::path stem =
      std::filesystem::path(arguments.output) / fileName(result.robot.name);
  writeTextFile(stem.string() + ".urdf", result.urdf);
  writeTextFile(stem.string() + ".yaml", result.yaml);
  writeTextFile(stem.string() + ".json", pictureData(result));
  std::cout << reportOf(result) << "Wrote " << stem.string() << ".urdf and .yaml.\n";
  return result.to_change.empty() ? 0 : 3;
}

std::string help() {
  Arguments arguments;
  return helpOn(
      "usage: import_robot my.urdf [--name value ...]\n"
      "\n"
      "Writes NAME.urdf and NAME.yaml for the learner, says what was changed and how the robot "
      "stands and walks. Exit code 3: written, but not ready to learn.\n",
      declareOptions(arguments));
}

int run(const std::vector<std::string>& words) {
  const Arguments arguments = argumentsFrom(words);
  if (!arguments.help) return runImport(arguments);
  std::cout << help();
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  try {
    return hexapod::run({argv + 1, argv + argc});
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\nimport_robot --help lists the options.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
