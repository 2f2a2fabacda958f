#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/options.h"
#include "geometry/pose_metric.h"

namespace hexapod {

/// Parameters of BR-Evolution; the defaults are the paper's (Cully & Mouret 2013, appendix A), the
/// options it does not know are off.
struct EvolutionOptions {
  std::int64_t population_size = 100;  ///< individuals that are kept as parents, >= 1
  std::int64_t candidates = 0;         ///< of one generation; 0: as many as population_size
  std::int64_t neighbours = 15;        ///< |neigh(i)| of eq. 1, >= 1
  double novelty_threshold_m = 0.10;   ///< rho in the paper [m]; more novel ends enter the archive
  double heading_m_per_rad = 0.0;      ///< of a radian between ends; 0 (the paper): positions alone
  double mutation_rate = 0.10;         ///< probability that a gene is drawn anew, 0 .. 1
  std::string diversity = "genotypic";  ///< inside a front: genotypic (the paper) | crowding
  std::string swap = "exchange";        ///< what leaves the archive: exchange (the paper) | copy
  bool offer_twins = false;      ///< offer the mirror images of every candidate to the archive, too
  double archive_parents = 0.0;  ///< share of parents drawn from the archive, 0 .. 1
  /// Entries around an archive parent, itself included, of which the best aligned takes its place,
  /// >= 1; 1: the parent as drawn.
  std::int64_t archive_tournament = 1;
  /// The novelty threshold goes down with the power -novelty_decay of the candidates evaluated,
  /// from novelty_decay_from on and as far as novelty_threshold_min_m; 0: it stays.
  double novelty_decay = 0.0;
  std::int64_t novelty_decay_from = 1000;
  double novelty_threshold_min_m = 0.01;

  std::int64_t candidatesPerGeneration() const {
    return candidates > 0 ? candidates : population_size;
  }
};

/// By which ends are near each other.
PoseMetric metricOf(const EvolutionOptions& options);

/// The novelty threshold for the generation that begins after so many candidates [m].
double noveltyThresholdAfter(std::int64_t evaluations, const EvolutionOptions& options);

/// The options with name, unit, range and meaning, bound to `options`.
std::vector<Option> declareOptions(EvolutionOptions& options);

/// Throws std::invalid_argument naming key, value and allowed range of the first that is out of it.
void requireValid(const EvolutionOptions& options);

}  // namespace hexapod
