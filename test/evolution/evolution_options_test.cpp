#include "evolution/evolution_options.h"

#include <gtest/gtest.h>

#include "evolution/br_evolution.h"

namespace hexapod {
namespace {

std::string complaintAbout(const EvolutionOptions& options) {
  try {
    requireValid(options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(EvolutionOptions, DefaultsAreThePapersAndValid) {
  const EvolutionOptions options;
  EXPECT_EQ(options.population_size, 100);
  EXPECT_EQ(options.neighbours, 15);
  EXPECT_EQ(options.novelty_threshold_m, 0.10);
  EXPECT_EQ(options.mutation_rate, 0.10);
  EXPECT_EQ(options.diversity, "genotypic");
  EXPECT_EQ(complaintAbout(options), "");
}

TEST(EvolutionOptions, AreSetByName) {
  EvolutionOptions options;
  applyOptions(declareOptions(options),
               {{"population_size", std::int64_t{50}}, {"novelty_threshold_m", 0.05}}, "a test");
  EXPECT_EQ(options.population_size, 50);
  EXPECT_EQ(options.novelty_threshold_m, 0.05);
}

TEST(EvolutionOptions, OutOfRangeIsRefusedNamingKeyValueAndRange) {
  EvolutionOptions options;
  options.mutation_rate = 1.5;
  EXPECT_NE(complaintAbout(options).find("mutation_rate is 1.5"), std::string::npos);
  options = {};
  options.diversity = "none";
  EXPECT_NE(complaintAbout(options).find("genotypic"), std::string::npos);
  options = {};
  options.population_size = 0;
  EXPECT_NE(complaintAbout(options), "");
  EXPECT_THROW(BrEvolution(options, 24, Random(1)), std::invalid_argument);
  EXPECT_THROW(BrEvolution({}, 0, Random(1)), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
