#include "self_model/caution.h"

#include <algorithm>

#include "planning/move.h"

namespace hexapod {
namespace {

// Of legs out of order, limp ones alone throw a robot over that does not know of them. What the
// caution costs an intact one: results/self_model.md.
constexpr double kPricePerBody = 0.6;
constexpr double kMostPrice = 1.2;
// So many are played before it is asked whether they are still wanted.
constexpr std::size_t kAtOnce = 192;

bool hasLimpLeg(const BelievedBody& body) {
  return std::any_of(body.legs.begin(), body.legs.end(),
                     [](const LegState& leg) { return leg.condition == LegCondition::kLimp; });
}

}  // namespace

std::shared_ptr<const std::vector<double>> cautionOf(const Imagination& imagination,
                                                     const BodyBelief& belief,
                                                     const Repertoire& repertoire,
                                                     const PlannerOptions& planner,
                                                     const std::function<bool()>& stop) {
  auto prices = std::make_shared<std::vector<double>>(repertoire.entries.size(), 0.0);
  const std::vector<Move> moves = usableMoves(repertoire, planner, {});
  for (const BelievedBody& body : belief.bodies()) {
    if (!hasLimpLeg(body)) continue;
    const Imagination::Question question{belief.physicsOf(body), &body.stand};
    for (std::size_t begin = 0; begin < moves.size(); begin += kAtOnce) {
      if (stop && stop()) return nullptr;
      std::vector<std::size_t> entries;  // of which it is worth knowing
      std::vector<Genome> genomes;
      for (std::size_t i = begin; i < std::min(begin + kAtOnce, moves.size()); ++i) {
        if ((*prices)[moves[i].entry] >= kMostPrice) continue;
        entries.push_back(moves[i].entry);
        genomes.push_back(repertoire.entries[moves[i].entry].genome);
      }
      const std::vector<Outcome> outcomes = imagination.playAll(genomes, question);
      for (std::size_t i = 0; i < entries.size(); ++i) {
        double& price = (*prices)[entries[i]];
        if (!outcomes[i].walked()) price = std::min(price + kPricePerBody, kMostPrice);
      }
    }
  }
  return prices;
}

}  // namespace hexapod
