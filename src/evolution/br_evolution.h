#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evolution/evolution_options.h"
#include "evolution/generational.h"
#include "evolution/individual.h"
#include "evolution/neighbourhood.h"
#include "repertoire/archive.h"

namespace hexapod {

/// BR-Evolution: Algorithm 1 of Cully & Mouret (2013).
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
/// - novelty_decay: the novelty threshold goes down as candidates are evaluated.
/// - candidates: a generation has more of them, or fewer, than the population individuals.
/// - judgeBy(): transferability is a third objective of the selection, and part of what local
///   competition and the archive compare.
/// And in a task with further looks only individuals whose outcome is final are offered to the
/// archive. Of parents and candidates those are looked at again, and yet again, that the archive of
/// that moment would take by the outcome they have, themselves or a twin of theirs; who turns out
/// to fall is then counted among the fallen.
class BrEvolution : public Generational {
 public:
  /// A new run. Throws std::invalid_argument naming an option, or a number of the space, that is
  /// out of range. The task's symmetries give twins.
  BrEvolution(const EvolutionOptions& options, const Task& task, const Random& random);

  /// Goes on from state() of another evolution with the same options and task.
  /// Throws std::invalid_argument as above, or when the state does not fit.
  BrEvolution(const EvolutionOptions& options, const Task& task, const EvolutionState& state);

  const std::vector<Entry>& entries() const override { return archive_.entries(); }
  const Archive& archive() const { return archive_; }
  /// rho of the next generation [m].
  double noveltyThreshold() const { return novelty_threshold_m_; }

 private:
  std::vector<Genome> breed(std::size_t count, Random& random) const override;
  std::vector<std::size_t> promising(const std::vector<Individual>& pool, int looks) const override;
  void finish(Pool pool) override;
  void judgeEntries() override;

  bool isPromising(const Individual& individual, const Neighbourhood& neighbourhood) const;
  std::vector<Objectives> offerToArchive(Pool& pool);
  OfferResult offer(const Individual& individual, double novelty_m, Neighbourhood& neighbourhood);

  EvolutionOptions options_;
  double novelty_threshold_m_;
  Archive archive_;
};

}  // namespace hexapod
