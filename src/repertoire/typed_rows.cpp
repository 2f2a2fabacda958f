#include "repertoire/typed_rows.h"

#include <stdexcept>

#include "repertoire/repertoire_file.h"
#include "repertoire/sound_database.h"

namespace hexapod {

double realAt(const SqliteStatement& row, int column, const std::string& name) {
  if (!row.isReal(column)) {
    fail("a number in column " + std::to_string(column) + " of " + name, "another type");
  }
  return row.real(column);
}

std::int64_t integerAt(const SqliteStatement& row, int column, const std::string& name) {
  if (!row.isInteger(column)) {
    fail("an integer in column " + std::to_string(column) + " of " + name, "another type");
  }
  return row.integer(column);
}

Genome genomeAt(const SqliteStatement& row, int column, const std::string& name) {
  try {
    return genomeFromString(row.bytes(column));
  } catch (const std::invalid_argument& error) {
    fail("a genome in " + name,
         "'" + row.bytes(column).substr(0, 100) + "' (" + error.what() + ")");
  }
}

Pose2 poseAt(const SqliteStatement& row, int first_column, const std::string& name) {
  return {realAt(row, first_column, name), realAt(row, first_column + 1, name),
          realAt(row, first_column + 2, name)};
}

void bindPose(int first_parameter, const Pose2& pose, SqliteStatement& insert) {
  insert.bind(first_parameter, pose.x_m);
  insert.bind(first_parameter + 1, pose.y_m);
  insert.bind(first_parameter + 2, pose.yaw_rad);
}

void requireCount(SqliteDatabase& database, const std::string& table) {
  const std::int64_t rows = database.integer("SELECT count(*) FROM " + table);
  if (rows > kMaxEntries) {
    fail("at most " + std::to_string(kMaxEntries) + " rows in the table " + table,
         std::to_string(rows));
  }
}

}  // namespace hexapod
