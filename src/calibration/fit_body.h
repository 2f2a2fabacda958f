#pragma once

#include "calibration/trial_chain.h"

namespace hexapod {

/// How a fit judges, and how long it looks.
struct FitOptions {
  double noise_m = 0.004;    ///< of an end position about the right body's, per axis, > 0
  double noise_rad = 0.012;  ///< and of its heading, > 0
  std::int64_t pairs = 30;   ///< of bodies imagined per round, either side of the mean, >= 6
  std::int64_t rounds = 25;  ///< >= 1
  std::uint64_t seed = 1;    ///< of their draws
};

/// A body that explains trials, as far as they tell.
struct FittedBody {
  BodyVector mean = BodyVector::Zero();        ///< body.h: logarithms of scales, and slopes
  BodyMatrix covariance = BodyMatrix::Zero();  ///< of the mean, prior included
  std::vector<Eigen::Vector3d> misses;         ///< per trial, TrialChain::misses()
  std::int64_t left_out = 0;                   ///< trials that no body explains, which count little
};

/// The most likely body of those looked at: the one that makes the squares of the misses over their
/// noise (of which what is beyond three deviations counts by its amount alone, so that one trial in
/// which somebody touched the robot decides little) plus those of the parameters over
/// possibleDeviations() least.
///
/// Looks by iterated posterior linearisation (Garcia-Fernandez et al. 2015): in each round bodies
/// are drawn from what is thought likely, at first from all that is possible; a plane through what
/// they miss, not a derivative at a point, says how the misses change, what it leaves counts as
/// noise, and together with the prior that gives what is likely in the next round. Ends of
/// behaviours are ragged functions of a body: derivatives lead astray. The covariance is that of
/// the last round, with the noise that is left where that is more than `options` say.
/// Deterministic, whatever the number of threads. Throws std::invalid_argument without trials,
/// std::runtime_error when no body stands.
FittedBody fitBody(const TrialChain& chain, const FitOptions& options);

/// Median distances and heading differences over misses; those not finite count as infinite.
struct MedianMiss {
  double position_m = 0.0;
  double heading_rad = 0.0;
};
MedianMiss medianOf(const std::vector<Eigen::Vector3d>& misses);

}  // namespace hexapod
