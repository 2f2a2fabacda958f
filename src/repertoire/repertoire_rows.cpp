#include "repertoire/repertoire_rows.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "repertoire/digest.h"
#include "repertoire/learner_tables.h"

namespace hexapod {
namespace {

void add(const Entry& entry, Digest& digest) {
  digest.add(entry.id);
  digest.add(std::string(entry.genome.begin(), entry.genome.end()));
  digest.add(entry.end_pose);
  digest.add(entry.cost);
  digest.add(entry.evaluation);
  digest.add(static_cast<std::int64_t>(entry.execution.has_value()));
  if (!entry.execution) return;
  digest.add(entry.execution->mean);
  digest.add(entry.execution->spread_m);
  digest.add(entry.execution->spread_rad);
  digest.add(static_cast<std::int64_t>(entry.execution->trials));
  digest.add(static_cast<std::int64_t>(entry.execution->falls));
}

std::string problemOf(const Genome& genome, const GenomeShape& shape) {
  if (genome.size() != shape.genes) {
    return "has " + std::to_string(genome.size()) + " genes where the others have " +
           std::to_string(shape.genes);
  }
  for (const std::uint8_t level : genome) {
    if (level >= shape.levels) {
      return "has a gene of level " + std::to_string(level) + " where 0 to " +
             std::to_string(shape.levels - 1) + " exist";
    }
  }
  return "";
}

bool isSpread(double value) { return std::isfinite(value) && value >= 0.0; }

std::string problemOf(const Execution& execution) {
  if (!isFinite(execution.mean)) return "has an executed pose that is not finite";
  if (!isSpread(execution.spread_m) || !isSpread(execution.spread_rad)) {
    return "has a spread that is negative or not finite";
  }
  if (execution.trials < 0 || execution.falls < 0 || execution.falls > execution.trials) {
    return "has " + std::to_string(execution.falls) + " falls in " +
           std::to_string(execution.trials) + " trials";
  }
  return "";
}

}  // namespace

std::string digestOf(const std::vector<Entry>& entries) {
  std::vector<const Entry*> order;
  order.reserve(entries.size());
  for (const Entry& entry : entries) order.push_back(&entry);
  std::sort(order.begin(), order.end(),
            [](const Entry* a, const Entry* b) { return a->id < b->id; });
  Digest digest;
  for (const Entry* entry : order) add(*entry, digest);
  return digest.text();
}

std::string digestOf(const std::vector<RobotTrial>& trials) {
  Digest digest;
  for (const RobotTrial& trial : trials) {
    digest.add(trial.evaluation);
    digest.add(std::string(trial.genome.begin(), trial.genome.end()));
    digest.add(trial.simulated);
    digest.add(trial.cost);
    digest.add(static_cast<std::int64_t>(trial.measured.has_value()));
    if (trial.measured) digest.add(*trial.measured);
  }
  return digest.text();
}

std::string digestOf(const std::map<std::string, std::string>& meta,
                     const std::vector<HistoryRow>& history, const LearnerState& state) {
  Digest digest;
  for (const auto& [key, value] : meta) {
    if (key == kFileDigestKey) continue;
    digest.add(key);
    digest.add(value);
  }
  for (const HistoryRow& row : history) {
    digest.add(row.evaluations);
    digest.add(row.archive_size);
    for (const double value :
         {row.sparseness_m, row.median_orientation_error_rad, row.max_reach_m, row.elapsed_s}) {
      digest.add(value);
    }
    digest.add(static_cast<std::int64_t>(row.held_out.has_value()));
    if (!row.held_out) continue;
    for (const double value :
         {row.held_out->sparseness_m, row.held_out->median_orientation_error_rad,
          row.held_out->median_shift_m}) {
      digest.add(value);
    }
  }
  add(state, digest);
  return digest.text();
}

std::string problemOf(const Entry& entry, const GenomeShape& shape) {
  const std::string problem = problemOf(entry.genome, shape);
  if (!problem.empty()) return problem;
  if (!isFinite(entry.end_pose)) return "has an end pose that is not finite";
  if (!isSpread(entry.cost)) {
    return "has a cost of " + exactText(entry.cost);
  }
  return entry.execution ? problemOf(*entry.execution) : "";
}

std::string problemOf(const RobotTrial& trial, const GenomeShape& shape) {
  const std::string problem = problemOf(trial.genome, shape);
  if (!problem.empty()) return problem;
  const bool is_finite =
      isFinite(trial.simulated) && (!trial.measured || isFinite(*trial.measured));
  if (!is_finite) return "has an end pose that is not finite";
  return isSpread(trial.cost) ? "" : "has a cost of " + exactText(trial.cost);
}

}  // namespace hexapod
