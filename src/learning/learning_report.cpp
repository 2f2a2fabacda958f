#include "learning/learning_report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace hexapod {

std::string describe(const LearningStatus& status) {
  std::ostringstream line;
  line.imbue(std::locale::classic());
  line << std::fixed << std::setprecision(0);
  if (status.phase == LearningPhase::kValidating) {
    line << "Validating: " << status.entries_validated << " of " << status.entries << " entries.";
    return line.str();
  }
  if (status.phase == LearningPhase::kVerifying) {
    line << "Verifying: " << status.entries_verified << " of " << status.entries
         << " entries replayed in ODE.";
    return line.str();
  }
  const bool done = status.phase == LearningPhase::kDone;
  line << (done ? "Done: " : "Learning: ") << status.counters.evaluations;
  // A run that only its time limits has a budget nobody reads.
  if (!done && status.time_budget_s <= 0.0) line << " of " << status.evaluations_budget;
  line << " evaluations, " << status.evaluations_per_s << "/s, ";
  if (!done) line << status.eta_s << " s left, ";
  line << status.entries << " entries";
  if (status.last.evaluations > 0) {
    line << std::setprecision(2) << ", sparseness " << 100.0 * status.last.sparseness_m
         << " cm, orientation error " << status.last.median_orientation_error_rad * 180.0 / M_PI
         << " deg";
  }
  if (done && status.last.held_out) {
    line << " (" << 100.0 * status.last.held_out->sparseness_m << " cm, "
         << status.last.held_out->median_orientation_error_rad * 180.0 / M_PI
         << " deg in other worlds)";
  }
  line << std::setprecision(0) << "; " << status.simulations << " simulations, " << status.known
       << " gaits known.";
  return line.str();
}

double fractionDone(const LearningStatus& status) {
  if (status.phase == LearningPhase::kDone) return 1.0;
  const auto part = [](double done, double whole) { return whole > 0.0 ? done / whole : 1.0; };
  if (status.phase == LearningPhase::kValidating) {
    return part(static_cast<double>(status.entries_validated), static_cast<double>(status.entries));
  }
  if (status.phase == LearningPhase::kVerifying) {
    return part(static_cast<double>(status.entries_verified), static_cast<double>(status.entries));
  }
  const double of_evaluations = part(static_cast<double>(status.counters.evaluations),
                                     static_cast<double>(status.evaluations_budget));
  const double of_time = status.time_budget_s > 0.0 ? status.elapsed_s / status.time_budget_s : 0.0;
  return std::max(of_evaluations, of_time);
}

}  // namespace hexapod
