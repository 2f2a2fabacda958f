#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/fit_body.h"
#include "calibration/trial_file.h"

namespace hexapod {

/// What a calibration found, and how well that predicts.
struct Calibration {
  std::vector<Trial> trials;
  FittedBody fitted;                    ///< to the trials that are not to check
  std::vector<Eigen::Vector3d> before;  ///< per trial: missed by the robot's files
  std::vector<Eigen::Vector3d> after;   ///< and by the body found
  std::optional<BodyVector> truth;      ///< of a simulated robot

  /// Of the trials to check, or of those fitted.
  std::vector<Eigen::Vector3d> missesOf(const std::vector<Eigen::Vector3d>& misses,
                                        bool is_check) const;
};

/// Fits a body to the trials and predicts all of them with it, and without. Throws as fitBody()
/// does.
Calibration calibrate(std::shared_ptr<const Imagination> imagination, const Physics& nominal,
                      const std::vector<Trial>& trials, const FitOptions& options);

/// Markdown: the parameters with their 95 % intervals, the errors of prediction before and after,
/// and a sentence about what does not fit.
std::string reportOf(const Calibration& calibration, const std::string& robot_name);

/// The same for a picture: JSON {robot, parameters: [{name, value, low, high, truth or null}],
/// trials: [{check, before: [x_m, y_m, yaw_rad], after: [..]}]}; null where a miss is not known.
std::string pictureData(const Calibration& calibration, const std::string& robot_name);

}  // namespace hexapod
