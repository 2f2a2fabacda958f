#pragma once

#include <string>

#include "robot_import/import_robot.h"

namespace hexapod {

/// What a picture of the standing robot shows, as JSON with points in metres over the floor:
/// "name"; "looks": triangles of what is seen (at most some thousand); "shapes": of each collision
/// shape its kind, radius and core points; "feet": the links on the floor; "height_m"; "ready".
std::string pictureData(const ImportResult& result);

}  // namespace hexapod
