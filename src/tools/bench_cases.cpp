#include "tools/bench_cases.h"

#include <cmath>

namespace hexapod {
namespace {

constexpr double kReach_m = 0.9;

constexpr double kBodyMass_kg = 1.031;
constexpr double kFemurMass_kg = 0.184;
constexpr double kTibiaMass_kg = 0.040;
constexpr double kTibiaLength_m = 0.095;

void setMass(Body& body, double mass_kg) {
  body.inertia_kg_m2 *= mass_kg / body.mass_kg;
  body.mass_kg = mass_kg;
}

/// A limb of one capsule, whose overall length includes the caps.
void setLength(Body& limb, double length_m) {
  Shape& capsule = limb.shapes.at(0);
  const double ratio = length_m / (capsule.length_m + 2.0 * capsule.radius_m);
  capsule.length_m = length_m - 2.0 * capsule.radius_m;
  capsule.body_from_shape.translation() *= ratio;
  limb.center_of_mass_m *= ratio;
  limb.inertia_kg_m2 *= ratio * ratio;
}

}  // namespace

RobotDescription laterRobot(RobotDescription robot) {
  setMass(robot.base, kBodyMass_kg);
  for (Leg& leg : robot.legs) {
    setMass(leg.segments.at(1).body, kFemurMass_kg);
    setMass(leg.segments.at(2).body, kTibiaMass_kg);
    setLength(leg.segments.at(2).body, kTibiaLength_m);
  }
  return robot;
}

std::vector<BenchCase> benchCases(const RobotDescription& shipped) {
  const RobotDescription later = laterRobot(shipped);
  Physics fine;
  fine.step_s = 0.005;
  return {{"2013, 15 ms", shipped, Physics()},
          {"2013, 5 ms", shipped, fine},
          {"2015, 15 ms", later, Physics()},
          {"2015, 5 ms", later, fine}};
}

std::vector<Genome> randomGenomes(std::size_t count, std::size_t gene_count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Genome> genomes(count, Genome(gene_count));
  for (Genome& genome : genomes) {
    for (std::uint8_t& gene : genome) gene = static_cast<std::uint8_t>(random.below(kGeneLevels));
    genome = canonical(genome);
  }
  return genomes;
}

Outcome anywhere(Random& random) {
  const double radius_m = kReach_m * std::sqrt(random.uniform());
  const double direction_rad = random.uniform(-M_PI, M_PI);
  return walkedTo({radius_m * std::cos(direction_rad), radius_m * std::sin(direction_rad),
                   random.uniform(-M_PI, M_PI)});
}

std::vector<Entry> spreadArchive(std::size_t size, std::size_t gene_count) {
  Random random(3);
  std::vector<Entry> entries;
  for (const Genome& genome : randomGenomes(size, gene_count, 4)) {
    Entry entry;
    entry.id = static_cast<std::int64_t>(1000000000 + entries.size());
    entry.genome = genome;
    const Outcome outcome = anywhere(random);
    entry.end_pose = outcome.end_pose;
    entry.cost = 0.01 * outcome.cost;
    entries.push_back(entry);
  }
  return entries;
}

}  // namespace hexapod
