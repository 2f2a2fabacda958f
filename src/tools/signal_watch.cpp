#include "tools/signal_watch.h"

#include <pthread.h>

#include <cstdlib>
#include <utility>

namespace hexapod {
namespace {

// Tells the watching thread to end; nobody else sends it.
constexpr int kEndSignal = SIGUSR1;

bool isIgnored(int signal) {
  struct sigaction action = {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

SignalWatch::SignalWatch() {
  ::sigemptyset(&signals_);
  ::sigaddset(&signals_, kEndSignal);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!isIgnored(signal)) ::sigaddset(&signals_, signal);
  }
  ::pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
}

SignalWatch::~SignalWatch() {
  if (!thread_.joinable()) return;
  ::pthread_kill(thread_.native_handle(), kEndSignal);
  thread_.join();
}

void SignalWatch::start(std::function<void()> on_signal) {
  thread_ = std::thread([this, call = std::move(on_signal)] { watch(call); });
}

void SignalWatch::watch(const std::function<void()>& on_signal) const {
  int signal = 0;
  if (::sigwait(&signals_, &signal) != 0 || signal == kEndSignal) return;
  on_signal();
  if (::sigwait(&signals_, &signal) != 0 || signal == kEndSignal) return;
  std::_Exit(128 + signal);
}

}  // namespace hexapod
