#pragma once

#include <string>
#include <vector>

#include "self_model/believed_body.h"

namespace hexapod {

/// One behaviour of a calibration.
struct Trial {
  bool is_check = false;  ///< played to see what was found, not to find it
  SeenBehavior seen;      ///< its poses are measured at rest; without them it is yet to be played
};

/// Files of trials are comma separated, one line each under a line of names:
/// use (fit or check), genome (digits), before_x_m, before_y_m, before_yaw_rad, after_x_m,
/// after_y_m, after_yaw_rad. All those to check come after all those to fit.

/// Writes use and genome of trials that are yet to be played. Throws std::runtime_error when the
/// file cannot be written.
void writePlan(const std::vector<Trial>& trials, const std::string& file);

/// Writes trials that were played. Throws as writePlan() does.
void writeTrials(const std::vector<Trial>& trials, const std::string& file);

/// Reads them. Throws std::runtime_error naming file and line, what was expected and what was
/// found.
std::vector<Trial> readTrials(const std::string& file, std::size_t gene_count);

}  // namespace hexapod
