#include "study/run_recorder.h"

#include <algorithm>
#include <stdexcept>

#include "common/half_decade.h"
#include "common/text.h"
#include "repertoire/metrics.h"

namespace hexapod {
namespace {

constexpr std::int64_t kShortestHistoryStep = 500;
constexpr std::int64_t kRowsPerDecade = 20;
constexpr std::int64_t kFirstSnapshot = 10000;

std::int64_t decadeOf(std::int64_t evaluations) {
  std::int64_t decade = 1;
  while (evaluations / decade >= 10) decade *= 10;
  return decade;
}

}  // namespace

std::int64_t historyMark(std::int64_t evaluations) {
  const std::int64_t step = std::max(kShortestHistoryStep, decadeOf(evaluations) / kRowsPerDecade);
  return evaluations / step * step;
}

std::int64_t snapshotMark(std::int64_t evaluations) {
  const std::int64_t mark = halfDecade(evaluations);
  return mark >= kFirstSnapshot ? mark : 0;
}

RunRecorder::RunRecorder(const std::string& folder)
    : folder_(folder), history_(folder + "/history.csv"), entries_(folder + "/entries.csv") {
  history_ << "repertoire,evaluations,simulations,wall_s,entries,entries_in_region,sparseness_m,"
              "orientation_error_rad,orientation_error_of_all_rad,density_per_dm2,reach_m\n";
  entries_ << "repertoire,evaluations,x_m,y_m,yaw_rad,orientation_error_rad,genome\n";
}

void RunRecorder::record(const Method& method, std::int64_t simulations, double wall_s) {
  const std::int64_t evaluations = method.algorithm->counters().evaluations;
  if (historyMark(evaluations) > history_written_) writeHistory(method, simulations, wall_s);
  if (snapshotMark(evaluations) > entries_written_) writeEntries(method);
}

void RunRecorder::finish(const Method& method, std::int64_t simulations, double wall_s) {
  if (history_written_ < method.algorithm->counters().evaluations)
    writeHistory(method, simulations, wall_s);
  if (entries_written_ < method.algorithm->counters().evaluations) writeEntries(method);
  history_.close();
  entries_.close();
  if (history_ && entries_) return;
  throw std::runtime_error("The files of the run in " + folder_ +
                           " cannot be written: is the disk full?");
}

void RunRecorder::writeHistory(const Method& method, std::int64_t simulations, double wall_s) {
  for (const auto& [name, entries] : method.repertoires()) {
    const RepertoireMetrics metrics = measure(learnedEndings(entries));
    const auto unless = [](bool absent, double value) { return absent ? "" : exactText(value); };
    const bool none = metrics.endings == 0;
    history_ << name << ',' << std::to_string(method.algorithm->counters().evaluations) << ','
             << std::to_string(simulations) << ',' << exactText(wall_s) << ','
             << std::to_string(metrics.endings) << ',' << std::to_string(metrics.endings_in_region)
             << ',' << unless(none, metrics.sparseness_m) << ','
             << unless(metrics.endings_in_region == 0, metrics.median_error_in_region_rad) << ','
             << unless(none, metrics.median_error_of_all_rad) << ','
             << exactText(metrics.density_in_region_per_dm2) << ','
             << exactText(metrics.max_reach_m) << '\n';
  }
  history_written_ = method.algorithm->counters().evaluations;
}

void RunRecorder::writeEntries(const Method& method) {
  for (const auto& [name, entries] : method.repertoires()) {
    for (const Entry& entry : entries) {
      entries_ << name << ',' << std::to_string(method.algorithm->counters().evaluations) << ','
               << exactText(entry.end_pose.x_m) << ',' << exactText(entry.end_pose.y_m) << ','
               << exactText(entry.end_pose.yaw_rad) << ',' << exactText(entry.cost) << ','
               << toString(entry.genome) << '\n';
    }
  }
  entries_written_ = method.algorithm->counters().evaluations;
}

}  // namespace hexapod
