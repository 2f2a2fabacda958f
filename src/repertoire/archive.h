#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <unordered_set>
#include <vector>

#include "gait/genome_hash.h"
#include "repertoire/entry.h"
#include "repertoire/point_index.h"

namespace hexapod {

/// What became of a candidate.
enum class AddStatus {
  kAdded,    ///< it was new: one entry more
  kSwapped,  ///< it was better than the entry nearest to it and took its place
  kRejected  ///< neither, or its genome is in the archive already
};

struct OfferResult {
  AddStatus status = AddStatus::kRejected;
  std::optional<Entry> displaced;  ///< the entry that had to leave; only when kSwapped
};

/// The unstructured archive of BR-Evolution (Cully & Mouret 2013, section 3 and Algorithm 1): the
/// entries found so far, looked up by where they end.
///
/// It never shrinks; a swap never worsens a price (Entry); ids and genomes are unique in it.
/// Nearest means by the archive's metric, the paper's has end positions as learned alone, without
/// their headings; of equally near entries the one with the lower id. Answers do not depend on the
/// order of the entries. Const functions may be called from any thread.
class Archive {
 public:
  explicit Archive(const PoseMetric& metric = {}) : index_(metric) {}
  /// Throws std::invalid_argument naming the entry when a pose is not finite, an orientation error
  /// not finite or negative, or an id or genome occurs twice.
  explicit Archive(const std::vector<Entry>& entries, const PoseMetric& metric = {});

  /// Algorithm 1: adds the candidate when its novelty is above the threshold; otherwise swaps it
  /// with its nearest entry when its price, in the paper the orientation error, is smaller. Never
  /// both: an offer that adds leaves the entry nearest to it alone, because their ends are apart.
  /// An empty archive has nothing to swap with. Throws std::invalid_argument as the constructor
  /// does, genome excepted.
  OfferResult offer(const Entry& candidate, double novelty_m, double novelty_threshold_m);

  /// What is known of a robot has changed.
  void setDisparities(const std::function<double(const Entry&)>& disparity);

  const std::vector<Entry>& entries() const { return entries_; }
  std::size_t size() const { return entries_.size(); }
  const PoseMetric& metric() const { return index_.metric(); }
  bool contains(const Genome& genome) const { return genomes_.count(genome) > 0; }

  /// The `count` entries nearest to an end, or all when there are fewer; slots index entries().
  std::vector<Neighbour> nearest(const Pose2& end, std::size_t count) const {
    return index_.nearest(end, count);
  }

 private:
  void requireValid(const Entry& entry) const;
  void add(const Entry& entry);
  Entry replace(std::size_t slot, const Entry& entry);

  std::vector<Entry> entries_;
  PointIndex index_;
  std::unordered_set<std::int64_t> ids_;
  std::unordered_set<Genome, GenomeHash> genomes_;
};

}  // namespace hexapod
