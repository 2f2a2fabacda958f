#pragma once

#include <cstddef>
#include <vector>

#include "evolution/individual.h"
#include "evolution/nsga2.h"
#include "repertoire/archive.h"

namespace hexapod {

/// Objectives of an individual that reached no end pose: worse than those of any that did.
constexpr Objectives kFailed = {-1.0, -1.0};

/// neigh(i) of Algorithm 1: the nearest individuals among population and archive, by distance
/// between end positions; of equally distant ones those with the lower ids.
///
/// Population and archive are read as *one set of controllers*: an individual is no neighbour of
/// itself, nor is its copy in the archive, and a controller that occurs twice counts once.
/// (Counting copies makes every known behaviour look less novel and ends in sparser repertoires.)
/// Individuals without an end pose are nobody's neighbours. The archive must outlive this, and
/// every change of it during the generation must be told.
class Neighbourhood {
 public:
  Neighbourhood(const Archive& archive, const std::vector<Individual>& pool,
                std::size_t neighbours);

  /// {novelty [m], local competition} of an individual of the pool.
  /// Novelty (eq. 1): mean distance to the neighbours; infinite when there are none.
  /// Local competition (eq. 2): the number of neighbours with the *larger* orientation error. Eq. 2
  /// as printed counts the smaller ones; Algorithm 1 and the text ("outperforms") decide.
  Objectives objectives(const Individual& individual) const;

  /// Whether its novelty is above the threshold; quick where entries are dense.
  bool isNovel(const Individual& individual, double threshold_m) const;

  /// The individual entered the archive.
  void moveToArchive(const Individual& individual);
  /// The individual left the archive.
  void moveToPool(const Individual& individual);

 private:
  struct Rival {
    double squared_distance_m2;
    std::int64_t id;
    double cost;
  };
  /// The nearest in the archive, the nearest first, neighbours_ or one more if there are as many.
  std::vector<Rival> entriesAround(const Individual& individual) const;
  std::vector<Rival> rivals(const Individual& individual) const;

  const Archive* archive_;
  std::size_t neighbours_;
  std::vector<Individual> crowd_;  // what walked in the pool and is not in the archive, once each
};

}  // namespace hexapod
