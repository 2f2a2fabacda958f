#pragma once

#include <csignal>
#include <functional>
#include <thread>

namespace hexapod {

/// Turns SIGINT, SIGTERM and SIGHUP into a call, for as long as it lives; a second one ends the
/// process on the spot. Those that the process was started to ignore (by nohup, or in the
/// background of a script) stay ignored.
///
/// To be created before any other thread, because they inherit what it blocks.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// From now on, and for a signal that has come already: calls `on_signal` once, in a thread of
  /// the watch's own. To be called once.
  void start(std::function<void()> on_signal);

 private:
  void watch(const std::function<void()>& on_signal) const;

  sigset_t signals_{};
  std::thread thread_;
};

}  // namespace hexapod
