#include "self_model/imagination.h"

#include <gtest/gtest.h>

#include "common/random.h"
#include "execution/shipped_robot.h"
#include "self_model/walked_body.h"

namespace hexapod {
namespace {

using Joints = Imagination::Joints;

// Bodies of the shipped robot that differ in everything a body may, some of which fail.
std::vector<Physics> someBodies(const RobotDescription& robot) {
  std::vector<Physics> bodies;
  Random random(1);
  for (const char* legs : {"", "left_middle: limp", "left_middle: lifted"}) {
    for (int i = 0; i < 11; ++i) {
      Physics body;
      body.legs = legStatesFromText(robot, legs);
      body.friction_scale = 0.5 + random.uniform();
      body.mass_scale = 0.7 + 0.6 * random.uniform();
      body.torque_scale = 0.1 + random.uniform();
      body.servo_gain_scale = 0.6 + 0.8 * random.uniform();
      body.slope_x_rad = 0.1 * random.uniform();
      bodies.push_back(body);
    }
  }
  return bodies;
}

// What several bodies make of a behaviour abreast is, to the bit, what each makes of it alone.
TEST(Imagination, BodiesAbreastDoAsEachAlone) {
  const RobotDescription& robot = shippedRobot();
  const std::vector<Physics> bodies = someBodies(robot);
  const Imagination alone(robot, BehaviorOptions(), Engine::kReduced, 1);
  const auto stands = alone.stands(bodies);
  std::vector<Imagination::Question> questions;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (stands[i]) questions.push_back({bodies[i], &*stands[i]});
  }
  ASSERT_GT(questions.size(), 20u);
  Genome stumbling = walkingGaits().front();
  for (std::size_t gene = 1; gene < stumbling.size(); gene += 2) stumbling[gene] = gene % 5;
  for (const int threads : {1, 3}) {
    const Imagination imagination(robot, BehaviorOptions(), Engine::kReduced, threads);
    int failed = 0;
    for (const Genome& genome : {walkingGaits().front(), stumbling}) {
      const auto abreast = imagination.play(genome, questions, Joints::kIgnored);
      const auto single = imagination.play(genome, questions, Joints::kWatched);
      for (std::size_t i = 0; i < questions.size(); ++i) {
        EXPECT_EQ(abreast[i].verdict, single[i].verdict);
        EXPECT_FALSE(single[i].joints.empty());
        if (single[i].verdict != Verdict::kWalked) ++failed;
        if (single[i].verdict == Verdict::kDiverged) continue;
        EXPECT_EQ(abreast[i].start_from_end.x_m, single[i].start_from_end.x_m);
        EXPECT_EQ(abreast[i].start_from_end.y_m, single[i].start_from_end.y_m);
        EXPECT_EQ(abreast[i].start_from_end.yaw_rad, single[i].start_from_end.yaw_rad);
        EXPECT_EQ(abreast[i].end.values, single[i].end.values);
      }
    }
    EXPECT_GT(failed, 0) << "else half of it is not tried";
  }
}

}  // namespace
}  // namespace hexapod
