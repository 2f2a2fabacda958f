#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "evolution/evaluator.h"
#include "evolution/genome_space.h"
#include "gait/genome_hash.h"
#include "gait/symmetry.h"

namespace hexapod {

/// An evaluator that asks another one only about what it has not been told yet.
///
/// Genomes of the same controller are one question, and with symmetries so are the up to four
/// mirror images of a gait: of those the genome that comes first in lexicographic order is asked,
/// the others get the image of its outcome. (Where the evaluator's outcomes are not exactly
/// symmetric, under random perturbations, that is as good an estimate as its own.)
///
/// Outcomes depend on the genome alone: neither on what was asked before nor on what was forgotten.
/// Not thread-safe.
class CachedEvaluator : public Evaluator {
 public:
  /// `capacity`: gaits remembered, the oldest are forgotten first; 0: none, equal gaits of one
  /// batch are one question even so. The evaluator must outlive this.
  CachedEvaluator(Evaluator& evaluator, std::size_t capacity, GenomeSpace space,
                  std::vector<Symmetry> symmetries = {});

  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override;
  int looks() const override { return evaluator_->looks(); }
  std::vector<Outcome> lookAgain(int look, const std::vector<Genome>& genomes,
                                 const std::vector<Outcome>& previous) override;

  /// First looks that were asked for, and those of them that were passed on.
  struct Counts {
    std::int64_t asked = 0;
    std::int64_t passed_on = 0;
    std::int64_t saved() const { return asked - passed_on; }
  };
  const Counts& counts() const { return counts_; }
  std::size_t size() const { return memories_[0].size(); }

 private:
  /// Outcomes of representatives, at most `capacity`.
  class Memory {
   public:
    explicit Memory(std::size_t capacity) : capacity_(capacity) {}
    const Outcome* find(const Genome& genome) const;
    void add(const Genome& genome, const Outcome& outcome);
    std::size_t size() const { return outcomes_.size(); }

   private:
    std::size_t capacity_;
    std::unordered_map<Genome, Outcome, GenomeHash> outcomes_;
    std::deque<Genome> by_age_;
  };

  /// The genome that is asked in place of another, and the way back.
  struct Representative {
    Genome genome;
    const Symmetry* symmetry = nullptr;  // nullptr: the genome itself
    Outcome mapped(const Outcome& outcome) const {
      return symmetry == nullptr ? outcome : symmetry->image(outcome);
    }
  };
  Representative representative(const Genome& genome) const;

  /// Answers from `memory` and, for what is not there, from `ask`(indices of the questions).
  template <typename Ask>
  std::vector<Outcome> answer(const std::vector<Representative>& questions, Memory& memory,
                              const Ask& ask);

  Evaluator* evaluator_;
  GenomeSpace space_;
  std::vector<Symmetry> symmetries_;
  std::vector<Memory> memories_;  // one per look
  Counts counts_;
};

}  // namespace hexapod
