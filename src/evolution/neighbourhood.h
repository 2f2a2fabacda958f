#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "evolution/individual.h"
#include "evolution/nsga2.h"
#include "repertoire/archive.h"

namespace hexapod {

/// Objectives of an individual that reached no end pose: worse than those of any that did.
constexpr Objectives kFailed = {-1.0, -1.0, -std::numeric_limits<double>::infinity()};

/// neigh(i) of Algorithm 1: the nearest individuals among population and archive, by the archive's
/// metric; of equally distant ones those with the lower ids.
///
/// Population and archive are read as *one set of controllers*: an individual is no neighbour of
/// itself, nor is its copy in the archive, and a controller that occurs twice counts once.
/// (Counting copies makes every known behaviour look less novel and ends in sparser repertoires.)
/// Individuals without an end pose are nobody's neighbours. The archive must outlive this, and
/// every change of it during the generation must be told. Const functions may be called from any
/// thread.
class Neighbourhood {
 public:
  Neighbourhood(const Archive& archive, const std::vector<Individual>& pool,
                std::size_t neighbours);

  /// What an individual sees around it, and as far as it looks.
  struct View {
    /// {novelty [m], local competition, transferability} of an individual of the pool.
    /// Novelty (eq. 1): mean distance to the neighbours; infinite when there are none.
    /// Local competition (eq. 2): the number of neighbours with the *larger* price. Eq. 2 as
    /// printed counts the smaller ones; Algorithm 1 and the text ("outperforms") decide.
    /// Transferability: the disparity with its sign changed, which is part of the price, too; 0
    /// where nothing is known of a robot.
    Objectives objectives = kFailed;
    double reach_m2 = 0.0;    ///< square of the distance of the last neighbour
    std::size_t changes = 0;  ///< so many were known then
  };
  View view(const Individual& individual) const;

  /// What it would see now: it looks again only where something has changed in its reach.
  void refresh(const Individual& individual, View& view) const;

  Objectives objectives(const Individual& individual) const { return view(individual).objectives; }

  /// Whether the archive as it is would take the individual, whose genome is not in it: its price
  /// is less than that of the entry nearest to it, or its novelty is above the threshold. Quick
  /// where entries are dense.
  bool isWanted(const Individual& individual, double threshold_m) const;

  /// The archive took the individual, in the place of an entry where one had to leave.
  void moveToArchive(const Individual& individual, const std::optional<Entry>& displaced);
  /// What left the archive goes on in the pool.
  void moveToPool(const Individual& individual);

 private:
  struct Rival {
    double squared_distance_m2;
    std::int64_t id;
    double price;
  };
  struct Member {
    explicit Member(const Individual& individual);

    Pose2 end;
    std::int64_t id;
    double price;
    Genome genome;
  };
  /// The nearest in the archive, the nearest first, neighbours_ or one more if there are as many.
  std::vector<Rival> entriesAround(const Individual& individual) const;
  /// The neighbours, among the crowd and those entries.
  std::vector<Rival> rivals(const Individual& individual, std::vector<Rival> entries) const;
  /// Of the distances of the first so many; infinite when there are none.
  static double mean_m(const std::vector<Rival>& rivals, std::size_t count);

  const Archive* archive_;
  std::size_t neighbours_;
  std::vector<Member> crowd_;   // what walked in the pool and is not in the archive, once each
  std::vector<Pose2> changes_;  // where something entered or left, one after the other
};

}  // namespace hexapod
