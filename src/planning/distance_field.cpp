#include "planning/distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapod {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

/// Lower envelope of the parabolas (x - i)^2 + heights[i]: its value at every i.
class Envelope {
 public:
  explicit Envelope(std::size_t size) : vertex_(size), begin_(size + 1) {}

  void lower(const float* heights, float* result, std::size_t size) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if (heights[i] == kNothing) continue;
      double from = -std::numeric_limits<double>::infinity();
      while (count > 0) {
        from = intersection(heights, vertex_[count - 1], i);
        if (from > begin_[count - 1]) break;
        --count;
        from = -std::numeric_limits<double>::infinity();
      }
      vertex_[count] = i;
      begin_[count] = from;
      ++count;
    }
    std::size_t k = 0;
    for (std::size_t i = 0; i < size; ++i) {
      while (k + 1 < count && begin_[k + 1] <= static_cast<double>(i)) ++k;
      result[i] = count == 0 ? kNothing : height(heights, vertex_[k], i);
    }
  }

 private:
  static double intersection(const float* heights, std::size_t a, std::size_t b) {
    const auto at_a = static_cast<double>(a);
    const auto at_b = static_cast<double>(b);
    return (heights[b] + at_b * at_b - heights[a] - at_a * at_a) / (2.0 * (at_b - at_a));
  }
  static float height(const float* heights, std::size_t vertex, std::size_t i) {
    const double away = static_cast<double>(i) - static_cast<double>(vertex);
    return static_cast<float>(away * away + heights[vertex]);
  }

  std::vector<std::size_t> vertex_;
  std::vector<double> begin_;  ///< from where on a parabola is the lowest
};

}  // namespace

DistanceField::DistanceField(const OccupancyMap& map, bool unknown_is_free)
    : resolution_m_(map.resolution_m),
      columns_(static_cast<std::size_t>(map.columns) + 1),
      rows_(static_cast<std::size_t>(map.rows) + 1),
      outside_is_free_(unknown_is_free),
      cells_(columns_ * rows_, kNothing) {
  markCorners(map, unknown_is_free);
  spreadAlongColumns();
  spreadAlongRows();
}

void DistanceField::markCorners(const OccupancyMap& map, bool unknown_is_free) {
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const std::int8_t value = map.at(column, row);
      const bool occupied = value < 0 ? !unknown_is_free : value >= OccupancyMap::kOccupied;
      if (!occupied) continue;
      const std::size_t corner =
          static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column);
      cells_[corner] = cells_[corner + 1] = 0.0f;
      cells_[corner + columns_] = cells_[corner + columns_ + 1] = 0.0f;
    }
  }
  if (outside_is_free_) return;
  for (std::size_t i = 0; i < columns_; ++i) cells_[i] = cells_[cells_.size() - 1 - i] = 0.0f;
  for (std::size_t j = 0; j < rows_; ++j) {
    cells_[j * columns_] = cells_[(j + 1) * columns_ - 1] = 0.0f;
  }
}

/// Distance along the column, squared: two sweeps.
void DistanceField::spreadAlongColumns() {
  for (std::size_t i = columns_; i < cells_.size(); ++i) {
    cells_[i] = std::min(cells_[i], cells_[i - columns_] + 1.0f);
  }
  for (std::size_t i = cells_.size() - columns_; i-- > 0;) {
    cells_[i] = std::min(cells_[i], cells_[i + columns_] + 1.0f);
  }
  for (float& value : cells_) value *= value;
}

void DistanceField::spreadAlongRows() {
  Envelope envelope(columns_);
  std::vector<float> row(columns_);
  for (std::size_t j = 0; j < rows_; ++j) {
    float* values = &cells_[j * columns_];
    envelope.lower(values, row.data(), columns_);
    for (std::size_t i = 0; i < columns_; ++i) values[i] = std::sqrt(row[i]);
  }
}

DistanceField::Cell DistanceField::cellOf(double x_m, double y_m) const {
  const double u = x_m / resolution_m_;
  const double v = y_m / resolution_m_;
  const double in_u = std::clamp(u, 0.0, static_cast<double>(columns_ - 1));
  const double in_v = std::clamp(v, 0.0, static_cast<double>(rows_ - 1));
  const auto column = std::min(static_cast<std::size_t>(in_u), columns_ - 2);
  const auto row = std::min(static_cast<std::size_t>(in_v), rows_ - 2);
  const bool inside = u == in_u && v == in_v;
  return {row * columns_ + column, in_u - static_cast<double>(column),
          in_v - static_cast<double>(row), inside ? 0.0 : std::hypot(u - in_u, v - in_v)};
}

double DistanceField::atLeast(double x_m, double y_m) const {
  const Cell cell = cellOf(x_m, y_m);
  if (cell.outside > 0.0 && !outside_is_free_) return 0.0;
  const float* at = &cells_[cell.corner];
  if (at[0] == kNothing) return kFar_m;
  const double left2 = cell.x * cell.x;
  const double right2 = (1.0 - cell.x) * (1.0 - cell.x);
  const double low2 = cell.y * cell.y;
  const double high2 = (1.0 - cell.y) * (1.0 - cell.y);
  const double least =
      std::max(std::max(at[0] - std::sqrt(left2 + low2), at[1] - std::sqrt(right2 + low2)),
               std::max(at[columns_] - std::sqrt(left2 + high2),
                        at[columns_ + 1] - std::sqrt(right2 + high2)));
  // Everything occupied lies within the map.
  return resolution_m_ * std::max({0.0, least - cell.outside, cell.outside});
}

double DistanceField::atMost(double x_m, double y_m) const {
  const Cell cell = cellOf(x_m, y_m);
  if (cell.outside > 0.0 && !outside_is_free_) return 0.0;
  const float* at = &cells_[cell.corner];
  if (at[0] == kNothing) return kFar_m;
  const double most = std::min(
      std::min(at[0] + std::hypot(cell.x, cell.y), at[1] + std::hypot(1.0 - cell.x, cell.y)),
      std::min(at[columns_] + std::hypot(cell.x, 1.0 - cell.y),
               at[columns_ + 1] + std::hypot(1.0 - cell.x, 1.0 - cell.y)));
  return resolution_m_ * (most + cell.outside);
}

}  // namespace hexapod
