#include "planning/distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapod {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
// Of points, where maps are small enough.
constexpr double kWidest_m = 0.05;
constexpr double kMostPoints = 4e6;

double squared(double value) { return value * value; }

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

/// Points per side of a cell: an even number, so that the middle of a passage of any number of
/// cells is one of them.
std::size_t pointsPerCell(const OccupancyMap& map) {
  const auto cells = static_cast<double>(map.cells.size());
  const double pairs = std::clamp(std::ceil(map.resolution_m / kWidest_m - 1e-9), 1.0, 1000.0);
  std::size_t points = 2 * static_cast<std::size_t>(pairs);
  while (points > 1 && cells * squared(static_cast<double>(points)) > kMostPoints) {
    points -= points > 2 ? 2 : 1;
  }
  return points;
}

}  // namespace

DistanceField::DistanceField(const OccupancyMap& map, bool unknown_is_free)
    : per_cell_(pointsPerCell(map)),
      spacing_m_(map.resolution_m / static_cast<double>(per_cell_)),
      columns_(static_cast<std::size_t>(map.columns) * per_cell_ + 1),
      rows_(static_cast<std::size_t>(map.rows) * per_cell_ + 1),
      outside_is_free_(unknown_is_free),
      points_(columns_ * rows_, kNothing) {
  markOccupied(map, unknown_is_free);
  spreadAlongColumns();
  spreadAlongRows();
}

void DistanceField::markOccupied(const OccupancyMap& map, bool unknown_is_free) {
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const std::int8_t value = map.at(column, row);
      const bool occupied = value < 0 ? !unknown_is_free : value >= OccupancyMap::kOccupied;
      if (!occupied) continue;
      std::size_t corner = static_cast<std::size_t>(row) * per_cell_ * columns_ +
                           static_cast<std::size_t>(column) * per_cell_;
      for (std::size_t i = 0; i <= per_cell_; ++i, corner += columns_) {
        std::fill_n(points_.begin() + static_cast<std::ptrdiff_t>(corner), per_cell_ + 1, 0.0f);
      }
    }
  }
  if (outside_is_free_) return;
  for (std::size_t i = 0; i < columns_; ++i) points_[i] = points_[points_.size() - 1 - i] = 0.0f;
  for (std::size_t j = 0; j < rows_; ++j) {
    points_[j * columns_] = points_[(j + 1) * columns_ - 1] = 0.0f;
  }
}

/// Distance along the column, squared: two sweeps.
void DistanceField::spreadAlongColumns() {
  for (std::size_t i = columns_; i < points_.size(); ++i) {
    points_[i] = std::min(points_[i], points_[i - columns_] + 1.0f);
  }
  for (std::size_t i = points_.size() - columns_; i-- > 0;) {
    points_[i] = std::min(points_[i], points_[i + columns_] + 1.0f);
  }
  for (float& value : points_) value *= value;
}

void DistanceField::spreadAlongRows() {
  Envelope envelope(columns_);
  std::vector<float> row(columns_);
  for (std::size_t j = 0; j < rows_; ++j) {
    float* values = &points_[j * columns_];
    envelope.lower(values, row.data(), columns_);
    for (std::size_t i = 0; i < columns_; ++i) values[i] = std::sqrt(row[i]);
  }
}

DistanceField::Place DistanceField::placeOf(double x_m, double y_m) const {
  const double u = x_m / spacing_m_;
  const double v = y_m / spacing_m_;
  const double in_u = std::clamp(u, 0.0, static_cast<double>(columns_ - 1));
  const double in_v = std::clamp(v, 0.0, static_cast<double>(rows_ - 1));
  const auto column = std::min(static_cast<std::size_t>(in_u), columns_ - 2);
  const auto row = std::min(static_cast<std::size_t>(in_v), rows_ - 2);
  const bool inside = u == in_u && v == in_v;
  return {row * columns_ + column, in_u - static_cast<double>(column),
          in_v - static_cast<double>(row), inside ? 0.0 : std::hypot(u - in_u, v - in_v)};
}

double DistanceField::atLeast(double x_m, double y_m) const {
  const Place place = placeOf(x_m, y_m);
  if (place.outside > 0.0 && !outside_is_free_) return 0.0;
  const float* at = &points_[place.corner];
  if (at[0] == kNothing) return kFar_m;
  // The square of a distance less that of the position is the least of affine functions of the
  // position, hence concave: at least what is interpolated between the corners.
  const double low = (1.0 - place.x) * squared(at[0]) + place.x * squared(at[1]);
  const double high = (1.0 - place.x) * squared(at[columns_]) + place.x * squared(at[columns_ + 1]);
  const double least2 = (1.0 - place.y) * low + place.y * high - place.x * (1.0 - place.x) -
                        place.y * (1.0 - place.y);
  const double least = std::sqrt(std::max(0.0, least2));
  // Everything occupied lies within the map.
  return spacing_m_ * std::max({0.0, least - place.outside, place.outside});
}

double DistanceField::atMost(double x_m, double y_m) const {
  const Place place = placeOf(x_m, y_m);
  if (place.outside > 0.0 && !outside_is_free_) return 0.0;
  const float* at = &points_[place.corner];
  if (at[0] == kNothing) return kFar_m;
  const double most = std::min(
      std::min(at[0] + std::hypot(place.x, place.y), at[1] + std::hypot(1.0 - place.x, place.y)),
      std::min(at[columns_] + std::hypot(place.x, 1.0 - place.y),
               at[columns_ + 1] + std::hypot(1.0 - place.x, 1.0 - place.y)));
  return spacing_m_ * (most + place.outside);
}

}  // namespace hexapod
