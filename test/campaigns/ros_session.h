#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros_interface/common/realtime.h"

namespace hexapod {

/// Gives the calling thread, and roscpp's thread that reads and writes sockets, a real-time
/// priority where there is one: a witness is not to be what is late.
inline void beOnTime() {
  askForRealtimePriority(RealtimePriority::kTransport);
  raiseTransportPriority();
}

/// A child process; ends with this object, and with this process.
class Child {
 public:
  explicit Child(std::vector<std::string> command) {
    std::vector<char*> words;
    for (std::string& word : command) words.push_back(&word[0]);
    words.push_back(nullptr);
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("Cannot start " + command[0] + ".");
    if (pid_ > 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const sched_param ordinary{};  // whatever priority this process has
    sched_setscheduler(0, SCHED_OTHER, &ordinary);
    dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);  // standard output is the report
    execvp(words[0], words.data());
    _exit(127);
  }
  ~Child() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  int pid() const { return pid_; }

 private:
  int pid_;
};

/// Folder of this program, in which the nodes are too.
inline std::string binariesFolder() {
  char path[4096];
  const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
  const std::string file(path, length > 0 ? static_cast<std::size_t>(length) : 0);
  return file.substr(0, file.rfind('/'));
}

/// A ROS master of this process's own, on the loopback interface; and this process as a node of it.
class RosSession {
 public:
  explicit RosSession(const std::string& node_name) {
    const std::string port = std::to_string(freePort());
    setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + port).c_str(), 1);
    setenv("ROS_IP", "127.0.0.1", 1);
    master_ = std::make_unique<Child>(
        std::vector<std::string>{"rosmaster", "--core", "-p", port, "-w", "3"});
    join(node_name);
    while (!ros::master::check()) usleep(20'000);
    ros::start();
    ros::param::set("robot_description", textOf(root() + "/urdf/hexapod.urdf"));
  }
  ~RosSession() { ros::shutdown(); }

  /// This process as a node of the master that the environment names.
  static void join(const std::string& node_name) {
    int argc = 0;
    ros::init(argc, nullptr, node_name, ros::init_options::NoSigintHandler);
  }

  /// A node of this package; its parameters are set before.
  static std::unique_ptr<Child> start(const std::string& node) {
    ros::param::set("/" + node + "/robot_config", root() + "/config/hexapod.yaml");
    return std::make_unique<Child>(
        std::vector<std::string>{binariesFolder() + "/" + node, "__name:=" + node});
  }

  static std::string root() { return HEXAPOD_ROOT; }

 private:
  static int freePort() {
    const int descriptor = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    const bool bound = bind(descriptor, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                       getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) == 0;
    close(descriptor);
    if (!bound) throw std::runtime_error("No free port on the loopback interface.");
    return ntohs(address.sin_port);
  }

  static std::string textOf(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }

  std::unique_ptr<Child> master_;
};

}  // namespace hexapod
