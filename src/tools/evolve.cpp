// Learns a repertoire of gaits in simulation, without ROS, alone or with others under mpirun.
#include <atomic>
#include <chrono>
#include <csignal>
#include <exception>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>

#include "learning/learning_session.h"
#include "learning/progress_display.h"
#include "learning/worker.h"
#include "repertoire/repertoire_csv.h"
#include "robot/load_robot.h"
#include "tools/evolve_options.h"
#include "tools/ranks.h"
#include "tools/same_file.h"
#include "tools/signal_watch.h"

namespace hexapod {
namespace {

// A save that failed is tried so often more before the program ends.
constexpr int kLastTries = 10;
constexpr std::chrono::milliseconds kRetryPeriod{500};

double now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(time).count();
}

void writeCsv(const Repertoire& repertoire, const std::string& repertoire_file,
              const std::string& file) {
  // It may have become a link to it meanwhile.
  const bool is_safe = !isSameFile(file, repertoire_file);
  std::ofstream stream(is_safe ? file : "");
  exportCsv(repertoire, stream);
  stream.close();
  if (stream) return;
  throw std::runtime_error("The file " + file +
                           " cannot be written. The repertoire itself is saved: repertoire_csv "
                           "exports it.");
}

/// Tries again what could not be saved, for some seconds. Returns why it still is not, or nothing.
std::string retrySaving(LearningSession& session) {
  std::string problem = session.saveProblem();
  for (int tries = 0; tries < kLastTries && !problem.empty(); ++tries) {
    std::this_thread::sleep_for(kRetryPeriod);
    problem = session.saveNow();
  }
  return problem;
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
  const std::string body = session.repertoire().body();
  display.say("Learning run " + session.repertoire().run_id + " into " +
              options.learn.repertoire_file +
              (body.empty() ? "." : ", for this body: " + body + "."));
  if (ranks.count() > 1) {
    display.say(std::to_string(ranks.count()) + " processes share the work.");
  }
  sayUnlessEmpty(display, session.startRemark());
  sayUnlessEmpty(display, session.engineRemark());
  LearningSession::Hooks hooks;
  hooks.progress = [&](const LearningSession& running) { display.show(running.status(), now()); };
  hooks.save_failed = [&](const std::string& problem) { display.complain(problem, now()); };
  hooks.tried = [&](const std::string& sentence) { display.say(sentence); };
  const bool finished = session.run(hooks);
  sayUnlessEmpty(display, session.verificationRemark());
  const std::string problem = retrySaving(session);
  const std::string loss = ranks.loss();
  if (!loss.empty()) display.say(loss + " The others did its share.");
  if (!finished && problem.empty()) display.say("Stopped and saved; --resume goes on.");
  if (!problem.empty()) display.say("ERROR: " + problem + " What was learned since is lost.");
  if (problem.empty() && !options.csv.empty()) {
    writeCsv(session.repertoire(), options.learn.repertoire_file, options.csv);
  }
  const int exit_code = problem.empty() ? 0 : 1;
  // A process that hangs would keep this one waiting for the end in order.
  if (!loss.empty()) ranks.abort(exit_code);
  return exit_code;
}

EvolveOptions optionsFor(const std::vector<std::string>& arguments, const Ranks& ranks) {
  EvolveOptions options = evolveOptionsFrom(arguments);
  if (options.learn.threads == 0) options.learn.threads = ranks.coresPerProcess();
  return options;
}

/// What all processes but the first do. Problems are told by the first. Asked to stop, it stops
/// the run: mpirun asks all, in any order.
void work(const std::vector<std::string>& arguments, SignalWatch& signals, Ranks& ranks) {
  const std::shared_ptr<Channel> master = ranks.master();
  const auto cancelled = std::make_shared<std::atomic<bool>>(false);
  signals.start([cancelled] { *cancelled = true; });
  try {
    const EvolveOptions options = optionsFor(arguments, ranks);
    if (options.help) return;
    workFor(*master, loadRobot(options.urdf, options.robot_config), options.learn, *cancelled);
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
    work(arguments, signals, *ranks);
    return 0;
  }
  const EvolveOptions options = optionsFor(arguments, *ranks);
  if (options.help) {
    std::cout << evolveHelp(options);
    return 0;
  }
  try {
    return learn(options, signals, *ranks);
  } catch (const std::exception& error) {
    if (ranks->loss().empty()) throw;
    std::cerr << error.what() << "\n";
    ranks->abort(1);
    return 1;
  }
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
