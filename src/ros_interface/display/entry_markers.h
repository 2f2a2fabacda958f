#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>
#include <vector>

#include "geometry/pose2.h"
#include "repertoire/entry.h"

namespace hexapod {

/// An entry that somebody looks at, and what became of it when it was played.
struct EntryPicture {
  std::string frame;  ///< of `start` and `reached`
  Pose2 start;        ///< where the robot stands, or stood, before it
  Entry entry;
  std::optional<Pose2> reached;   ///< once it was played
  std::string remark;             ///< a line below the figures, may be empty
  std::vector<Entry> neighbours;  ///< others to show beside it
  double beside_m = 0.7;          ///< so far to the left of `start` it is put in words
};

/// The entry's arc, a ring around its expected end, its heading, the pose it reached with a line to
/// the one that was expected, rings around the ends of its neighbours, and all of it in words.
/// Fixed ids.
visualization_msgs::MarkerArray entryMarkers(const EntryPicture& picture);

}  // namespace hexapod
