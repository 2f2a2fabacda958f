#include "ros_interface/common/node_process.h"

#include <pthread.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/param.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace hexapod {
namespace {

constexpr std::chrono::milliseconds kPoll{50};
constexpr int kPollsPerWarning = 60;
// With the poll before it, and the end of a process on a busy machine, 2 s.
constexpr std::chrono::milliseconds kLongestEnd{1300};

std::atomic<bool> leave{false};
std::atomic<bool> saves{false};  // has work to save
std::atomic<bool> done{false};   // the body's work
std::atomic<int> exit_code{0};

// SIGHUP too, unless the process was started to ignore it (by nohup). What a script starts in its
// background ignores SIGINT, by which roslaunch ends its nodes all the same.
sigset_t signalsToLeave() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, SIG_DFL);
    ::sigaddset(&signals, signal);
  }
  struct sigaction hang_up = {};
  ::sigaction(SIGHUP, nullptr, &hang_up);
  if (hang_up.sa_handler != SIG_IGN) ::sigaddset(&signals, SIGHUP);
  return signals;
}

// Waits for signals in a thread of its own: in any other one, a signal would break off a system
// call, and with it a question to the master, whose missing answer reads as a missing parameter.
// To be called before there are other threads, which inherit what is blocked.
void watchSignals() {
  const sigset_t signals = signalsToLeave();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] {
    for (int signal = 0; ::sigwait(&signals, &signal) == 0;) leave = true;
  }).detach();
}

// False when asked to leave meanwhile.
bool awaitMaster() {
  for (int poll = 0; !leave; ++poll) {
    if (ros::master::check()) return true;
    if (poll % kPollsPerWarning == 0) {
      ROS_WARN_STREAM("No ROS master answers at " << ros::master::getURI()
                                                  << "; waiting. Start roscore or roslaunch.");
    }
    std::this_thread::sleep_for(kPoll);
  }
  return false;
}

// Ends the process in time, whatever its threads wait for: once its work is done, or a signal asks
// it to leave and there is nothing to save.
void watchEnd() {
  std::thread([] {
    while (!done && (saves || !leave)) std::this_thread::sleep_for(kPoll);
    std::this_thread::sleep_for(kLongestEnd);
    std::_Exit(exit_code);
  }).detach();
}

// What fails where the node was asked to leave meanwhile, as a master's answer that never came
// does, is no fault.
int explain(const std::exception& error, int code) {
  if (askedToLeave() && !saves) return leaveInTime(0);
  leaveInTime(code);
  std::istringstream lines(error.what());
  for (std::string line; std::getline(lines, line);) ROS_FATAL_STREAM(line);
  leaveLastWords(error.what());
  return code;
}

int runBody(const NodeMain& node) {
  try {
    return node.body();
  } catch (const std::invalid_argument& error) {
    return explain(error, 2);
  } catch (const std::exception& error) {
    return explain(error, 1);
  }
}

}  // namespace

int runNode(int argc, char** argv, const NodeMain& node) {
  if (argc > 1 && std::strcmp(argv[1], "--help") == 0) {
    std::cout << node.options();
    return 0;
  }
  watchSignals();
  ros::init(argc, argv, node.name, ros::init_options::NoSigintHandler);
  watchEnd();
  if (!awaitMaster()) return 0;
  // Started here, ROS and its console outlive the body's node handles.
  ros::start();
  ros::param::del("~last_words");  // of an earlier node of this name, at a master that stays
  const int code = runBody(node);
  // While its singletons live: a thread of ROS that outlives them aborts the process.
  ros::shutdown();
  return code;
}

const std::atomic<bool>& leaveFlag() { return leave; }

bool askedToLeave() { return leave || !ros::ok(); }

void waitUntilAskedToLeave() {
  while (!askedToLeave()) std::this_thread::sleep_for(kPoll);
}

void leaveLastWords(const std::string& sentence) { ros::param::set("~last_words", sentence); }

void saveBeforeLeaving() { saves = true; }

int leaveInTime(int code) {
  exit_code = code;
  done = true;
  return code;
}

}  // namespace hexapod
