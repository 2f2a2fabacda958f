#include "planning/pose_table.h"

#include <algorithm>

namespace hexapod {
namespace {

// 128 x 128 x 36 cells of four bytes: at most 2.4 MB of index.
constexpr double kMaxCellsPerAxis = 128.0;
constexpr double kFinestCell_m = 0.05;

}  // namespace

int PoseTable::toCell(double value, int count) {
  return static_cast<int>(std::floor(std::clamp(value, -1.0, static_cast<double>(count))));
}

int PoseTable::heading(double yaw_rad) {
  const int index = static_cast<int>(std::floor(yaw_rad / (2.0 * M_PI / kHeadings)));
  return ((index % kHeadings) + kHeadings) % kHeadings;
}

std::size_t PoseTable::cell(int column, int row, int heading) const {
  return (static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_) +
          static_cast<std::size_t>(row)) *
             kHeadings +
         static_cast<std::size_t>(heading);
}

PoseTable::PoseTable(std::vector<Chain> chains) {
  if (chains.empty()) return;
  const auto [west, east] =
      std::minmax_element(chains.begin(), chains.end(),
                          [](const Chain& a, const Chain& b) { return a.end.x_m < b.end.x_m; });
  const auto [south, north] =
      std::minmax_element(chains.begin(), chains.end(),
                          [](const Chain& a, const Chain& b) { return a.end.y_m < b.end.y_m; });
  min_x_m_ = west->end.x_m;
  min_y_m_ = south->end.y_m;
  const double width_m = east->end.x_m - min_x_m_;
  const double height_m = north->end.y_m - min_y_m_;
  cell_m_ = std::max(kFinestCell_m, std::max(width_m, height_m) / (kMaxCellsPerAxis - 1.0));
  columns_ = static_cast<int>(width_m / cell_m_) + 1;
  rows_ = static_cast<int>(height_m / cell_m_) + 1;

  const auto cellOf = [this](const Chain& chain) {
    return cell(column(chain.end.x_m), row(chain.end.y_m), heading(chain.end.yaw_rad));
  };
  begin_.assign(cell(columns_ - 1, rows_ - 1, kHeadings - 1) + 2, 0);
  for (const Chain& chain : chains) ++begin_[cellOf(chain) + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  chains_.resize(chains.size());
  for (const Chain& chain : chains) chains_[next[cellOf(chain)]++] = chain;
}

}  // namespace hexapod
