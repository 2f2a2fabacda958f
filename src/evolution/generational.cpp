#include "evolution/generational.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace hexapod {
namespace {

/// The outcome, or kDiverged when a number of it is unusable.
Outcome checked(const Outcome& outcome) {
  if (!outcome.walked()) return outcome;
  const bool usable =
      isFinite(outcome.end_pose) && std::isfinite(outcome.cost) && outcome.cost >= 0.0;
  return usable ? outcome : Outcome{};
}

void requireGeneCount(const Genome& genome, std::size_t gene_count, const std::string& owner) {
  if (genome.size() == gene_count) return;
  throw std::invalid_argument(owner + " has " + std::to_string(genome.size()) +
                              " genes: this evolution's genomes have " +
                              std::to_string(gene_count) + ".");
}

void countFailure(Verdict verdict, EvolutionCounters& counters) {
  if (verdict == Verdict::kFell) ++counters.fell;
  if (verdict == Verdict::kSelfCollided) ++counters.self_collided;
  if (verdict == Verdict::kDiverged) ++counters.diverged;
}

}  // namespace

Generational::Generational(std::int64_t size, Task task, bool offers_twins, const Random& random)
    : size_(size), task_(std::move(task)), random_(random) {
  requireValid(task_.space);
  if (!offers_twins) task_.symmetries.clear();
}

void Generational::goOn(const EvolutionState& state) {
  for (const Individual& individual : state.population) {
    requireGeneCount(individual.genotype, space().gene_count,
                     "Individual " + std::to_string(individual.id));
  }
  for (const Entry& entry : state.archive) {
    requireGeneCount(entry.genome, space().gene_count, "Entry " + std::to_string(entry.id));
  }
  random_ = state.random;
  next_id_ = state.next_id;
  counters_ = state.counters;
  population_ = state.population;
  for (Individual& individual : population_) {
    individual.genome = space().canonical(individual.genotype);
  }
}

void Generational::beginWith(std::vector<Genome> genotypes) {
  for (const Genome& genotype : genotypes) {
    requireGeneCount(genotype, space().gene_count, "A genotype to begin with");
  }
  first_ = std::move(genotypes);
}

void Generational::judgeBy(std::shared_ptr<const Transferability> transferability) {
  transferability_ = std::move(transferability);
  for (Individual& individual : population_) {
    individual.disparity = disparityOf(individual.genome, individual.outcome);
  }
  judgeEntries();
}

EvolutionState Generational::state() const {
  return {random_, next_id_, counters_, population_, entries()};
}

const Questions& Generational::ask(std::int64_t most_candidates) {
  if (draft_) return draft_->questions;
  if (most_candidates < 1) {
    throw std::invalid_argument("A generation needs 1 candidate or more, not " +
                                std::to_string(most_candidates) + ".");
  }
  const std::int64_t size = std::max(size_, static_cast<std::int64_t>(first_.size()));
  begin(static_cast<std::size_t>(std::min(size, most_candidates)));
  return draft_->questions;
}

void Generational::tell(const std::vector<Outcome>& outcomes) {
  if (!draft_) throw std::invalid_argument("Outcomes were told that nobody asked for: ask first.");
  const std::size_t asked = draft_->asked.size();
  if (outcomes.size() != asked) {
    throw std::invalid_argument("There are " + std::to_string(outcomes.size()) + " outcomes for " +
                                std::to_string(asked) +
                                " genomes: expected one for each, in the same order.");
  }
  for (std::size_t k = 0; k < asked; ++k) {
    const std::size_t i = draft_->asked[k];
    Individual& individual = draft_->pool.individuals[i];
    const bool had_walked = draft_->questions.look > 1 && individual.outcome.walked();
    individual.outcome = checked(outcomes[k]);
    individual.looks = draft_->questions.look;
    individual.disparity = disparityOf(individual.genome, individual.outcome);
    if (had_walked && !individual.outcome.walked()) ++draft_->failed_later;
    draft_->pool.is_news[i] = true;
  }
  if (draft_->questions.look == 2) draft_->looked_twice = static_cast<std::int64_t>(asked);
  if (!askFurther()) complete();
}

std::vector<Genome> Generational::nextGenotypes(std::size_t count, Random& random) const {
  const std::size_t given = std::min(count, first_.size());
  std::vector<Genome> genotypes(first_.begin(),
                                first_.begin() + static_cast<std::ptrdiff_t>(given));
  for (Genome& bred : breed(count - given, random)) genotypes.push_back(std::move(bred));
  return genotypes;
}

void Generational::begin(std::size_t candidates) {
  Draft draft;
  draft.random = random_;
  draft.candidates = candidates;
  draft.pool.individuals = population_;
  const std::vector<Genome> genotypes = nextGenotypes(candidates, draft.random);
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < candidates; ++i) {
    Individual candidate;
    // The ids in between are for its twins.
    candidate.id = next_id_ + static_cast<std::int64_t>(i * (1 + task_.symmetries.size()));
    candidate.evaluation = counters_.evaluations + static_cast<std::int64_t>(i) + 1;
    candidate.genotype = genotypes[i];
    candidate.genome = space().canonical(genotypes[i]);
    asked.push_back(draft.pool.individuals.size());
    draft.pool.individuals.push_back(std::move(candidate));
  }
  draft.pool.is_news.assign(draft.pool.individuals.size(), false);
  draft_ = std::move(draft);
  askAbout(1, asked);
}

void Generational::askAbout(int look, const std::vector<std::size_t>& asked) {
  Questions questions;
  questions.look = look;
  for (const std::size_t i : asked) {
    const Individual& individual = draft_->pool.individuals[i];
    questions.genomes.push_back(individual.genome);
    if (look > 1) questions.previous.push_back(individual.outcome);
  }
  draft_->asked = asked;
  draft_->questions = std::move(questions);
}

/// Goes on to the next look at which anybody is promising; false when there is none.
bool Generational::askFurther() {
  for (int look = draft_->questions.look + 1; look <= looks(); ++look) {
    const std::vector<std::size_t> asked = promising(draft_->pool.individuals, look - 1);
    if (asked.empty()) continue;
    askAbout(look, asked);
    return true;
  }
  return false;
}

void Generational::complete() {
  Draft draft = std::move(*draft_);
  draft_.reset();
  random_ = draft.random;
  first_.clear();
  next_id_ += static_cast<std::int64_t>(draft.candidates * (1 + task_.symmetries.size()));
  counters_.evaluations += static_cast<std::int64_t>(draft.candidates);
  counters_.looked_twice += draft.looked_twice;
  counters_.failed_later += draft.failed_later;
  for (std::size_t i = 0; i < draft.pool.individuals.size(); ++i) {
    if (draft.pool.is_news[i]) {
      countFailure(draft.pool.individuals[i].outcome.verdict, counters_);
    }
  }
  finish(std::move(draft.pool));
  ++counters_.generations;
}

std::vector<Individual> Generational::twins(const Individual& individual) const {
  std::vector<Individual> twins;
  for (const Symmetry& symmetry : task_.symmetries) {
    Individual twin = individual;
    twin.id = individual.id + 1 + static_cast<std::int64_t>(twins.size());
    twin.genotype = twin.genome = symmetry.image(individual.genome);
    twin.outcome = symmetry.image(individual.outcome);
    twin.disparity = disparityOf(twin.genome, twin.outcome);
    twins.push_back(std::move(twin));
  }
  return twins;
}

}  // namespace hexapod
