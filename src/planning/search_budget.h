#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>

namespace hexapod {

/// What a step of a search costs, in poses looked at.
/// @{
constexpr std::int64_t kWorkOfChild = 3;
constexpr std::int64_t kWorkOfChildOnWay = 6;
constexpr std::int64_t kWorkOfLookup = 10;
constexpr std::int64_t kWorkOfTest = 10;  ///< whether a path is free
/// @}

/// How much a search may still do: a count of poses looked at, so that the same question always
/// gets the same answer, and whatever else the caller stops it by.
class SearchBudget {
 public:
  /// Poses per second of planning time, measured: 0.1 s of it takes 80 to 120 ms of one 2 GHz core
  /// at 250 to 5,000 entries, near and far goals, with or without heading.
  static constexpr double kPosesPerSecond = 20e6;

  /// `stop` may be empty.
  SearchBudget(double planning_time_s, const std::function<bool()>& stop)
      : left_(static_cast<std::int64_t>(planning_time_s * kPosesPerSecond)), stop_(stop) {}

  void spend(std::int64_t poses) {
    left_ -= poses;
    spent_ += poses;
  }
  std::int64_t spent() const { return spent_; }

  /// True once everything is spent or the caller stopped the search; it stays so.
  bool isOver() {
    over_ = over_ || left_ < 0 || (stop_ && stop_());
    return over_;
  }

  /// From now on at most so much more.
  void limitTo(std::int64_t poses) { left_ = std::min(left_, poses); }

 private:
  std::int64_t left_;
  std::int64_t spent_ = 0;
  const std::function<bool()>& stop_;
  bool over_ = false;
};

}  // namespace hexapod
