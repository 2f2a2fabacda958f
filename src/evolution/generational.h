#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/random.h"
#include "evolution/algorithm.h"
#include "evolution/individual.h"
#include "evolution/task.h"
#include "evolution/transferability.h"

namespace hexapod {

/// What the algorithms of this station have in common: a generation of numbered candidates, who of
/// them is looked at again, what became of them, and a state to go on from.
///
/// A derived class says how candidates are bred, who is promising, and what a complete generation
/// changes. A candidate's twins are its mirror images; their ids follow its own.
class Generational : public Algorithm {
 public:
  const Questions& ask(
      std::int64_t most_candidates = std::numeric_limits<std::int64_t>::max()) final;
  void tell(const std::vector<Outcome>& outcomes) final;
  const EvolutionCounters& counters() const final { return counters_; }

  /// Before the first ask(): the first generation is made of these genotypes, all of them however
  /// many there are, and of bred ones where they are fewer than a generation has. Throws
  /// std::invalid_argument when one has another number of genes.
  void beginWith(std::vector<Genome> genotypes);

  /// Individuals and entries compete by what is known of a robot, too, from the next generation on.
  /// Between generations only. It is no part of the state: who goes on from that calls it again.
  void judgeBy(std::shared_ptr<const Transferability> transferability);

  /// The individuals kept from generation to generation; none where the entries are all there is.
  const std::vector<Individual>& population() const { return population_; }

  /// All that another one with the same options and task needs to go on as this one would.
  EvolutionState state() const;

 protected:
  /// Generations of `size` candidates. Throws std::invalid_argument for a space that is none.
  /// Without `offers_twins` the task's symmetries are not used.
  Generational(std::int64_t size, Task task, bool offers_twins, const Random& random);

  /// Takes over all of the state but the archive. Throws std::invalid_argument when it does not
  /// fit.
  void goOn(const EvolutionState& state);

  const GenomeSpace& space() const { return task_.space; }
  int looks() const { return task_.looks; }
  /// Calls work(i) once for every i < count, perhaps by several threads at once.
  void forEach(std::size_t count, const std::function<void(std::size_t)>& work) const {
    task_.spread(count, work);
  }

  /// What is known of a robot; 0 when nothing is.
  double disparityOf(const Genome& genome, const Outcome& simulated) const {
    return transferability_ && simulated.walked() ? transferability_->disparity(genome, simulated)
                                                  : 0.0;
  }
  double disparityOf(const Entry& entry) const {
    return disparityOf(entry.genome, {Verdict::kWalked, entry.end_pose, entry.cost});
  }

  /// The image of the individual under each symmetry in use.
  std::vector<Individual> twins(const Individual& individual) const;

  /// The pool of a generation: parents, then candidates.
  struct Pool {
    std::vector<Individual> individuals;
    std::vector<bool> is_news;  ///< per individual: this generation has told its outcome
  };

  // The rest of the algorithm. `population_` may be changed by finish() alone.
  virtual std::vector<Genome> breed(std::size_t count, Random& random) const = 0;
  /// Those of the pool, by index, that `looks` looks were taken at and that the archive of this
  /// moment would take, themselves or a twin of theirs, by the outcome they have.
  virtual std::vector<std::size_t> promising(const std::vector<Individual>& pool,
                                             int looks) const = 0;
  /// All answers are in, and counted. Must not throw.
  virtual void finish(Pool pool) = 0;
  /// What is known of a robot has changed: the entries' disparities are to be found anew.
  virtual void judgeEntries() = 0;

  std::vector<Individual> population_;
  EvolutionCounters counters_;

 private:
  /// A generation under way: what would be lost with it.
  struct Draft {
    Random random{0};
    std::size_t candidates = 0;
    std::int64_t looked_twice = 0;
    std::int64_t failed_later = 0;
    Pool pool;
    std::vector<std::size_t> asked;  // of the pool, one per question
    Questions questions;
  };
  void begin(std::size_t candidates);
  std::vector<Genome> nextGenotypes(std::size_t count, Random& random) const;
  void askAbout(int look, const std::vector<std::size_t>& asked);
  bool askFurther();
  void complete();

  std::int64_t size_;
  Task task_;
  Random random_;
  std::int64_t next_id_ = 1;
  std::vector<Genome> first_;  // of the first generation
  std::shared_ptr<const Transferability> transferability_;
  std::optional<Draft> draft_;
};

}  // namespace hexapod
