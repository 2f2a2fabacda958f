#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "common/random.h"
#include "simulation/reduced/angle.h"
#include "simulation/reduced/clearance.h"
#include "simulation/reduced/inertia.h"
#include "simulation/reduced/system.h"

namespace hexapod::reduced {
namespace {

Eigen::Vector3d eigen(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

Vec3<double> randomVector(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(ReducedMath, ArcTangentIsThatOfTheCLibraryToTwoUnitsInTheLastPlace) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double scale = i % 2 ? 1.0 : 1e-4;
    const double y = scale * random.uniform(), x = random.uniform();
    const double expected = std::atan2(y, x);
    EXPECT_NEAR(arcTangent(y, x), expected, 4.5e-16 * expected) << y << " " << x;
  }
  EXPECT_EQ(arcTangent(0.0, 1.0), 0.0);
  EXPECT_EQ(arcTangent(1.0, 0.0), std::atan2(1.0, 0.0));
}

TEST(ReducedMath, HingeAngleIsTheTurnAboutTheAxis) {
  Random random(2);
  const Vec3<double> axis{0.6, 0.0, -0.8};
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Quaterniond parent = Eigen::Quaterniond(Eigen::Vector4d::NullaryExpr([&] {
                                        return random.uniform(-1, 1);
                                      })).normalized();
    const Eigen::Quaterniond rest(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()));
    const double angle = random.uniform(-3.1, 3.1);
    Eigen::Quaterniond child = parent * rest * Eigen::AngleAxisd(angle, eigen(axis));
    if (i % 2) child.coeffs() *= -1.0;  // the same rotation
    const auto of = [](const Eigen::Quaterniond& q) {
      return Quaternion<double>{q.w(), q.x(), q.y(), q.z()};
    };
    EXPECT_NEAR(hingeAngle(of(child), of(parent), of(rest.conjugate()), axis), angle, 1e-14);
  }
}

// The smallest distance found by going along one segment; of the other the nearest point is known.
double distanceBySearch(const PlacedCapsule<double>& a, double half_a,
                        const PlacedCapsule<double>& b, double half_b) {
  double smallest = 1e9;
  for (int i = -2000; i <= 2000; ++i) {
    const Eigen::Vector3d point = eigen(a.center) + half_a * i / 2000.0 * eigen(a.axis);
    const double along = (point - eigen(b.center)).dot(eigen(b.axis));
    const Eigen::Vector3d nearest =
        eigen(b.center) + std::max(-half_b, std::min(half_b, along)) * eigen(b.axis);
    smallest = std::min(smallest, (point - nearest).norm());
  }
  return smallest;
}

TEST(ReducedMath, DistanceOfSegmentsIsTheSmallestOfAllTheirPoints) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const auto capsule = [&] {
      const Eigen::Vector3d axis = eigen(randomVector(random)).normalized();
      return PlacedCapsule<double>{randomVector(random), {axis.x(), axis.y(), axis.z()}};
    };
    const PlacedCapsule<double> a = capsule();
    PlacedCapsule<double> b = capsule();
    if (i % 10 == 0) b.axis = a.axis;
    const double half_a = random.uniform(), half_b = i % 7 == 0 ? 0.0 : random.uniform();
    const double found = std::sqrt(squaredDistance<double>(a, half_a, b, half_b));
    EXPECT_NEAR(found, distanceBySearch(a, half_a, b, half_b), 2e-6 + 1e-3 * half_a) << i;
    EXPECT_LE(found, distanceBySearch(a, half_a, b, half_b) + 1e-12) << i;
  }
}

struct MadeBox {
  PlacedBox<double> placed;
  double half[3];

  Eigen::Vector3d nearest(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d axes[3] = {eigen(placed.axes.x), eigen(placed.axes.y),
                                     eigen(placed.axes.z)};
    Eigen::Vector3d found = eigen(placed.center);
    for (int i = 0; i < 3; ++i) {
      const double along = axes[i].dot(point - eigen(placed.center));
      found += std::max(-half[i], std::min(half[i], along)) * axes[i];
    }
    return found;
  }
};

MadeBox randomBox(Random& random, bool turned) {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  if (turned) {
    turn = Eigen::Quaterniond(Eigen::Vector4d::NullaryExpr([&] {
             return random.uniform(-1, 1);
           })).normalized();
  }
  return {{randomVector(random),
           rotationOf(Quaternion<double>{turn.w(), turn.x(), turn.y(), turn.z()})},
          {random.uniform(0.01, 0.6), random.uniform(0.01, 0.6), random.uniform(0.01, 0.6)}};
}

