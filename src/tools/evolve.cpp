// Learns a repertoire of gaits in simulation, without ROS.
#include <chrono>
#include <csignal>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "learning/learning_session.h"
#include "repertoire/repertoire_csv.h"
#include "robot/load_robot.h"
#include "tools/evolve_options.h"
#include "tools/progress_display.h"
#include "tools/signal_watch.h"

namespace hexapod {
namespace {

double now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(time).count();
}

void writeCsv(const Repertoire& repertoire, const std::string& file) {
  std::ofstream stream(file);
  exportCsv(repertoire, stream);
  stream.close();
  if (stream) return;
  throw std::runtime_error("The file " + file +
                           " cannot be written. The repertoire itself is saved: repertoire_csv "
                           "exports it.");
}

int learn(const EvolveOptions& options, SignalWatch& signals) {
  ProgressDisplay display(std::cout, ProgressDisplay::forStandardOutput(options.progress_period_s));
  LearningSession session(loadRobot(options.urdf, options.robot_config), options.learn, now);
  signals.start([&session] { session.requestStop(); });
  display.say("Learning run " + session.repertoire().run_id + " into " +
              options.learn.repertoire_file + ".");
  for (const std::string& remark : {session.resumeRemark(), session.engineRemark()}) {
    if (!remark.empty()) display.say(remark);
  }
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& running) { display.show(running.status(), now()); };
  hooks.save_failed = [&](const std::string& problem) { display.complain(problem, now()); };
  if (!session.run(hooks)) display.say("Stopped and saved; --resume goes on.");
  if (!options.csv.empty()) writeCsv(session.repertoire(), options.csv);
  return 0;
}

int evolve(const std::vector<std::string>& arguments) {
  const EvolveOptions options = evolveOptionsFrom(arguments);
  if (options.help) {
    std::cout << evolveHelp();
    return 0;
  }
  // Nobody reading what it prints is no reason to stop learning.
  std::signal(SIGPIPE, SIG_IGN);
  SignalWatch signals;
  return learn(options, signals);
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  try {
    return hexapod::evolve({argv + 1, argv + argc});
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\nevolve --help lists the options.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
