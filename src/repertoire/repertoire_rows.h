#pragma once

#include <map>
#include <string>
#include <vector>

#include "repertoire/repertoire_file.h"

namespace hexapod {

/// What reader and writer of the repertoire file must agree on, beside its format.

/// Columns of the table entries in the order in which they are written and, but for the last, which
/// follows from the pose, read.
constexpr const char* kEntryColumns =
    "id, genome, x_m, y_m, yaw_rad, cost, evaluation, executed_x_m, executed_y_m, "
    "executed_yaw_rad, spread_m, spread_rad, trials, falls, orientation_error_rad";
/// The same in a file of format version 1, in which the cost had the name of the orientation error.
constexpr const char* kEntryColumnsOfVersion1 =
    "id, genome, x_m, y_m, yaw_rad, orientation_error_rad, evaluation, executed_x_m, executed_y_m, "
    "executed_yaw_rad, spread_m, spread_rad, trials, falls";

/// Columns of the table history, likewise.
constexpr const char* kHistoryColumns =
    "evaluations, archive_size, sparseness_m, median_orientation_error_rad, max_reach_m, "
    "elapsed_s, held_out_sparseness_m, held_out_median_orientation_error_rad, "
    "held_out_median_shift_m";

/// Columns of the table trials, likewise.
constexpr const char* kTrialColumns =
    "evaluation, genome, x_m, y_m, yaw_rad, cost, measured_x_m, measured_y_m, measured_yaw_rad";

/// Key of the digest over everything that digestOf(entries) does not cover.
constexpr const char* kFileDigestKey = "file_digest";
constexpr const char* kOptionPrefix = "option.";
constexpr const char* kFactPrefix = "fact.";

/// Digest over all rows of meta but kFileDigestKey, of history and of the learner's state.
std::string digestOf(const std::map<std::string, std::string>& meta,
                     const std::vector<HistoryRow>& history, const LearnerState& state);

/// Key of the digest over the trials, where there are any, and that digest.
constexpr const char* kTrialDigestKey = "trial_digest";
std::string digestOf(const std::vector<RobotTrial>& trials);

/// What the genomes of a repertoire have in common.
struct GenomeShape {
  std::size_t genes = 0;
  std::size_t levels = kGeneLevels;
};

/// What is wrong with an entry: "" or "has ...". Shared, so that what is saved can be loaded.
std::string problemOf(const Entry& entry, const GenomeShape& shape);

/// The same of a trial.
std::string problemOf(const RobotTrial& trial, const GenomeShape& shape);

}  // namespace hexapod
