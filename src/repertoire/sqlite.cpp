#include "repertoire/sqlite.h"

#include <sqlite3.h>

namespace hexapod {
namespace {

constexpr int kBusyTimeoutMs = 5000;

int openFlags(SqliteDatabase::Mode mode) {
  switch (mode) {
    case SqliteDatabase::Mode::kRead:
      return SQLITE_OPEN_READONLY;
    case SqliteDatabase::Mode::kWrite:
      return SQLITE_OPEN_READWRITE;
    case SqliteDatabase::Mode::kCreate:
      break;
  }
  return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
}

}  // namespace

SqliteDatabase::SqliteDatabase(const std::string& file, Mode mode) {
  const int code = sqlite3_open_v2(file.c_str(), &handle_, openFlags(mode), nullptr);
  if (code != SQLITE_OK) {
    const SqliteError error(code, handle_ ? sqlite3_errmsg(handle_) : sqlite3_errstr(code));
    sqlite3_close(handle_);
    throw error;
  }
  sqlite3_extended_result_codes(handle_, 1);
  sqlite3_busy_timeout(handle_, kBusyTimeoutMs);
}

SqliteDatabase::~SqliteDatabase() { sqlite3_close(handle_); }

void SqliteDatabase::execute(const std::string& sql) {
  const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) throw SqliteError(code, sqlite3_errmsg(handle_));
}

std::int64_t SqliteDatabase::integer(const std::string& sql) {
  SqliteStatement statement(*this, sql);
  return statement.step() ? statement.integer(0) : 0;
}

SqliteStatement::SqliteStatement(SqliteDatabase& database, const std::string& sql)
    : database_(database) {
  require(sqlite3_prepare_v2(database.handle(), sql.c_str(), static_cast<int>(sql.size()), &handle_,
                             nullptr));
}

SqliteStatement::~SqliteStatement() { sqlite3_finalize(handle_); }

void SqliteStatement::bind(int parameter, std::int64_t value) {
  require(sqlite3_bind_int64(handle_, parameter, value));
}

void SqliteStatement::bind(int parameter, double value) {
  require(sqlite3_bind_double(handle_, parameter, value));
}

void SqliteStatement::bind(int parameter, const std::string& value) {
  require(sqlite3_bind_text64(handle_, parameter, value.data(), value.size(), SQLITE_TRANSIENT,
                              SQLITE_UTF8));
}

void SqliteStatement::bindBlob(int parameter, const std::string& value) {
  require(sqlite3_bind_blob64(handle_, parameter, value.data(), value.size(), SQLITE_TRANSIENT));
}

void SqliteStatement::bindNull(int parameter) { require(sqlite3_bind_null(handle_, parameter)); }

bool SqliteStatement::step() {
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  throw SqliteError(code, sqlite3_errmsg(database_.handle()));
}

void SqliteStatement::run() {
  while (step()) continue;
  require(sqlite3_reset(handle_));
}

bool SqliteStatement::isInteger(int column) const {
  return sqlite3_column_type(handle_, column) == SQLITE_INTEGER;
}

bool SqliteStatement::isReal(int column) const {
  return sqlite3_column_type(handle_, column) == SQLITE_FLOAT;
}

bool SqliteStatement::isText(int column) const {
  return sqlite3_column_type(handle_, column) == SQLITE_TEXT;
}

bool SqliteStatement::isBlob(int column) const {
  return sqlite3_column_type(handle_, column) == SQLITE_BLOB;
}

bool SqliteStatement::isNull(int column) const {
  return sqlite3_column_type(handle_, column) == SQLITE_NULL;
}

std::int64_t SqliteStatement::integer(int column) const {
  return sqlite3_column_int64(handle_, column);
}

double SqliteStatement::real(int column) const { return sqlite3_column_double(handle_, column); }

std::string SqliteStatement::bytes(int column) const {
  const auto* data = static_cast<const char*>(sqlite3_column_blob(handle_, column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_, column));
  return data == nullptr ? std::string() : std::string(data, size);
}

void SqliteStatement::require(int code) const {
  if (code != SQLITE_OK) throw SqliteError(code, sqlite3_errmsg(database_.handle()));
}

SqliteTransaction::SqliteTransaction(SqliteDatabase& database, Kind kind) : database_(database) {
  database_.execute(kind == Kind::kWrite ? "BEGIN IMMEDIATE" : "BEGIN");
}

SqliteTransaction::~SqliteTransaction() {
  if (sqlite3_get_autocommit(database_.handle()) == 0) {
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void SqliteTransaction::commit() { database_.execute("COMMIT"); }

}  // namespace hexapod
