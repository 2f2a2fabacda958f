#include "tools/own_processes.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>

namespace hexapod {
namespace {

pid_t start(const std::function<int()>& work) {
  std::fflush(nullptr);  // or both would write what is buffered
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) {
    throw std::runtime_error(std::string("No process can be started: ") + std::strerror(errno) +
                             ".");
  }
  if (child > 0) return child;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int code = ::getppid() == parent ? work() : 1;
  std::fflush(nullptr);
  std::_Exit(code);
}

}  // namespace

void forEachInOwnProcess(std::size_t count, std::size_t jobs,
                         const std::function<int(std::size_t)>& work,
                         const std::function<void(std::size_t, const ProcessEnd&)>& ended) {
  // Who started this may have ignored it: then the system keeps no end of a child.
  std::signal(SIGCHLD, SIG_DFL);
  std::map<pid_t, std::size_t> running;
  std::size_t next = 0;
  while (next < count || !running.empty()) {
    if (next < count && running.size() < jobs) {
      running.emplace(start([&] { return work(next); }), next);
      ++next;
      continue;
    }
    int status = 0;
    const pid_t child = ::waitpid(-1, &status, 0);
    if (child < 0 && errno != EINTR) {
      throw std::runtime_error(std::string("Processes cannot be waited for: ") +
                               std::strerror(errno) + ".");
    }
    const auto found = running.find(child);
    if (found == running.end()) continue;
    const std::size_t i = found->second;
    running.erase(found);
    ended(i,
          WIFEXITED(status) ? ProcessEnd{WEXITSTATUS(status), 0} : ProcessEnd{0, WTERMSIG(status)});
  }
}

}  // namespace hexapod
