#include "ros_interface/common/node_process.h"

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
std::atomic<bool> done{false};  // the body's work
std::atomic<int> exit_code{0};

void onSignal(int) { leave = true; }

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
void watchEnd(bool saves) {
  std::thread([saves] {
    while (!done && (saves || !leave)) std::this_thread::sleep_for(kPoll);
    std::this_thread::sleep_for(kLongestEnd);
    std::_Exit(exit_code);
  }).detach();
}

int explain(const std::exception& error, int code) {
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
  ros::init(argc, argv, node.name, ros::init_options::NoSigintHandler);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, onSignal);
  if (!awaitMaster()) return 0;
  watchEnd(node.saves);
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

int leaveInTime(int code) {
  exit_code = code;
  done = true;
  return code;
}

}  // namespace hexapod