TEST(ReducedMath, DistanceOfASegmentAndABoxIsTheSmallestOfAllTheirPoints) {
  Random random(5);
  int meeting = 0;
  for (int i = 0; i < 400; ++i) {
    const MadeBox box = randomBox(random, i % 5 != 0);
    const Eigen::Vector3d axis = i % 10 == 0 ? Eigen::Vector3d(Eigen::Vector3d::UnitY())
                                             : eigen(randomVector(random)).normalized();
    const PlacedCapsule<double> line{randomVector(random), {axis.x(), axis.y(), axis.z()}};
    const double half = i % 7 == 0 ? 0.0 : random.uniform();
    double expected = 1e9;
    for (int k = -2000; k <= 2000; ++k) {
      const Eigen::Vector3d point = eigen(line.center) + half * k / 2000.0 * axis;
      expected = std::min(expected, (point - box.nearest(point)).norm());
    }
    const double found = std::sqrt(squaredDistanceToBox<double>(line, half, box.placed, box.half));
    EXPECT_NEAR(found, expected, 1e-12 + 5e-4 * half) << i;
    EXPECT_LE(found, expected + 1e-12) << i;
    meeting += expected == 0.0;
  }
  EXPECT_GT(meeting, 10);
  EXPECT_LT(meeting, 390);
}

// By projecting onto one box and the other in turn, which leads to their nearest points.
double distanceByProjection(const MadeBox& a, const MadeBox& b) {
  Eigen::Vector3d point = eigen(a.placed.center);
  for (int i = 0; i < 20000; ++i) point = a.nearest(b.nearest(point));
  return (point - b.nearest(point)).norm();
}

TEST(ReducedMath, BoxesHaveAGapOfAtMostTheirDistanceUnlessTheyMeet) {
  Random random(6);
  int meeting = 0;
  for (int i = 0; i < 300; ++i) {
    const MadeBox a = randomBox(random, i % 5 != 0), b = randomBox(random, i % 5 != 0);
    const double found = gapOfBoxes<double>(a.placed, a.half, b.placed, b.half);
    const double distance = distanceByProjection(a, b);
    EXPECT_LE(found, distance + 1e-6) << i;
    // Along the direction of the farthest of the fifteen not much less than straight.
    if (distance > 1e-3) {
      EXPECT_GT(found, 0.4 * distance) << i;
    }
    meeting += found <= 0.0;
  }
  EXPECT_GT(meeting, 30);
  EXPECT_LT(meeting, 270);
}

TEST(ReducedMath, GyroscopicImpulseTurnsMomentumWithoutChangingItsLength) {
  const Sym3<double> inertia{2e-3, 3e-3, 4e-3, 1e-4, -2e-4, 3e-4};
  const Vec3<double> rate{3.0, -2.0, 5.0};
  const Vec3<double> momentum = inertia * rate;
  const double step = 1e-4;
  const Vec3<double> impulse = gyroscopicImpulse(inertia, momentum, step);
  // For a small step h (I w) x w.
  const Eigen::Vector3d expected = step * eigen(momentum).cross(eigen(rate));
  EXPECT_LT((eigen(impulse) - expected).norm(), 1e-3 * expected.norm());
  EXPECT_NEAR(dot(impulse, momentum), 0.0, 1e-18);
}

TEST(ReducedMath, SystemsAreSolved) {
  Random random(4);
  const Eigen::Matrix<double, 6, 6> root =
      Eigen::Matrix<double, 6, 6>::NullaryExpr([&] { return random.uniform(-1, 1); });
  const Eigen::Matrix<double, 6, 6> matrix =
      root * root.transpose() + Eigen::Matrix<double, 6, 6>::Identity();
  SymmetricSystem<double, 6> system;
  double x[6];
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j <= i; ++j) system.a[i][j] = matrix(i, j);
    x[i] = i - 2.5;
  }
  const Eigen::Matrix<double, 6, 1> right = Eigen::Map<Eigen::Matrix<double, 6, 1>>(x);
  system.factor();
  system.solve(x);
  const Eigen::Map<Eigen::Matrix<double, 6, 1>> solution(x);
  EXPECT_LT((matrix * solution - right).norm(), 1e-13);
}

}  // namespace
}  // namespace hexapod::reduced
