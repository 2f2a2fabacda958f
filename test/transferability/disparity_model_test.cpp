#include "transferability/disparity_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "common/random.h"
#include "geometry/arc.h"

namespace hexapod {
namespace {

constexpr std::size_t kGenes = 4;

/// Two legs of one signal that exchange their genes.
Symmetry leftRight() {
  std::vector<Symmetry::LegImage> legs(2, {0, {false}});
  legs[0].leg = 1;
  legs[1].leg = 0;
  return Symmetry(1.0, -1.0, legs);
}

/// Behaviours that end anywhere within half a metre; simulation is in `doubt` of each.
struct SimulatedBehavior {
  Genome genome;
  Outcome simulated;
};

using Field = std::function<Pose2(const SimulatedBehavior&)>;  // where the robot ends

class Disparities : public testing::Test {
 protected:
  SimulatedBehavior behavior(double doubt = 0.0) {
    SimulatedBehavior drawn;
    drawn.genome.resize(kGenes);
    for (auto& level : drawn.genome) level = static_cast<std::uint8_t>(random_.below(kGeneLevels));
    drawn.genome = canonical(drawn.genome);
    drawn.simulated = walkedTo(
        {random_.uniform(-0.5, 0.5), random_.uniform(-0.5, 0.5), random_.uniform(-1.0, 1.0)});
    drawn.simulated.cost += doubt;
    return drawn;
  }

  std::vector<RobotTrial> trials(int count, const Field& robot) {
    std::vector<RobotTrial> made;
    for (int i = 0; i < count; ++i) {
      const SimulatedBehavior tried = behavior();
      made.push_back(
          {0, tried.genome, tried.simulated.end_pose, tried.simulated.cost, robot(tried)});
    }
    return made;
  }

  /// Root mean square of what is left of the position over behaviours that were not tried.
  double left_m(const DisparityModel& model, const Field& robot) {
    double sum = 0.0;
    for (int i = 0; i < 200; ++i) {
      const SimulatedBehavior asked = behavior();
      const Disparity expected = model.expected(asked.genome, asked.simulated);
      const Pose2& end = asked.simulated.end_pose;
      const Pose2 measured = robot(asked);
      sum += std::pow(end.x_m + expected.shift.x_m - measured.x_m, 2) +
             std::pow(end.y_m + expected.shift.y_m - measured.y_m, 2);
    }
    return std::sqrt(sum / 200.0);
  }

