#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/pose2.h"

namespace hexapod {

/// End poses of chains of one or two moves, found by where they end.
///
/// A dense grid of (x, y, yaw) cells in one array, the chains of a cell beside each other. Memory
/// is bounded: the cells grow with the area covered. Immutable; may be read from any thread.
class PoseTable {
 public:
  struct Chain {
    Pose2 end;  ///< in the start frame
    std::uint32_t first = 0;
    std::uint32_t second = 0;  ///< of a chain of one move: not used
  };

  /// Yaws in [-pi, pi], everything finite.
  explicit PoseTable(std::vector<Chain> chains);

  /// Calls visit(chain) for all chains in the cells that touch the box of `radius_m` and
  /// `half_width_rad` (>= 0; pi or more: all headings) around `centre`: all inside, some outside.
  template <typename Visit>
  void visitNear(const Pose2& centre, double radius_m, double half_width_rad, Visit&& visit) const;

  /// False when no chain ends within that box: a chain may when a cell that touches it holds one.
  bool mayEndNear(const Pose2& centre, double radius_m, double half_width_rad) const {
    bool any = false;
    visitNear(centre, radius_m, half_width_rad, [&any](const Chain&) { any = true; });
    return any;
  }

  std::size_t size() const { return chains_.size(); }

 private:
  static constexpr int kHeadings = 36;

  int column(double x_m) const { return toCell((x_m - min_x_m_) / cell_m_, columns_); }
  int row(double y_m) const { return toCell((y_m - min_y_m_) / cell_m_, rows_); }
  static int toCell(double value, int count);
  static int heading(double yaw_rad);
  std::size_t cell(int column, int row, int heading) const;

  double min_x_m_ = 0.0;
  double min_y_m_ = 0.0;
  double cell_m_ = 0.05;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint32_t> begin_;  ///< per cell, into chains_; one more at the end
  std::vector<Chain> chains_;
};

template <typename Visit>
void PoseTable::visitNear(const Pose2& centre, double radius_m, double half_width_rad,
                          Visit&& visit) const {
  const int first_column = std::max(0, column(centre.x_m - radius_m));
  const int last_column = std::min(columns_ - 1, column(centre.x_m + radius_m));
  const int first_row = std::max(0, row(centre.y_m - radius_m));
  const int last_row = std::min(rows_ - 1, row(centre.y_m + radius_m));
  const bool all = half_width_rad >= M_PI - 2.0 * M_PI / kHeadings;
  const int first_heading = all ? 0 : heading(centre.yaw_rad - half_width_rad);
  const int last_heading = all ? kHeadings - 1 : heading(centre.yaw_rad + half_width_rad);
  const auto visitRun = [&](int c, int r, int from, int to) {
    const std::uint32_t end = begin_[cell(c, r, to) + 1];
    for (std::uint32_t i = begin_[cell(c, r, from)]; i < end; ++i) visit(chains_[i]);
  };
  for (int c = first_column; c <= last_column; ++c) {
    for (int r = first_row; r <= last_row; ++r) {
      if (first_heading <= last_heading) {
        visitRun(c, r, first_heading, last_heading);
      } else {
        visitRun(c, r, first_heading, kHeadings - 1);
        visitRun(c, r, 0, last_heading);
      }
    }
  }
}

}  // namespace hexapod
