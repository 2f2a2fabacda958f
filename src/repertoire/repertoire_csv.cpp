#include "repertoire/repertoire_csv.h"

#include <algorithm>

#include "common/text.h"

namespace hexapod {
namespace {

std::string lineOf(const Entry& entry) {
  std::string line = std::to_string(entry.id) + "," + toString(entry.genome);
  for (const double value : {entry.end_pose.x_m, entry.end_pose.y_m, entry.end_pose.yaw_rad,
                             entry.orientationErrorRad(), entry.cost}) {
    line += "," + exactText(value);
  }
  line += "," + std::to_string(entry.evaluation);
  if (!entry.execution) return line + ",,,,,,0,0";
  const Execution& execution = *entry.execution;
  for (const double value : {execution.mean.x_m, execution.mean.y_m, execution.mean.yaw_rad,
                             execution.spread_m, execution.spread_rad}) {
    line += "," + exactText(value);
  }
  return line + "," + std::to_string(execution.trials) + "," + std::to_string(execution.falls);
}

}  // namespace

void exportCsv(const Repertoire& repertoire, std::ostream& out) {
  std::vector<Entry> entries = repertoire.entries;
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.id < b.id; });
  out << "id,genome,x_m,y_m,yaw_rad,orientation_error_rad,cost,evaluation,executed_x_m,executed_y_"
         "m,"
         "executed_yaw_rad,spread_m,spread_rad,trials,falls\n";
  for (const Entry& entry : entries) out << lineOf(entry) << '\n';
}

}  // namespace hexapod
