#include "tools/calibration_draws.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "common/text.h"
#include "repertoire/metrics.h"

namespace hexapod {
namespace {

constexpr double kWithin = 0.3;
constexpr double kDegrees = 180.0 / M_PI;

// "0.83, 1.12, ..": the scales of a body.
std::string scalesText(const BodyVector& body) {
  std::vector<std::string> parts;
  for (int i = kFriction; i <= kMass; ++i) parts.push_back(fixedText(std::exp(body[i]), 2));
  return listed(parts);
}

std::string missText(const MedianMiss& miss) {
  return fixedText(1e3 * miss.position_m, 1) + " mm, " + fixedText(kDegrees * miss.heading_rad, 2) +
         " deg";
}

}  // namespace

Calibration calibrateSimulated(const CalibrationSetting& setting, const Physics& body,
                               std::uint64_t seed) {
  const auto world = makeWorld(setting.engine, setting.imagination->robot(), body);
  Random random(seed);
  const std::vector<Trial> trials =
      playSimulated(*world, setting.learned.behavior, setting.plan, setting.noise, random);
  Calibration calibration =
      calibrate(setting.imagination, setting.learned.physics, trials, setting.fit);
  calibration.truth = parametersOf(body, setting.learned.physics);
  return calibration;
}

void calibrateDraws(const CalibrationSetting& setting, std::int64_t draws, std::uint64_t seed,
                    std::ostream& stream) {
  stream << "| true: friction, gain, torque, mass | found | not fitted: before | after | after / "
            "before |\n|---|---|---|---|---|\n";
  Random random(seed);
  std::vector<double> ratios;
  for (std::int64_t i = 0; i < draws; ++i) {
    BodyVector truth = BodyVector::Zero();
    for (int j = kFriction; j <= kMass; ++j) {
      truth[j] = std::log(random.uniform(1.0 - kWithin, 1.0 + kWithin));
    }
    const Physics body = physicsOf(setting.learned.physics, setting.learned.physics.legs, truth);
    const Calibration found = calibrateSimulated(setting, body, random.bits());
    const MedianMiss before = medianOf(found.missesOf(found.before, true));
    const MedianMiss after = medianOf(found.missesOf(found.after, true));
    ratios.push_back(after.position_m / before.position_m);
    stream << "| " << scalesText(truth) << " | " << scalesText(found.fitted.mean) << " | "
           << missText(before) << " | " << missText(after) << " | " << fixedText(ratios.back(), 2)
           << " |\n"
           << std::flush;
  }
  stream << "\nMedian of after / before: " << fixedText(*median(ratios), 2) << "; at most half in "
         << std::count_if(ratios.begin(), ratios.end(), [](double ratio) { return ratio <= 0.5; })
         << " of " << draws << ".\n";
}

}  // namespace hexapod
