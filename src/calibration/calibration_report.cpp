#include "calibration/calibration_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/text.h"
#include "geometry/pose2.h"

namespace hexapod {
namespace {

// Deviations to either side that hold 95 % of a normal distribution.
constexpr double kInterval = 1.96;

struct Interval {
  std::string name;
  double value, low, high;
};

double natural(int parameter, double mean) {
  const bool is_scale = std::string(bodyParameters()[parameter].unit).empty();
  return is_scale ? std::exp(mean) : mean;
}

Interval intervalOf(const FittedBody& fitted, int parameter) {
  const double mean = fitted.mean[parameter];
  const double wide = kInterval * std::sqrt(fitted.covariance(parameter, parameter));
  return {bodyParameters()[parameter].name, natural(parameter, mean),
          natural(parameter, mean - wide), natural(parameter, mean + wide)};
}

std::string errorRow(const Calibration& calibration, bool is_check, const std::string& name) {
  const MedianMiss before = medianOf(calibration.missesOf(calibration.before, is_check));
  const MedianMiss after = medianOf(calibration.missesOf(calibration.after, is_check));
  const auto text = [](const MedianMiss& miss) {
    return fixedText(1e3 * miss.position_m, 1) + " mm, " +
           fixedText(miss.heading_rad / kDegree, 2) + " deg";
  };
  return "| " + name + " | " + text(before) + " | " + text(after) + " |\n";
}

std::string jsonOf(const Eigen::Vector3d& miss) {
  if (!miss.allFinite()) return "null";
  return "[" + exactText(miss.x()) + ", " + exactText(miss.y()) + ", " + exactText(miss.z()) + "]";
}

}  // namespace

std::vector<Eigen::Vector3d> Calibration::missesOf(const std::vector<Eigen::Vector3d>& misses,
                                                   bool is_check) const {
  std::vector<Eigen::Vector3d> chosen;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i].is_check == is_check) chosen.push_back(misses[i]);
  }
  return chosen;
}

Calibration calibrate(std::shared_ptr<const Imagination> imagination, const Physics& nominal,
                      const std::vector<Trial>& trials, const FitOptions& options) {
  std::vector<SeenBehavior> all, to_fit;
  for (const Trial& trial : trials) {
    all.push_back(trial.seen);
    if (!trial.is_check) to_fit.push_back(trial.seen);
  }
  Calibration calibration;
  calibration.trials = trials;
  calibration.fitted = fitBody(TrialChain(imagination, nominal, to_fit), options);
  const TrialChain chain(std::move(imagination), nominal, all);
  auto misses = chain.misses({BodyVector::Zero(), calibration.fitted.mean});
  calibration.before = std::move(misses[0]);
  calibration.after = std::move(misses[1]);
  return calibration;
}

std::string reportOf(const Calibration& calibration, const std::string& robot_name) {
  const std::vector<Trial>& trials = calibration.trials;
  const auto checks = std::count_if(trials.begin(), trials.end(),
                                    [](const Trial& trial) { return trial.is_check; });
  std::string text = "# Calibration of " + robot_name + "\n\n| parameter | found | 95 % interval |";
  text += calibration.truth ? " true |\n|---|---|---|---|\n" : "\n|---|---|---|\n";
  for (int i = 0; i < kBodyParameters; ++i) {
    const Interval one = intervalOf(calibration.fitted, i);
    text += "| " + one.name + " | " + fixedText(one.value, 3) + " | " + fixedText(one.low, 3) +
            " .. " + fixedText(one.high, 3) + " |";
    if (calibration.truth) {
      text += " " + fixedText(natural(i, (*calibration.truth)[i]), 3) + " |";
    }
    text += "\n";
  }
  text += "\n| median error of prediction | before | after |\n|---|---|---|\n";
  text += errorRow(
      calibration, false,
      std::to_string(static_cast<std::ptrdiff_t>(trials.size()) - checks) + " behaviours fitted");
  if (checks > 0) {
    text += errorRow(calibration, true, std::to_string(checks) + " behaviours not fitted");
  }
  if (calibration.fitted.left_out > 0) {
    text += "\n" + std::to_string(calibration.fitted.left_out) +
            " of the behaviours fitted are explained by no body (somebody touched the robot, or it "
            "slipped); they count little.\n";
  }
  return text;
}

std::string pictureData(const Calibration& calibration, const std::string& robot_name) {
  std::string parameters, trials;
  for (int i = 0; i < kBodyParameters; ++i) {
    const Interval one = intervalOf(calibration.fitted, i);
    parameters += (i > 0 ? ", " : "") + ("{\"name\": \"" + one.name + "\", \"value\": ") +
                  exactText(one.value) + ", \"low\": " + exactText(one.low) +
                  ", \"high\": " + exactText(one.high) + ", \"truth\": " +
                  (calibration.truth ? exactText(natural(i, (*calibration.truth)[i])) : "null") +
                  "}";
  }
  for (std::size_t i = 0; i < calibration.trials.size(); ++i) {
    trials += (i > 0 ? ", " : "") + std::string("{\"check\": ") +
              (calibration.trials[i].is_check ? "true" : "false") +
              ", \"before\": " + jsonOf(calibration.before[i]) +
              ", \"after\": " + jsonOf(calibration.after[i]) + "}";
  }
  return "{\"robot\": \"" + robot_name + "\", \"parameters\": [" + parameters + "], \"trials\": [" +
         trials + "]}\n";
}

}  // namespace hexapod
