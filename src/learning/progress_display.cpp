#include "learning/progress_display.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "learning/learning_report.h"

namespace hexapod {
namespace {

constexpr double kRedrawPeriod_s = 0.2;
constexpr double kComplainPeriod_s = 10.0;
constexpr std::size_t kBarWidth = 5;
constexpr const char* kClearLine = "\r\x1b[K";

}  // namespace

ProgressDisplay::Options ProgressDisplay::forStandardOutput(double period_s) {
  Options options;
  options.period_s = period_s;
  options.is_terminal = ::isatty(STDOUT_FILENO) != 0;
  winsize size = {};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    options.columns = size.ws_col;
  }
  return options;
}

ProgressDisplay::ProgressDisplay(std::ostream& out, const Options& options, Write write)
    : out_(out), options_(options), write_(std::move(write)) {
  if (!write_) write_ = [this](const std::string& line) { out_ << line << std::endl; };
}

void ProgressDisplay::show(const LearningStatus& status, double now_s) {
  const double period_s = options_.is_terminal ? kRedrawPeriod_s : options_.period_s;
  if (status.phase == phase_ && now_s - shown_s_ < period_s) return;
  phase_ = status.phase;
  shown_s_ = now_s;
  if (!options_.is_terminal || status.phase == LearningPhase::kDone) {
    say(describe(status));
    return;
  }
  // Whoever else writes begins at the left, and not behind the bar.
  out_ << kClearLine << progressBar(status, options_.columns - 1) << "\r" << std::flush;
}

void ProgressDisplay::clear() {
  if (options_.is_terminal) out_ << kClearLine << std::flush;
}

void ProgressDisplay::say(const std::string& line) {
  clear();
  write_(line);
}

void ProgressDisplay::complain(const std::string& problem, double now_s) {
  if (now_s - complained_s_ < kComplainPeriod_s) return;
  complained_s_ = now_s;
  say("ERROR: " + problem + " Learning goes on; saving will be tried again.");
}

std::string progressBar(const LearningStatus& status, std::size_t columns) {
  const double done = std::min(1.0, std::max(0.0, fractionDone(status)));
  const auto filled = static_cast<std::size_t>(std::floor(done * kBarWidth));
  const std::string percent = std::to_string(static_cast<int>(std::floor(100.0 * done)));
  const std::string line = "[" + std::string(filled, '#') + std::string(kBarWidth - filled, '.') +
                           "] " + std::string(3 - percent.size(), ' ') + percent + " %  " +
                           describeBriefly(status);
  return line.substr(0, columns);
}

}  // namespace hexapod
