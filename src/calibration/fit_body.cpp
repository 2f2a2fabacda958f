#include "calibration/fit_body.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/random.h"
#include "repertoire/metrics.h"

namespace hexapod {
namespace {

using Misses = std::vector<Eigen::Vector3d>;

// Beyond so many deviations a miss counts by its amount, not its square.
constexpr double kOutlier = 3.0;
// A miss that is not known counts as so many deviations.
constexpr double kUnknown = 30.0;
// Bodies are drawn somewhat wider than what is thought likely, and never nearer than this.
constexpr double kWider = 1.3;
constexpr double kNearest = 0.02;

// The search, in units of what is possible: a parameter of 1 is a standard deviation away.
class Search {
 public:
  Search(const TrialChain& chain, const FitOptions& options)
      : chain_(chain), options_(options), unit_(possibleDeviations()), random_(options.seed) {}

  FittedBody run() {
    look({mean_});
    for (std::int64_t round = 0; round < options_.rounds; ++round) {
      linearise(look(drawn()));
      look({mean_});
    }
    return result();
  }

 private:
  struct Point {
    BodyVector at = BodyVector::Zero();  // in units
    Eigen::VectorXd misses;              // over their noise, three per trial
    double cost = std::numeric_limits<double>::infinity();
  };

  std::vector<BodyVector> drawn() {
    const BodyMatrix root = Eigen::LLT<BodyMatrix>(covariance_).matrixL();
    std::vector<BodyVector> where;
    for (std::int64_t i = 0; i < options_.pairs; ++i) {
      BodyVector step;
      for (int j = 0; j < kBodyParameters; ++j) step[j] = random_.normal();
      where.push_back(mean_ + kWider * root * step);
      where.push_back(mean_ - kWider * root * step);
    }
    return where;
  }

  // Keeps the best of all that was looked at.
  std::vector<Point> look(const std::vector<BodyVector>& where) {
    std::vector<BodyVector> bodies;
    for (const BodyVector& at : where) bodies.push_back(at.cwiseProduct(unit_));
    const std::vector<Misses> misses = chain_.misses(bodies);
    std::vector<Point> points;
    for (std::size_t i = 0; i < where.size(); ++i) {
      Point point{where[i], scaled(misses[i]), 0.0};
      point.cost = costOf(point);
      if (point.cost < best_.cost) best_ = point;
      points.push_back(std::move(point));
    }
    return points;
  }

  // A plane through the misses of the points, and what is likely by it.
  void linearise(const std::vector<Point>& points) {
    const auto count = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd factors(count, 1 + kBodyParameters);
    Eigen::MatrixXd misses(count, points.front().misses.size());
    for (Eigen::Index i = 0; i < count; ++i) {
      const Point& point = points[static_cast<std::size_t>(i)];
      factors.row(i) << 1.0, (point.at - mean_).transpose();
      misses.row(i) = point.misses.cwiseMax(-kUnknown).cwiseMin(kUnknown);
    }
    const Eigen::MatrixXd plane = factors.colPivHouseholderQr().solve(misses);
    const double freedom = static_cast<double>(count - 1 - kBodyParameters);
    const Eigen::VectorXd ragged =
        (misses - factors * plane).colwise().squaredNorm().transpose() / freedom;
    BodyMatrix information = BodyMatrix::Identity();
    BodyVector gradient = mean_;
    for (Eigen::Index row = 0; row < misses.cols(); ++row) {
      const BodyVector change = plane.col(row).tail<kBodyParameters>();
      const double middle = plane(0, row);
      const double weight = weightOf(std::abs(middle)) / (1.0 + ragged[row]);
      information += weight * change * change.transpose();
      gradient += weight * middle * change;
    }
    covariance_ = information.inverse();
    mean_ -= covariance_ * gradient;
    covariance_.diagonal() = covariance_.diagonal().cwiseMax(kNearest * kNearest);
  }

  FittedBody result() const {
    if (!std::isfinite(best_.cost)) {
      throw std::runtime_error(
          "The robot stands in simulation with none of the bodies thought of.");
    }
    FittedBody fitted;
    fitted.mean = best_.at.cwiseProduct(unit_);
    fitted.misses = chain_.misses({fitted.mean}).front();
    double sum = 0.0;
    const Eigen::Index trials = best_.misses.size() / 3;
    for (Eigen::Index t = 0; t < trials; ++t) {
      const double far = best_.misses.segment<3>(3 * t).norm();
      if (far > kOutlier * std::sqrt(3.0)) ++fitted.left_out;
      sum += weightOf(far) * far * far;
    }
    const double noise = std::max(1.0, sum / (3.0 * static_cast<double>(trials)));
    const BodyMatrix prior = BodyMatrix::Identity();
    const BodyMatrix information = (covariance_.inverse() - prior) / noise + prior;
    fitted.covariance = unit_.asDiagonal() * information.inverse() * unit_.asDiagonal();
    return fitted;
  }

  Eigen::VectorXd scaled(const Misses& misses) const {
    const Eigen::Vector3d noise(options_.noise_m, options_.noise_m, options_.noise_rad);
    Eigen::VectorXd over_noise(3 * misses.size());
    for (std::size_t t = 0; t < misses.size(); ++t) {
      over_noise.segment<3>(static_cast<Eigen::Index>(3 * t)) =
          misses[t].allFinite() ? misses[t].cwiseQuotient(noise).eval()
                                : Eigen::Vector3d::Constant(kUnknown).eval();
    }
    return over_noise;
  }

  static double weightOf(double far) { return std::min(1.0, kOutlier / std::max(far, 1e-9)); }

  static double costOf(const Point& point) {
    double cost = point.at.squaredNorm();
    for (Eigen::Index t = 0; t < point.misses.size(); t += 3) {
      const double far = point.misses.segment<3>(t).norm();
      cost += far < kOutlier ? far * far : 2.0 * kOutlier * far - kOutlier * kOutlier;
    }
    return cost;
  }

  const TrialChain& chain_;
  const FitOptions& options_;
  const BodyVector unit_;
  Random random_;
  BodyVector mean_ = BodyVector::Zero();  // what is thought likely
  BodyMatrix covariance_ = BodyMatrix::Identity();
  Point best_;
};

}  // namespace

FittedBody fitBody(const TrialChain& chain, const FitOptions& options) {
  if (chain.trials().empty()) {
    throw std::invalid_argument("There is nothing to fit a body to: no behaviour was played.");
  }
  return Search(chain, options).run();
}

MedianMiss medianOf(const std::vector<Eigen::Vector3d>& misses) {
  if (misses.empty()) return {};
  const double never = std::numeric_limits<double>::infinity();
  std::vector<double> positions_m, headings_rad;
  for (const Eigen::Vector3d& miss : misses) {
    positions_m.push_back(miss.allFinite() ? miss.head<2>().norm() : never);
    headings_rad.push_back(miss.allFinite() ? std::abs(miss.z()) : never);
  }
  return {*median(positions_m), *median(headings_rad)};
}

}  // namespace hexapod
