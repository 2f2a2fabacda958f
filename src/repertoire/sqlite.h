#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace hexapod {

/// What SQLite refused to do, in its words.
class SqliteError : public std::runtime_error {
 public:
  SqliteError(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
  /// Extended result code.
  int code() const { return code_; }

 private:
  int code_;
};

/// An open database. Everything throws SqliteError. One thread at a time.
class SqliteDatabase {
 public:
  enum class Mode { kRead, kWrite, kCreate };  ///< kCreate: write, and create when missing

  /// Waits up to 5 s whenever another process holds the file.
  SqliteDatabase(const std::string& file, Mode mode);
  ~SqliteDatabase();
  SqliteDatabase(const SqliteDatabase&) = delete;
  SqliteDatabase& operator=(const SqliteDatabase&) = delete;

  /// Runs statements that give no rows.
  void execute(const std::string& sql);
  /// First column of the first row; 0 without rows.
  std::int64_t integer(const std::string& sql);

  sqlite3* handle() const { return handle_; }

 private:
  sqlite3* handle_ = nullptr;
};

/// A prepared statement. Parameters count from 1, columns from 0. The database must outlive it.
class SqliteStatement {
 public:
  SqliteStatement(SqliteDatabase& database, const std::string& sql);
  ~SqliteStatement();
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;

  void bind(int parameter, std::int64_t value);
  void bind(int parameter, double value);
  void bind(int parameter, const std::string& value);
  void bindBlob(int parameter, const std::string& value);
  void bindNull(int parameter);

  /// Next row: true; end: false.
  bool step();
  /// Runs a statement without rows and makes it ready for the next values.
  void run();

  bool isInteger(int column) const;
  bool isReal(int column) const;
  bool isText(int column) const;
  bool isBlob(int column) const;
  bool isNull(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  /// Text or blob, byte for byte.
  std::string bytes(int column) const;

 private:
  void require(int code) const;

  SqliteDatabase& database_;
  sqlite3_stmt* handle_ = nullptr;
};

/// All or nothing: rolls back unless committed.
class SqliteTransaction {
 public:
  enum class Kind { kRead, kWrite };
  SqliteTransaction(SqliteDatabase& database, Kind kind);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;

  void commit();

 private:
  SqliteDatabase& database_;
};

}  // namespace hexapod
