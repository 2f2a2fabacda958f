// Learns a repertoire of gaits in simulation, without ROS, alone or with others under mpirun.
#include <chrono>
#include <csignal>
#include <exception>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "learning/learning_session.h"
#include "learning/worker.h"
#include "repertoire/repertoire_csv.h"
#include "robot/load_robot.h"
#include "tools/evolve_options.h"
#include "tools/progress_display.h"
#include "tools/ranks.h"
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

void sayUnlessEmpty(ProgressDisplay& display, const std::string& sentence) {
  if (!sentence.empty()) display.say(sentence);
}

int learn(const EvolveOptions& options, SignalWatch& signals, Ranks& ranks) {
  auto display_options = ProgressDisplay::forStandardOutput(options.progress_period_s);
  // mpirun gives its processes terminals of their own, whatever its output is.
  if (ranks.count() > 1) display_options.is_terminal = false;
  ProgressDisplay display(std::cout, display_options);
  const RobotDescription robot = loadRobot(options.urdf, options.robot_config);
  for (const std::string& remark : robot.remarks) display.say(remark);
  LearningSession session(robot, options.learn, now, ranks.workers());
  signals.start([&session] { session.requestStop(); });
  display.say("Learning run " + session.repertoire().run_id + " into " +
              options.learn.repertoire_file + ".");
  if (ranks.count() > 1) {
    display.say(std::to_string(ranks.count()) + " processes share the work.");
  }
  sayUnlessEmpty(display, session.resumeRemark());
  sayUnlessEmpty(display, session.engineRemark());
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& running) { display.show(running.status(), now()); };
  hooks.save_failed = [&](const std::string& problem) { display.complain(problem, now()); };
  const bool finished = session.run(hooks);
  sayUnlessEmpty(display, session.verificationRemark());
  if (!ranks.loss().empty()) {
    display.say(ranks.loss() + " What was learned before is saved; --resume goes on.");
    ranks.abort(1);
  }
  if (!finished) display.say("Stopped and saved; --resume goes on.");
  if (!options.csv.empty()) writeCsv(session.repertoire(), options.csv);
  return 0;
}

EvolveOptions optionsFor(const std::vector<std::string>& arguments, const Ranks& ranks) {
  EvolveOptions options = evolveOptionsFrom(arguments);
  if (options.learn.threads == 0) options.learn.threads = ranks.coresPerProcess();
  return options;
}

/// What all processes but the first do. Problems are told by the first.
void work(const std::vector<std::string>& arguments, Ranks& ranks) {
  const std::shared_ptr<Channel> master = ranks.master();
  try {
    const EvolveOptions options = optionsFor(arguments, ranks);
    if (options.help) return;
    workFor(*master, loadRobot(options.urdf, options.robot_config), options.learn);
  } catch (const std::exception& error) {
    declineWork(*master, error.what());
  }
}

int evolve(int argc, char** argv) {
  // Nobody reading what it prints is no reason to stop learning.
  std::signal(SIGPIPE, SIG_IGN);
  SignalWatch signals;
  const std::unique_ptr<Ranks> ranks = joinRanks(argc, argv);
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (ranks->rank() > 0) {
    work(arguments, *ranks);
    return 0;
  }
  const EvolveOptions options = optionsFor(arguments, *ranks);
  if (!options.help) return learn(options, signals, *ranks);
  std::cout << evolveHelp();
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  try {
    return hexapod::evolve(argc, argv);
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\nevolve --help lists the options.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
