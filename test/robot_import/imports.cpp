#include "imports.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "robot/dimensions.h"

namespace hexapod {

ImportResult import(const std::string& urdf, const std::string& folder) {
  ImportRequest request;
  request.urdf_text = urdf;
  request.urdf_name = "given.urdf";
  request.urdf_folder = folder;
  request.gaits = 24;
  return importRobot(request);
}

std::string complaint(const std::string& urdf) {
  try {
    import(urdf);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

std::string replacedAll(std::string text, const std::string& from, const std::string& to) {
  if (text.find(from) == std::string::npos) throw std::runtime_error("Nothing to replace: " + from);
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string without(std::string urdf, const std::string& element) {
  const std::string open = "<" + element + ">", close = "</" + element + ">";
  for (std::size_t at = urdf.find(open); at != std::string::npos; at = urdf.find(open)) {
    urdf.erase(at, urdf.find(close, at) + close.size() - at);
  }
  return urdf;
}

bool isRemarked(const ImportResult& result, const std::string& words) {
  return std::any_of(result.remarks.begin(), result.remarks.end(), [&](const std::string& remark) {
    return remark.find(words) != std::string::npos;
  });
}

std::vector<std::string> legNames(const RobotDescription& robot) {
  std::vector<std::string> names;
  for (const Leg& leg : robot.legs) names.push_back(leg.name);
  return names;
}

void expectReady(const ImportResult& result) {
  EXPECT_EQ(result.to_change, "");
  EXPECT_LT(result.standing.tilt_rad, 0.02);
  EXPECT_LT(result.standing.sag_rad, 0.05);
  EXPECT_LT(result.standing.torque_share, 0.8);
  EXPECT_EQ(result.standing.on_floor.size(), result.robot.legs.size());
  EXPECT_EQ(result.gaits.engine, "reduced") << result.gaits.engine_remark;
  EXPECT_GT(result.gaits.walked(), result.gaits.gaits / 2);
  // They lead somewhere: the middle one a tenth of a leg's reach.
  EXPECT_GT(result.gaits.median_way_m, 0.1 * legReach_m(result.robot));
  for (const std::string& file : {result.urdf, result.yaml}) EXPECT_FALSE(file.empty());
}

}  // namespace hexapod
