#pragma once

#include <map>
#include <string>

#include "repertoire/digest.h"
#include "repertoire/learner_state.h"
#include "repertoire/sqlite.h"

namespace hexapod {

/// The tables state, population and archive of a repertoire file.

/// Creates those that are not there, and empties them.
extern const char* const kLearnerTables;

/// Format version from which on there are all three; before, state held texts of its learner's own.
constexpr int kLearnerTablesVersion = 3;

void insertLearnerState(const LearnerState& state, SqliteDatabase& database);

/// Throws by fail().
LearnerState readLearnerState(SqliteDatabase& database);

void add(const LearnerState& state, Digest& digest);

/// The rows of a table (key, value), in which values are texts or blobs. Throws by fail().
std::map<std::string, std::string> readPairs(SqliteDatabase& database, const std::string& table);

}  // namespace hexapod
