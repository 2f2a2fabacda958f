#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "learning/learning_session.h"

namespace hexapod {

/// Shows a person how learning goes on: a bar that is redrawn in place on a terminal, plain lines
/// elsewhere. Used by one thread at a time.
class ProgressDisplay {
 public:
  struct Options {
    bool is_terminal = false;
    std::size_t columns = 80;  ///< of the terminal
    double period_s = 5.0;     ///< between two plain lines
  };

  /// Writes a line that stays.
  using Write = std::function<void(const std::string& line)>;

  /// Options that fit the standard output.
  static Options forStandardOutput(double period_s);

  /// The bar goes to `out`, which must outlive it, and so do the lines unless `write` is given.
  ProgressDisplay(std::ostream& out, const Options& options, Write write = nullptr);

  /// Shows the status if the last one shown is old enough, or something else is done now.
  /// `now_s` is a clock that never goes back.
  void show(const LearningStatus& status, double now_s);

  /// A line that stays.
  void say(const std::string& line);

  /// Takes the bar away, for whoever writes next.
  void clear();

  /// A line that stays, of a problem that may come again and again: at most every ten seconds.
  void complain(const std::string& problem, double now_s);

 private:
  std::ostream& out_;
  Options options_;
  Write write_;
  LearningPhase phase_ = LearningPhase::kEvolving;
  double shown_s_ = -1e9;
  double complained_s_ = -1e9;
};

/// "[##...]  50 %  trained: sparseness 4.21 cm, 2.31 deg, ..." in so many columns at most: 79 do
/// for all of it.
std::string progressBar(const LearningStatus& status, std::size_t columns);

}  // namespace hexapod