  Random random_{11};
  FeatureScales scales_{0.3, kGeneLevels, {}};
};

TEST_F(Disparities, ThatGrowWithTheWayAreFoundOfTenTrials) {
  // 12 % short everywhere: 0.12 * 0.41 m in the root mean square over the square of 1 m.
  const Field robot = [](const SimulatedBehavior& asked) {
    const Pose2& end = asked.simulated.end_pose;
    return Pose2{0.88 * end.x_m, 0.88 * end.y_m, 0.88 * end.yaw_rad};
  };
  const DisparityModel model(scales_, 4.0, trials(10, robot));
  EXPECT_LT(left_m(model, robot), 0.1 * 0.12 * 0.41);
}

TEST_F(Disparities, ThatBendOverEndPosesAreFoundOfMany) {
  const Field robot = [](const SimulatedBehavior& asked) {
    Pose2 end = asked.simulated.end_pose;
    end.y_m += 0.05 * std::cos(4.0 * end.x_m);
    return end;
  };
  const DisparityModel few(scales_, 4.0, trials(10, robot)), many(scales_, 4.0, trials(80, robot));
  EXPECT_LT(left_m(many, robot), 0.5 * left_m(few, robot));
  EXPECT_LT(left_m(many, robot), 0.01);
}

TEST_F(Disparities, OfOneKindOfGaitAreToldFromThoseOfAnother) {
  // Those in which the first leg moves far end 6 cm to the left.
  const Field robot = [](const SimulatedBehavior& asked) {
    Pose2 end = asked.simulated.end_pose;
    end.y_m += asked.genome[0] >= 2 ? 0.06 : 0.0;
    return end;
  };
  const DisparityModel model(scales_, 4.0, trials(150, robot));
  // Without the gait 3 cm to either side are left.
  EXPECT_LT(left_m(model, robot), 0.027);
}

TEST_F(Disparities, OfImagesAreImagesWhereThatExplainsMore) {
  const Field robot = [](const SimulatedBehavior& asked) {
    Pose2 end = asked.simulated.end_pose;
    end.x_m -= 0.05 * std::cos(5.0 * end.y_m);  // even
    end.y_m += 0.05 * std::sin(5.0 * end.y_m);  // odd
    return end;
  };
  const auto tried = trials(25, robot);
  const DisparityModel plain(scales_, 4.0, tried);
  scales_.symmetries = {leftRight()};
  const DisparityModel symmetric(scales_, 4.0, tried);
  EXPECT_LT(left_m(symmetric, robot), 0.9 * left_m(plain, robot));
  const SimulatedBehavior asked = behavior();
  const Disparity one = symmetric.expected(asked.genome, asked.simulated);
  const Disparity other =
      symmetric.expected(leftRight().image(asked.genome), leftRight().image(asked.simulated));
  EXPECT_NEAR(other.shift.x_m, one.shift.x_m, 1e-9);
  EXPECT_NEAR(other.shift.y_m, -one.shift.y_m, 1e-9);
}

TEST_F(Disparities, OfALopsidedRobotAreNotMirrored) {
  scales_.symmetries = {leftRight()};
  const Field robot = [](const SimulatedBehavior& asked) {
    Pose2 end = asked.simulated.end_pose;
    end.y_m += 0.05;
    return end;
  };
  // Were images taken for images, all of the 5 cm would be left.
  EXPECT_LT(left_m(DisparityModel(scales_, 4.0, trials(40, robot)), robot), 0.02);
}

TEST_F(Disparities, AreLargerInDoubtWhereSimulationIs) {
  std::vector<RobotTrial> tried;
  for (int i = 0; i < 60; ++i) {
    const double doubt = i % 2 == 0 ? 0.0 : 0.1;
    const SimulatedBehavior one = behavior(doubt);
    Pose2 end = one.simulated.end_pose;
    end.x_m += (0.001 + 0.4 * doubt) * random_.normal();
    end.y_m += (0.001 + 0.4 * doubt) * random_.normal();
    tried.push_back({0, one.genome, one.simulated.end_pose, one.simulated.cost, end});
  }
  const DisparityModel model(scales_, 4.0, tried);
  SimulatedBehavior asked = behavior();
  const double sure_m = model.expected(asked.genome, asked.simulated).deviation_m;
  const double sure_cost = model.disparity(asked.genome, asked.simulated);
  asked.simulated.cost += 0.1;
  // 4 cm per axis were put in.
  const double unsure_m = model.expected(asked.genome, asked.simulated).deviation_m;
  EXPECT_GT(unsure_m, 0.03);
  EXPECT_LT(unsure_m, 0.09);
  EXPECT_LT(sure_m, 0.02);
  EXPECT_GT(model.disparity(asked.genome, asked.simulated), sure_cost);
}

TEST_F(Disparities, CostTheirRootMeanSquareTimesTheWeight) {
  const DisparityModel model(scales_, 4.0, trials(10, [](const SimulatedBehavior& asked) {
                               return Pose2{0.8 * asked.simulated.end_pose.x_m, 0.0, 0.0};
                             }));
  const SimulatedBehavior asked = behavior();
  const Disparity expected = model.expected(asked.genome, asked.simulated);
  const double square_m2 = std::pow(expected.shift.x_m, 2) + std::pow(expected.shift.y_m, 2) +
                           std::pow(expected.deviation_m, 2);
  EXPECT_NEAR(model.disparity(asked.genome, asked.simulated), 4.0 * std::sqrt(square_m2), 1e-12);
}

TEST_F(Disparities, MoveWhatIsExpectedOfAnEntryAndWidenItsSpread) {
  const DisparityModel model(scales_, 4.0, trials(20, [](const SimulatedBehavior& asked) {
                               Pose2 end = asked.simulated.end_pose;
                               end.x_m += 0.05;
                               end.yaw_rad += 0.1;
                               return end;
                             }));
  const SimulatedBehavior asked = behavior();
  Entry entry;
  entry.genome = asked.genome;
  entry.end_pose = asked.simulated.end_pose;
  entry.cost = asked.simulated.cost;
  entry.execution = Execution{entry.end_pose, 0.004, 0.02, 8, 0};
  const Disparity expected = model.expected(asked.genome, asked.simulated);
  const Execution there = model.onRobot(entry);
  EXPECT_NEAR(there.mean.x_m, entry.end_pose.x_m + 0.05, 0.015);
  EXPECT_NEAR(there.mean.yaw_rad, entry.end_pose.yaw_rad + 0.1, 0.03);
  EXPECT_NEAR(there.spread_m, std::hypot(0.004, expected.deviation_m), 1e-12);
  EXPECT_NEAR(there.spread_rad, std::hypot(0.02, expected.deviation_rad), 1e-12);
  EXPECT_EQ(there.falls, 0);
}

TEST_F(Disparities, OfOneThatFellLeaveItOutAndCostWhatItDidNotWalk) {
  auto tried = trials(20, [](const SimulatedBehavior& asked) { return asked.simulated.end_pose; });
  SimulatedBehavior fallen = behavior();
  fallen.simulated = walkedTo({0.4, 0.0, 0.0});
  const double before =
      DisparityModel(scales_, 4.0, tried).disparity(fallen.genome, fallen.simulated);
  tried.push_back({0, fallen.genome, fallen.simulated.end_pose, fallen.simulated.cost, {}});
  const DisparityModel model(scales_, 4.0, tried);
  EXPECT_GT(model.disparity(fallen.genome, fallen.simulated), before);
  Entry entry;
  entry.genome = fallen.genome;
  entry.end_pose = fallen.simulated.end_pose;
  entry.execution = Execution{entry.end_pose, 0.004, 0.02, 8, 0};
  entry.execution = model.onRobot(entry);
  EXPECT_FALSE(entry.usable());
}

}  // namespace
}  // namespace hexapod
