#pragma once

#include <string>

#include "repertoire/learner_state.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// The hand-over between learning and walking: one SQLite 3 database per repertoire.
///
/// PRAGMA application_id = kApplicationId, user_version = kFormatVersion; tables
///   entries  one row per entry; genome in the form of toString(), its levels below
///            option.gene_levels (5 without); orientation_error_rad is that of the pose,
///            cost what the entry won its place with; the executed_ and spread_ columns are NULL
///            until the entry was validated
///   meta     key and value as text: seed, run_id, robot_id, generation, evaluations,
///            behavior_duration_s, joint_names (comma separated), gene_count, format_version,
///            package_version, option.<name>, fact.<name>; digest over the entries, trial_digest
///            over the trials where there are any, and file_digest over the rest
///   history  a row about every 1000 evaluations; the held_out_ columns are NULL but now and then
///            and at the end
///   trials   controllers tried on the robot, in their order: evaluation, genome, where they end in
///            simulation and where on the robot, measured_ columns NULL where it fell; the table
///            may be missing
///   state, population, archive
///            what the learner needs to go on: values by key, a row for each individual that it
///            breeds from and for each entry of its archive, in its order; dropped: not in entries
/// A checkpoint is one transaction, so a killed process leaves the previous one.
constexpr int kApplicationId = 0x48585250;  // "HXRP"
constexpr int kFormatVersion = 3;
/// Version 1 has no cost: its orientation_error_rad is what version 2 calls so. Such files are
/// read, not written. Version 2 has no tables population and archive, and no run of its can be gone
/// on with; such a file is of this version once it is written.
constexpr int kOldestFormatVersion = 1;
constexpr int kOldestWrittenVersion = 2;

struct StoredRepertoire {
  Repertoire repertoire;
  LearnerState learner_state;  ///< empty when none was saved
};

/// Reads a repertoire file; entries come in the order of their ids. Creates and changes nothing,
/// except that SQLite undoes what a killed writer left half done. May be called while a learner
/// writes the file. Throws std::runtime_error with a sentence naming the file, what was expected
/// and what was found when it is missing, empty, cut short, damaged, another program's, of another
/// format version, or holds illegal genes, poses that are not finite, duplicate ids or genomes,
/// more entries than kMaxEntries, or contents that do not match their digests.
StoredRepertoire loadStoredRepertoire(const std::string& file);

/// The repertoire of loadStoredRepertoire().
Repertoire loadRepertoire(const std::string& file);

/// The learner state of loadStoredRepertoire().
LearnerState loadLearnerState(const std::string& file);

/// 16 hexadecimal digits over the entries, whatever their order.
std::string digestOf(const std::vector<Entry>& entries);

constexpr std::int64_t kMaxEntries = 1000000;
constexpr std::int64_t kMaxGenes = 10000;

}  // namespace hexapod
