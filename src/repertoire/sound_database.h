#pragma once

#include <memory>
#include <string>

#include "repertoire/sqlite.h"

namespace hexapod {

/// First half of loading a repertoire file: is this a whole database in our format at all? What is
/// wrong is thrown by fail(), or as SqliteError for which describeDamage() finds better words.

/// Throws std::invalid_argument "expected .., found ..", to be put behind the name of the file.
[[noreturn]] void fail(const std::string& expected, const std::string& found);

/// Refuses what is missing, no ordinary file, unreadable, empty, or no SQLite database.
void requireSqliteFile(const std::string& path);

/// Opens for reading. A killed writer's half-done transaction must be undone first, which takes a
/// connection that may write.
std::unique_ptr<SqliteDatabase> openDatabase(const std::string& file);

/// Refuses another program's database, other format versions, and missing tables.
void requireOurFormat(SqliteDatabase& database);

/// Refuses a database whose last page is incomplete, which SQLite itself accepts. To be called
/// within a transaction, as nobody can write then.
void requireWhole(SqliteDatabase& database, const std::string& path);

/// Why SQLite calls a file malformed: that it lost its end, most often, else SQLite's complaint.
std::string describeDamage(const std::string& path, const std::string& complaint);

}  // namespace hexapod
