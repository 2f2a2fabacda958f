#include "tools/calibration_draws.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ostream>

#include "common/text.h"
#include "evaluation/chains.h"
#include "geometry/pose2.h"
#include "learning/relearning.h"
#include "repertoire/metrics.h"
#include "repertoire/steadiness.h"

namespace hexapod {
namespace {

constexpr double kWithin = 0.3;
constexpr ChainOptions kChains{10, 500, 1};
// A repertoire chains as well as another that misses by at most so much more.
constexpr double kAsWell = 1.25;

// "0.83, 1.12, ..": the scales of a body.
std::string scalesText(const BodyVector& body) {
  std::vector<std::string> parts;
  for (int i = kFriction; i <= kMass; ++i) parts.push_back(fixedText(std::exp(body[i]), 2));
  return listed(parts);
}

std::string missText(const MedianMiss& miss) {
  return fixedText(1e3 * miss.position_m, 1) + " mm, " + fixedText(miss.heading_rad / kDegree, 2) +
         " deg";
}

std::string ratioText(double ratio) { return fixedText(ratio, 2); }

/// Draws robots one after another and tells of each.
class Draws {
 public:
  Draws(const CalibrationSetting& setting, const Repertoire& repertoire, const DrawOptions& options,
        std::ostream& stream)
      : setting_(setting),
        repertoire_(repertoire),
        options_(options),
        stream_(stream),
        random_(options.seed) {}

  void run() {
    const bool learns = options_.evaluations > 0;
    if (learns) own_ = chained(repertoire_, setting_.learned.physics);
    stream_
        << "| true: friction, gain, torque, mass | found | not fitted: before | after | after / "
           "before |"
        << (learns ? " chained there: nominal | learned with what was found | / "
                     "nominal in its own |"
                   : "")
        << "\n|---|---|---|---|---|" << (learns ? "---|---|---|" : "") << "\n";
    for (std::int64_t i = 0; i < options_.draws; ++i) draw();
    tellMedians();
  }

 private:
  void draw() {
    BodyVector truth = BodyVector::Zero();
    for (int j = kFriction; j <= kMass; ++j) {
      truth[j] = std::log(random_.uniform(1.0 - kWithin, 1.0 + kWithin));
    }
    const Physics& nominal = setting_.learned.physics;
    const Physics body = physicsOf(nominal, nominal.legs, truth);
    const Calibration found = calibrateSimulated(setting_, body, random_.bits());
    const MedianMiss before = medianOf(found.missesOf(found.before, true));
    const MedianMiss after = medianOf(found.missesOf(found.after, true));
    predicted_.push_back(after.position_m / before.position_m);
    stream_ << "| " << scalesText(truth) << " | " << scalesText(found.fitted.mean) << " | "
            << missText(before) << " | " << missText(after) << " | " << ratioText(predicted_.back())
            << " |";
    if (options_.evaluations > 0) learnFor(found.fitted.mean, body);
    stream_ << "\n" << std::flush;
  }

  void learnFor(const BodyVector& found, const Physics& body) {
    const Physics& nominal = setting_.learned.physics;
    RelearnOptions relearning;
    relearning.evaluations = options_.evaluations;
    relearning.threads = options_.threads;
    const std::atomic<bool> never{false};
    const Repertoire learned = *relearn(setting_.imagination->robot(), repertoire_,
                                        physicsOf(nominal, nominal.legs, found), relearning, never);
    const MedianMiss there = chained(learned, body);
    chained_.push_back(there.position_m / own_.position_m);
    stream_ << " " << missText(chained(repertoire_, body)) << " | " << missText(there) << " | "
            << ratioText(chained_.back()) << " |";
  }

  /// By how much entries that a planner uses miss, one after another at random in a world.
  MedianMiss chained(const Repertoire& repertoire, const Physics& world) const {
    const std::vector<Entry> steady = onlySteady(repertoire.entries, SteadinessOptions());
    const auto pool = std::make_shared<WorldPool>(setting_.engine, setting_.imagination->robot(),
                                                  world, static_cast<int>(options_.threads));
    const ChainResult result =
        chainAtRandom(pool, setting_.learned.behavior, steady, {world}, kChains).front();
    return {quantile(result.misses_m, 0.5), quantile(result.misses_rad, 0.5)};
  }

  void tellMedians() const {
    const auto atMost = [](const std::vector<double>& ratios, double most) {
      return std::count_if(ratios.begin(), ratios.end(), [&](double r) { return r <= most; });
    };
    stream_ << "\nMedian of after / before: " << ratioText(*median(predicted_))
            << "; at most half in " << atMost(predicted_, 0.5) << " of " << options_.draws << ".\n";
    if (chained_.empty()) return;
    stream_ << "Chained in its own world the nominal repertoire misses by " << missText(own_)
            << "; those learned with what was found, in theirs, by " << ratioText(*median(chained_))
            << " times as much in the median, at most " << ratioText(kAsWell) << " times in "
            << atMost(chained_, kAsWell) << " of " << options_.draws << ".\n";
  }

  const CalibrationSetting& setting_;
  const Repertoire& repertoire_;
  const DrawOptions& options_;
  std::ostream& stream_;
  Random random_;
  MedianMiss own_;
  std::vector<double> predicted_;  // errors of prediction, after over before
  std::vector<double> chained_;    // misses of the learned ones, over own_
};

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

void calibrateDraws(const CalibrationSetting& setting, const Repertoire& repertoire,
                    const DrawOptions& options, std::ostream& stream) {
  Draws(setting, repertoire, options, stream).run();
}

}  // namespace hexapod
