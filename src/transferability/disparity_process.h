#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "transferability/behavior_features.h"

namespace hexapod {

/// Prior variances of one coordinate of a disparity, by what it may depend on.
struct DisparityKernel {
  double by_own = 0.0;    ///< in proportion to the same coordinate of the end pose, per unit of it
  double by_end = 0.0;    ///< smooth over end poses
  double by_gait = 0.0;   ///< smooth over end poses and gaits
  bool symmetric = true;  ///< what is smooth is the same for images of behaviours
  double noise = 0.0;     ///< of each behaviour alone, measurement included
  double noise_by_doubt = 0.0;  ///< the same, per square of what simulation itself is in doubt of
};

/// One coordinate of the disparity as a Gaussian process over behaviours (Rasmussen & Williams
/// 2006, chapter 2), with that kernel of a list which is likeliest by what was measured. Immutable.
class DisparityProcess {
 public:
  struct Value {
    double mean = 0.0;
    double variance = 0.0;  ///< noise included
  };

  /// Of behaviours that were tried, the images, and a value each; one or more. `coordinate`: 0 x,
  /// 1 y, 2 heading.
  DisparityProcess(const std::vector<std::vector<BehaviorImage>>& tried,
                   const Eigen::VectorXd& measured, int coordinate);

  /// Of a behaviour, told by its images.
  Value at(const std::vector<BehaviorImage>& images) const;

  const DisparityKernel& kernel() const { return kernel_; }

 private:
  std::vector<std::vector<BehaviorImage>> tried_;
  int coordinate_;
  DisparityKernel kernel_;
  Eigen::LLT<Eigen::MatrixXd> root_;
  Eigen::VectorXd weights_;
};

}  // namespace hexapod
