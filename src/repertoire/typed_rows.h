#pragma once

#include <cstdint>
#include <string>

#include "gait/genome.h"
#include "geometry/pose2.h"
#include "repertoire/sqlite.h"

namespace hexapod {

/// Values of a row, none of another type than was written. What is wrong is thrown by fail();
/// `name` says of what they are.
double realAt(const SqliteStatement& row, int column, const std::string& name);
std::int64_t integerAt(const SqliteStatement& row, int column, const std::string& name);
Genome genomeAt(const SqliteStatement& row, int column, const std::string& name);
/// x, y and heading in three columns; and the way there.
/// @{
Pose2 poseAt(const SqliteStatement& row, int first_column, const std::string& name);
void bindPose(int first_parameter, const Pose2& pose, SqliteStatement& insert);
/// @}

/// Refuses a table of more rows than a repertoire may have entries.
void requireCount(SqliteDatabase& database, const std::string& table);

}  // namespace hexapod
