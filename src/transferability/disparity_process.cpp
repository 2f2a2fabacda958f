#include "transferability/disparity_process.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapod {
namespace {

// Differences of end poses, and of gaits, over which one hardly tells of the other any more.
constexpr double kEndScale = 1.0;
constexpr double kGaitScale = 1.0;
// More trials say hardly more about the kernel.
constexpr std::size_t kMostForTheKernel = 100;

using Images = std::vector<BehaviorImage>;

double nearness(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double scale) {
  return std::exp(-0.5 * (a - b).squaredNorm() / (scale * scale));
}

/// Prior covariance of a behaviour with another one, its noise left out.
double covariance(const DisparityKernel& kernel, const BehaviorFeatures& a, const Images& b,
                  int coordinate) {
  double sum = kernel.by_own * a.end[coordinate] * b.front().features.end[coordinate];
  if (kernel.by_end == 0.0 && kernel.by_gait == 0.0) return sum;
  for (const BehaviorImage& image : b) {
    const double by_end = image.signs[coordinate] * nearness(a.end, image.features.end, kEndScale);
    sum += kernel.by_end * by_end;
    if (kernel.by_gait > 0.0) {
      sum += kernel.by_gait * by_end * nearness(a.gait, image.features.gait, kGaitScale);
    }
    if (!kernel.symmetric) break;
  }
  return sum;
}

double noiseOf(const DisparityKernel& kernel, const BehaviorFeatures& behavior) {
  return kernel.noise + kernel.noise_by_doubt * behavior.doubt * behavior.doubt;
}

/// The prior covariance of what was measured of some behaviours, for one kernel after another: it
/// is a sum of parts, and the parts do not change.
class PriorCovariance {
 public:
  PriorCovariance(const std::vector<Images>& tried, std::size_t count, int coordinate,
                  bool symmetric)
      : tried_(tried), count_(static_cast<Eigen::Index>(count)) {
    by_own_ = part({1.0, 0.0, 0.0, symmetric}, coordinate);
    by_end_ = part({0.0, 1.0, 0.0, symmetric}, coordinate);
    by_gait_ = part({0.0, 0.0, 1.0, symmetric}, coordinate);
  }

  Eigen::LLT<Eigen::MatrixXd> root(const DisparityKernel& kernel) const {
    Eigen::MatrixXd sum =
        kernel.by_own * by_own_ + kernel.by_end * by_end_ + kernel.by_gait * by_gait_;
    for (Eigen::Index i = 0; i < count_; ++i) {
      sum(i, i) += noiseOf(kernel, tried_[static_cast<std::size_t>(i)].front().features);
    }
    return Eigen::LLT<Eigen::MatrixXd>(sum);
  }

 private:
  Eigen::MatrixXd part(const DisparityKernel& kernel, int coordinate) const {
    Eigen::MatrixXd part(count_, count_);
    for (Eigen::Index a = 0; a < count_; ++a) {
      for (Eigen::Index b = 0; b < count_; ++b) {
        part(a, b) = covariance(kernel, tried_[static_cast<std::size_t>(a)].front().features,
                                tried_[static_cast<std::size_t>(b)], coordinate);
      }
    }
    return part;
  }

  const std::vector<Images>& tried_;
  Eigen::Index count_;
  Eigen::MatrixXd by_own_, by_end_, by_gait_;
};

/// What disparities may be like: lengths over that of the scales, and radians. From hardly any to a
/// third of what a behaviour does.
std::vector<DisparityKernel> kernels(bool symmetric) {
  std::vector<DisparityKernel> all;
  for (const double by_own : {0.0, 0.003, 0.03}) {
    for (const double by_end : {0.0, 0.001, 0.01}) {
      for (const double by_gait : {0.0, 0.003, 0.01}) {
        for (const double noise : {1e-5, 1e-4, 1e-3, 1e-2}) {
          for (const double by_doubt : {0.0, 0.3, 1.0, 3.0}) {
            all.push_back({by_own, by_end, by_gait, symmetric, noise, by_doubt});
          }
        }
      }
    }
  }
  return all;
}

// Few trials must not make anybody sure: noise is about this, within a factor of e^2.
constexpr double kUsualNoise = 1e-3;
constexpr double kUsualNoiseSpread = 2.0;

double logPrior(const DisparityKernel& kernel) {
  return -0.5 * std::pow(std::log(kernel.noise / kUsualNoise) / kUsualNoiseSpread, 2);
}

/// Up to a constant.
double logLikelihood(const Eigen::LLT<Eigen::MatrixXd>& root, const Eigen::VectorXd& measured) {
  const Eigen::VectorXd whitened = root.matrixL().solve(measured);
  return -0.5 * whitened.squaredNorm() - root.matrixLLT().diagonal().array().log().sum();
}

DisparityKernel likeliest(const std::vector<Images>& tried, const Eigen::VectorXd& measured,
                          int coordinate) {
  const std::size_t count = std::min(tried.size(), kMostForTheKernel);
  DisparityKernel likeliest;
  double best = -std::numeric_limits<double>::infinity();
  for (const bool symmetric : {true, false}) {
    const PriorCovariance prior(tried, count, coordinate, symmetric);
    for (const DisparityKernel& kernel : kernels(symmetric)) {
      const double likelihood =
          logPrior(kernel) +
          logLikelihood(prior.root(kernel), measured.head(static_cast<Eigen::Index>(count)));
      if (likelihood <= best) continue;
      best = likelihood;
      likeliest = kernel;
    }
  }
  return likeliest;
}

}  // namespace

DisparityProcess::DisparityProcess(const std::vector<std::vector<BehaviorImage>>& tried,
                                   const Eigen::VectorXd& measured, int coordinate)
    : tried_(tried), coordinate_(coordinate), kernel_(likeliest(tried, measured, coordinate)) {
  root_ = PriorCovariance(tried_, tried_.size(), coordinate_, kernel_.symmetric).root(kernel_);
  weights_ = root_.solve(measured);
}

DisparityProcess::Value DisparityProcess::at(const std::vector<BehaviorImage>& images) const {
  const BehaviorFeatures& behavior = images.front().features;
  Eigen::VectorXd covariances(static_cast<Eigen::Index>(tried_.size()));
  for (std::size_t i = 0; i < tried_.size(); ++i) {
    covariances[static_cast<Eigen::Index>(i)] =
        covariance(kernel_, behavior, tried_[i], coordinate_);
  }
  const double prior = covariance(kernel_, behavior, images, coordinate_);
  const double known = root_.matrixL().solve(covariances).squaredNorm();
  // Rounding may leave less than nothing.
  return {covariances.dot(weights_), std::max(0.0, prior - known) + noiseOf(kernel_, behavior)};
}

}  // namespace hexapod
