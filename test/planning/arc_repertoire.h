#pragma once

#include <cmath>

#include "common/random.h"
#include "geometry/arc.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// Standard normal number (Box and Muller).
inline double normal(Random& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  return radius * std::cos(2.0 * M_PI * random.uniform());
}

constexpr double kSpread_m = 0.008;
constexpr double kSpread_rad = 0.014;

/// An entry that was seen to end at `end` in many trials.
inline Entry entryTo(const Pose2& end, double spread_m = kSpread_m,
                     double spread_rad = kSpread_rad) {
  Entry entry;
  entry.end_pose = end;
  entry.execution = Execution{end, spread_m, spread_rad, 1000, 0};
  return entry;
}

inline Repertoire repertoireOf(std::vector<Entry> entries) {
  Repertoire repertoire;
  repertoire.entries = std::move(entries);
  for (std::size_t i = 0; i < repertoire.entries.size(); ++i) {
    repertoire.entries[i].id = static_cast<std::int64_t>(1000 + i);
  }
  return repertoire;
}

/// A random point of the region of interest: within 60 degrees of the longitudinal axis, front and
/// rear, and 0.7 m along its arc.
inline Pose2 randomArcEnd(Random& random) {
  for (;;) {
    const double x = random.uniform(-0.7, 0.7);
    const double y = random.uniform(-0.7, 0.7);
    const Arc arc = arcThrough(x, y);
    if (std::abs(y) > std::tan(M_PI / 3.0) * std::abs(x) || std::abs(arc.length_m) > 0.7) continue;
    return {x, y, arc.heading_rad};
  }
}

/// What BR-Evolution gives: `count` ends spread evenly (each the farthest from the others of eight
/// random ones), headings off the arc by a normal error of one degree.
inline Repertoire arcRepertoire(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Entry> entries;
  while (entries.size() < count) {
    Pose2 best;
    double widest = -1.0;
    for (int i = 0; i < 8; ++i) {
      const Pose2 end = randomArcEnd(random);
      double gap = 10.0;
      for (const Entry& other : entries) gap = std::min(gap, distance(end, other.end_pose));
      if (gap <= widest) continue;
      widest = gap;
      best = end;
    }
    best.yaw_rad = wrapAngle(best.yaw_rad + M_PI / 180.0 * normal(random));
    entries.push_back(entryTo(best));
  }
  return repertoireOf(std::move(entries));
}

}  // namespace hexapod
