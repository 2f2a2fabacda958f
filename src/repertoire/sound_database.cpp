#include "repertoire/sound_database.h"

#include <sqlite3.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "repertoire/learner_tables.h"
#include "repertoire/repertoire_file.h"

namespace hexapod {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCutShort = ": the file was cut short";

}  // namespace

void fail(const std::string& expected, const std::string& found) {
  throw std::invalid_argument("expected " + expected + ", found " + found);
}

void requireSqliteFile(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) fail("a repertoire that a learner has written", "no such file");
  if (!fs::is_regular_file(path, error)) fail("an ordinary file", "a folder or a device");
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("a readable file", "one that this user may not open");
  const std::string magic("SQLite format 3\0", 16);
  std::array<char, 16> start{};
  file.read(start.data(), start.size());
  if (file.gcount() == 0) fail("an SQLite database", "an empty file");
  if (std::string(start.data(), static_cast<std::size_t>(file.gcount())) != magic) {
    fail("an SQLite database", "a file of another kind");
  }
}

std::unique_ptr<SqliteDatabase> openDatabase(const std::string& file) {
  auto database = std::make_unique<SqliteDatabase>(file, SqliteDatabase::Mode::kRead);
  try {
    database->integer("PRAGMA schema_version");
  } catch (const SqliteError& error) {
    const int code = error.code();
    if (code != SQLITE_READONLY_ROLLBACK && code != SQLITE_CANTOPEN) throw;
    database = std::make_unique<SqliteDatabase>(file, SqliteDatabase::Mode::kWrite);
  }
  return database;
}

void requireOurFormat(SqliteDatabase& database) {
  const std::int64_t application = database.integer("PRAGMA application_id");
  if (application != kApplicationId) {
    fail("a repertoire (application id " + std::to_string(kApplicationId) + ")",
         "another program's database (application id " + std::to_string(application) + ")");
  }
  const std::int64_t version = database.integer("PRAGMA user_version");
  if (version < kOldestFormatVersion || version > kFormatVersion) {
    fail("format version " + std::to_string(kOldestFormatVersion) + " to " +
             std::to_string(kFormatVersion),
         "version " + std::to_string(version));
  }
  // A view of that name could go on for ever.
  std::vector<std::string> tables = {"entries", "meta", "history", "state"};
  if (version >= kLearnerTablesVersion) tables.insert(tables.end(), {"population", "archive"});
  for (const std::string& table : tables) {
    if (database.integer("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = '" +
                         table + "'") != 1) {
      fail("a table " + table, "none");
    }
  }
}

void requireWhole(SqliteDatabase& database, const std::string& path) {
  const std::int64_t expected =
      database.integer("PRAGMA page_count") * database.integer("PRAGMA page_size");
  const auto size = static_cast<std::int64_t>(fs::file_size(path));
  if (size < expected) fail(std::to_string(expected) + " bytes", std::to_string(size) + kCutShort);
}

std::string describeDamage(const std::string& path, const std::string& complaint) {
  std::array<unsigned char, 32> header{};
  std::ifstream file(path, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(header.data()), header.size())) return complaint;
  std::uint64_t page_size = header[16] * 256U + header[17];
  if (page_size == 1) page_size = 65536;
  std::uint64_t pages = 0;
  for (int i = 28; i < 32; ++i) pages = pages * 256U + header[static_cast<std::size_t>(i)];
  std::error_code error;
  const auto size = static_cast<std::uint64_t>(fs::file_size(path, error));
  if (error || size >= page_size * pages) return complaint;
  return std::to_string(size) + " of " + std::to_string(page_size * pages) + " bytes" + kCutShort;
}

}  // namespace hexapod
