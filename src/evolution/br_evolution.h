#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "evolution/evaluator.h"
#include "evolution/evolution_options.h"
#include "evolution/genome_space.h"
#include "evolution/individual.h"
#include "evolution/neighbourhood.h"
#include "gait/symmetry.h"
#include "repertoire/archive.h"

namespace hexapod {

/// BR-Evolution: Algorithm 1 of Cully & Mouret (2013), one generation per step.
///
/// Novelty search with local competition on NSGA-II, whose archive is the result: individuals whose
/// end is new enter it, and those that end better aligned than the entry nearest to them are
/// swapped with it. Where the paper is silent or contradicts itself:
/// - Mutation draws each gene anew, with probability mutation_rate, uniformly among all five
/// levels,
///   its own included.
/// - Two genotypes of the same gait are the same controller: identity goes by the canonical genome,
///   while inheritance and genotypic diversity keep the genes that happen to be silent.
/// - A generation looks at parents and children together, as NSGA-II selects among both; parents
///   keep their outcome. What counts as a neighbour and as better: see Neighbourhood.
/// - The archive changes within the loop, so that later individuals meet it as changed. An offer
///   adds or swaps, never both, and a genome is never in the archive twice (see Archive).
/// - "Swapped" is taken literally with swap = exchange: the entry that leaves takes the
/// individual's
///   place in the population, with objectives of its own. With copy it is dropped and the
///   individual stays in the population as well, as it does when it is added.
/// - Individuals that fell, collided or diverged never enter the archive and get the worst
///   objectives; an outcome that is not finite counts as diverged.
/// - Genotypic diversity decides where crowding does in NSGA-II: in the truncation of the last
///   front and in the binary tournament.
///
/// Beyond the paper, each an option that is off by default:
/// - offer_twins: after a candidate its mirror images are offered to the archive. They count
/// neither
///   as evaluations nor as individuals of the population; an entry that leaves for one is dropped.
///   A twin's entry has an id of its own and the evaluation number of its candidate.
/// - archive_parents: some parents are drawn from the archive, uniformly, or with
///   archive_tournament the best aligned of the entries around such a one.
/// - novelty_refinement: the novelty threshold goes down when the archive has filled.
/// And with an evaluator that looks more than once, only individuals whose outcome is final are
/// offered to the archive. At the start of each generation it looks again, and yet again, at those
/// that the archive of that moment would take by the outcome they have, themselves or a twin of
/// theirs; who turns out to fall is then counted among the fallen.
///
/// Same options, evaluator and generator, same archive. Not thread-safe.
class BrEvolution {
 public:
  /// A new run. Throws std::invalid_argument naming an option, or a number of the space, that is
  /// out of range. The evaluator must outlive the evolution.
  /// `symmetries` of the robot give twins.
  BrEvolution(const EvolutionOptions& options, const GenomeSpace& space, Evaluator& evaluator,
              const Random& random, std::vector<Symmetry> symmetries = {});

  /// Goes on from state() of another evolution with the same options and evaluator.
  /// Throws std::invalid_argument as above, or when the state does not fit.
  BrEvolution(const EvolutionOptions& options, const GenomeSpace& space, Evaluator& evaluator,
              const EvolutionState& state, std::vector<Symmetry> symmetries = {});

  /// One generation: evaluates as many candidates as the population has, or `most_candidates` (>=
  /// 1) if that is fewer, so that a budget of evaluations can be met exactly. The first generation
  /// is the random initial population and counts like any other. When the evaluator throws, so does
  /// this, and nothing has changed.
  void step(std::int64_t most_candidates = std::numeric_limits<std::int64_t>::max());

  const Archive& archive() const { return archive_; }
  const std::vector<Individual>& population() const { return population_; }
  const EvolutionCounters& counters() const { return counters_; }
  /// rho, as refined so far [m].
  double noveltyThreshold() const { return novelty_threshold_m_; }
  EvolutionState state() const;

 private:
  std::vector<Individual> nextCandidates(std::size_t count, Random& random) const;
  void evaluate(std::vector<Individual>& candidates) const;
  std::vector<std::size_t> lookAgain(int look, std::vector<Individual>& pool) const;
  bool isPromising(const Individual& individual, const Neighbourhood& neighbourhood) const;
  std::vector<Individual> twins(const Individual& individual) const;
  void countFailures(const std::vector<Individual>& pool, const std::vector<bool>& is_news);
  std::vector<Objectives> offerToArchive(std::vector<Individual>& pool,
                                         const std::vector<bool>& is_news);
  OfferResult offer(const Individual& individual, double novelty_m);
  void refineNovelty(std::int64_t added, std::size_t candidates);

  EvolutionOptions options_;
  std::vector<Symmetry> symmetries_;  // none unless twins are offered
  GenomeSpace space_;
  Evaluator* evaluator_;
  Random random_;
  std::int64_t next_id_ = 1;
  double novelty_threshold_m_;
  EvolutionCounters counters_;
  std::vector<Individual> population_;
  Archive archive_;
};

}  // namespace hexapod
