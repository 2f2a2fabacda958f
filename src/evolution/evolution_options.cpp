#include "evolution/evolution_options.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hexapod {
namespace {

bool withinRange(const Option& option) {
  if (const auto* integer = std::get_if<std::int64_t*>(&option.target)) {
    const auto value = static_cast<double>(**integer);
    return value >= option.min && value <= option.max;
  }
  if (const auto* number = std::get_if<double*>(&option.target)) {
    return **number >= option.min && **number <= option.max;
  }
  if (const auto* text = std::get_if<std::string*>(&option.target)) {
    return std::count(option.choices.begin(), option.choices.end(), **text) > 0;
  }
  return true;
}

}  // namespace

std::vector<Option> declareOptions(EvolutionOptions& options) {
  return {
      option("population_size", options.population_size, "Individuals in the population.", 1,
             100000),
      option("candidates", options.candidates,
             "Candidates of a generation: many keep many threads and their registers busy. 0: as "
             "many as population_size.",
             0, 1000000),
      option("neighbours", options.neighbours,
             "Nearest individuals that novelty and local competition look at.", 1, 10000),
      option("novelty_threshold_m", options.novelty_threshold_m, "m",
             "Mean distance to the neighbours above which an end point enters the archive.", 0.0,
             10.0),
      option(
          "heading_m_per_rad", options.heading_m_per_rad, "m/rad",
          "What a radian between the headings of two ends counts in their distance, so that ends "
          "of one place and several headings are all new: side steps, turns on the spot. 0: "
          "positions alone.",
          0.0, 100.0),
      option("mutation_rate", options.mutation_rate, "",
             "Probability that a gene of a child is drawn anew.", 0.0, 1.0),
      option("diversity", options.diversity,
             "What keeps the individuals of one front apart: their genotypes or their objectives.",
             {"genotypic", "crowding"}),
      option("swap", options.swap,
             "An entry that is swapped out takes the better individual's place in the population "
             "(exchange), or is dropped while the individual stays there too (copy).",
             {"exchange", "copy"}),
      option("offer_twins", options.offer_twins,
             "Offer the mirror images of every candidate to the archive: a symmetric robot walks "
             "them as well, without any simulation."),
      option("archive_parents", options.archive_parents, "",
             "Share of the parents that are drawn from the archive instead of the population.", 0.0,
             1.0),
      option("archive_tournament", options.archive_tournament,
             "A parent drawn from the archive gives way to the entry of the least orientation "
             "error among so many that are nearest to it, itself included; 1: it never does.",
             1, 10000),
      option("novelty_decay", options.novelty_decay, "",
             "The novelty threshold goes down in proportion to this power of the candidates "
             "evaluated, so that a repertoire is about as dense as it can well be whenever its "
             "budget ends; 0: it stays.",
             0.0, 2.0),
      option("novelty_decay_from", options.novelty_decay_from,
             "It does not go down before so many candidates.", 1, 1000000000),
      option("novelty_threshold_min_m", options.novelty_threshold_min_m, "m",
             "It goes no further down than this.", 0.0, 10.0),
  };
}

PoseMetric metricOf(const EvolutionOptions& options) { return {options.heading_m_per_rad}; }

double noveltyThresholdAfter(std::int64_t evaluations, const EvolutionOptions& options) {
  const double start_m = options.novelty_threshold_m;
  if (options.novelty_decay <= 0.0 || evaluations <= options.novelty_decay_from) return start_m;
  const double times =
      static_cast<double>(evaluations) / static_cast<double>(options.novelty_decay_from);
  const double decayed_m = start_m * std::pow(times, -options.novelty_decay);
  return std::min(start_m, std::max(options.novelty_threshold_min_m, decayed_m));
}

void requireValid(const EvolutionOptions& options) {
  EvolutionOptions copy = options;
  for (const Option& option : declareOptions(copy)) {
    if (withinRange(option)) continue;
    throw std::invalid_argument("The option " + option.name + " is " + option.text() +
                                ": expected " + option.range() + ".");
  }
}

}  // namespace hexapod
