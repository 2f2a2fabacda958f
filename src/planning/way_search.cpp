#include "planning/way_search.h"

#include <limits>

namespace hexapod {
namespace {

constexpr double kAround_m = 8.0;
constexpr double kEverywhere_m = std::numeric_limits<double>::infinity();

}  // namespace

std::optional<Pose2> nearestFreePose(const WayField::Question& question) {
  // A wave from the start that never gets to its goal sees all that hangs together.
  WayField::Question back = question;
  back.world_from_goal = question.world_from_start;
  back.world_from_start = question.world_from_goal;
  back.radius_m = 0.0;
  for (const double around_m : {kAround_m, kEverywhere_m}) {
    const WayField field(back, WayField::Open::kSurely, around_m);
    if (field.isCutShort()) return std::nullopt;
    const std::optional<Pose2> nearest = field.freePoseNearest(question.world_from_goal);
    if (nearest) return nearest;
  }
  return std::nullopt;
}

WaySearch findWays(const WayField::Question& question) {
  WaySearch result;
  const auto search = [&](WayField::Open open, double around_m) {
    auto field = std::make_shared<const WayField>(question, open, around_m);
    const bool found =
        field->wayFrom(question.world_from_start.x_m, question.world_from_start.y_m).has_value();
    result.cut_short = result.cut_short || field->isCutShort();
    return found ? field : nullptr;
  };
  for (const double around_m : {kAround_m, kEverywhere_m}) {
    result.bound = search(WayField::Open::kPossibly, around_m);
    if (result.cut_short) return {nullptr, nullptr, false, true};
    if (!result.bound) continue;
    result.ways = search(WayField::Open::kSurely, around_m);
    if (result.cut_short) return {nullptr, nullptr, false, true};
    if (result.ways) return result;
  }
  result.blocked = !result.bound;
  result.ways = result.bound;
  return result;
}

}  // namespace hexapod
