#include "planning/move.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace hexapod {
namespace {

// Less than these is standing still: no goal tolerance asks for such a step.
constexpr double kStill_m = 0.003;
constexpr double kStill_rad = 0.01;

constexpr double kPriorTrials = 2.0;

double blended(double spread, double trials, double prior) {
  return std::sqrt((trials * spread * spread + kPriorTrials * prior * prior) /
                   (trials + kPriorTrials));
}

Move moveOf(const Entry& entry, const PlannerOptions& options) {
  Move move;
  move.end = entry.expectedPose();
  move.cosine = std::cos(move.end.yaw_rad);
  move.sine = std::sin(move.end.yaw_rad);
  move.length_m = std::hypot(move.end.x_m, move.end.y_m);
  const Execution seen = entry.execution.value_or(Execution{});
  move.spread_m = blended(seen.spread_m, seen.trials, options.unvalidated_spread_m);
  move.spread_rad = blended(seen.spread_rad, seen.trials, options.unvalidated_spread_rad);
  const GoalTolerance usual;
  move.cost =
      1.0 + options.spread_weight * (move.spread_m / usual.xy_m + move.spread_rad / usual.yaw_rad);
  return move;
}

bool moves(const Entry& entry) {
  const Pose2& end = entry.expectedPose();
  return isFinite(end) && (std::hypot(end.x_m, end.y_m) >= kStill_m ||
                           std::abs(wrapAngle(end.yaw_rad)) >= kStill_rad);
}

bool finiteSpread(const Entry& entry) {
  return !entry.execution ||
         (std::isfinite(entry.execution->spread_m) && std::isfinite(entry.execution->spread_rad));
}

double separation(const Move& a, const Move& b) {
  const double turn = wrapOnce(a.end.yaw_rad - b.end.yaw_rad);
  return std::hypot(a.end.x_m - b.end.x_m, a.end.y_m - b.end.y_m, kMetresPerRadian * turn);
}

// In their order, those that stand best for all.
std::vector<Move> thinnedOut(std::vector<Move> moves, std::size_t most) {
  if (moves.size() <= most) return moves;
  std::vector<std::size_t> chosen = spreadOut(moves, most);
  std::sort(chosen.begin(), chosen.end());
  std::vector<Move> kept;
  for (const std::size_t i : chosen) kept.push_back(std::move(moves[i]));
  return kept;
}

}  // namespace

std::vector<Move> usableMoves(const Repertoire& repertoire, const PlannerOptions& options,
                              const EntryPaths& paths) {
  std::vector<Move> result;
  for (const std::size_t i : steadyEntries(repertoire.entries, options.steadiness)) {
    const Entry& entry = repertoire.entries[i];
    if (finiteSpread(entry) && moves(entry)) {
      result.push_back(moveOf(entry, options));
      result.back().entry = i;
      result.back().path =
          makeMovePath(result.back().end, i < paths.size() ? paths[i] : std::vector<Pose2>{});
    }
  }
  const double most = std::sqrt(static_cast<double>(options.max_pairs));
  return thinnedOut(std::move(result), static_cast<std::size_t>(most));
}

std::vector<std::size_t> spreadOut(const std::vector<Move>& moves, std::size_t count) {
  std::vector<std::size_t> chosen;
  if (moves.empty()) return chosen;
  const auto farthest =
      std::max_element(moves.begin(), moves.end(),
                       [](const Move& a, const Move& b) { return a.length_m < b.length_m; });
  std::size_t next = static_cast<std::size_t>(farthest - moves.begin());
  std::vector<double> gap(moves.size(), std::numeric_limits<double>::infinity());
  while (chosen.size() < std::min(count, moves.size())) {
    chosen.push_back(next);
    gap[next] = -1.0;
    double best = -1.0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (gap[i] < 0.0) continue;
      gap[i] = std::min(gap[i], separation(moves[i], moves[chosen.back()]));
      const double worth = gap[i] / (moves[i].cost * moves[i].cost);
      if (worth > best) {
        best = worth;
        next = i;
      }
    }
  }
  return chosen;
}

std::vector<std::size_t> farthestPerSector(const std::vector<Move>& moves, std::size_t sectors) {
  std::vector<std::size_t> farthest(sectors, moves.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const double turn = std::atan2(moves[i].end.y_m, moves[i].end.x_m) / (2.0 * M_PI) + 0.5;
    const auto sector = static_cast<std::size_t>(turn * static_cast<double>(sectors)) % sectors;
    std::size_t& best = farthest[sector];
    if (best == moves.size() || moves[i].length_m > moves[best].length_m) best = i;
  }
  farthest.erase(std::remove(farthest.begin(), farthest.end(), moves.size()), farthest.end());
  return farthest;
}

}  // namespace hexapod
