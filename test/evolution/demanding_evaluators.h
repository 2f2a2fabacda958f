#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "evolution/analytic_evaluator.h"
#include "evolution/evolution_options.h"
#include "evolution/task.h"
#include "gait/symmetry.h"

namespace hexapod {

constexpr std::size_t kGenes = 16;

/// Legs 0, 1 on the left and 2, 3 on the right side exchange their genes.
inline Symmetry leftRight() {
  std::vector<Symmetry::LegImage> legs(4);
  for (std::size_t leg = 0; leg < 4; ++leg) legs[leg].leg = (leg + 2) % 4;
  return Symmetry(1.0, -1.0, legs);
}

/// A stand-in for a robot with that symmetry: outcomes of images are images of outcomes.
class SymmetricEvaluator : public AnalyticEvaluator {
 public:
  SymmetricEvaluator() : AnalyticEvaluator(7, kGenes) {}
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    calls += 1;
    candidates += static_cast<std::int64_t>(genomes.size());
    std::vector<Outcome> outcomes;
    for (const Genome& genome : genomes) {
      const Genome image = leftRight().image(genome);
      outcomes.push_back(image < genome ? leftRight().image(outcomeOf(image)) : outcomeOf(genome));
    }
    return outcomes;
  }
};

/// The first look knows no falls and no heading; the second one knows the falls, and the last one
/// all. (It may be the same.)
class CarefulEvaluator : public AnalyticEvaluator {
 public:
  explicit CarefulEvaluator(int looks = 2) : AnalyticEvaluator(7, kGenes), looks_(looks) {}
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    std::vector<Outcome> outcomes = AnalyticEvaluator::evaluate(genomes);
    for (Outcome& outcome : outcomes) {
      if (outcome.walked()) outcome.cost *= 0.5;
    }
    return outcomes;
  }
  int looks() const override { return looks_; }
  std::vector<Outcome> lookAgain(int look, const std::vector<Genome>& genomes,
                                 const std::vector<Outcome>& previous) override {
    counts[look] += static_cast<std::int64_t>(genomes.size());
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < genomes.size(); ++i) {
      Outcome outcome = outcomeOf(genomes[i]);
      const double before = look == 2 ? 0.5 : 0.75;
      EXPECT_EQ(previous[i].cost, before * outcome.cost);
      if (look < looks_) outcome.cost *= 0.75;
      if (look == looks_) seen_to_the_end.insert(genomes[i]);
      const bool falls = genomes[i][0] == 4 && genomes[i][4] == 4;
      if (falls) ++fell;
      outcomes.push_back(falls ? Outcome{Verdict::kFell, {}, 0.0} : outcome);
    }
    return outcomes;
  }

  std::set<Genome> seen_to_the_end;
  std::map<int, std::int64_t> counts;  // of genomes, by look
  std::int64_t fell = 0;               // in further looks

 private:
  int looks_;
};

/// Gaits of a robot whose left and right are mirror images.
inline Task pairs() { return {kGenes, 1, {leftRight()}}; }

inline EvolutionOptions withTwins() {
  EvolutionOptions options;
  options.offer_twins = true;
  return options;
}

}  // namespace hexapod
