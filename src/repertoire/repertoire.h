#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "repertoire/entry.h"
#include "repertoire/robot_trial.h"

namespace hexapod {

/// What is left of a repertoire in worlds that learning does not use: medians over them.
struct HeldOut {
  double sparseness_m = 0.0;
  double median_orientation_error_rad = 0.0;
  double median_shift_m = 0.0;  ///< of end positions, from where they are expected
};

/// One line of a learning run's history.
struct HistoryRow {
  std::int64_t evaluations = 0;
  std::int64_t archive_size = 0;
  double sparseness_m = 0.0;  ///< 0 while the archive is empty, as the next two
  double median_orientation_error_rad = 0.0;
  double max_reach_m = 0.0;
  double elapsed_s = 0.0;
  std::optional<HeldOut> held_out;  ///< now and then, and at the end
};

/// A learned repertoire as it is stored, published and planned with.
struct Repertoire {
  std::string run_id;    ///< names the learning run; entry ids are unique within it
  std::string robot_id;  ///< RobotDescription::digest of the robot it was learned for
  std::uint64_t seed = 0;
  std::int64_t generation = 0;
  std::int64_t evaluations = 0;
  double behavior_duration_s = 0.0;            ///< of every entry, return to neutral included
  std::vector<std::string> joint_names;        ///< those a genome moves, in the robot's joint order
  std::map<std::string, std::string> options;  ///< every option of the run, by name, as text
  std::map<std::string, std::string> facts;    ///< what else is known of it, by name, as text
  std::vector<Entry> entries;
  std::vector<HistoryRow> history;
  std::vector<RobotTrial> trials;  ///< in the order in which they were made

  /// Levels of the entries' genes: what the option gene_levels says, the paper's five without it.
  /// Throws std::invalid_argument when it says no number 1 .. 256.
  std::size_t geneLevels() const;

  /// The text of the body it was learned for; empty: the robot as its files describe it.
  std::string body() const {
    const auto found = options.find("body");
    return found == options.end() ? "" : found->second;
  }
};

}  // namespace hexapod
