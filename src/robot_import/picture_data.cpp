#include "robot_import/picture_data.h"

#include <locale>
#include <sstream>

#include "robot/assemble_robot.h"
#include "simulation/kinematics.h"

namespace hexapod {
namespace {

constexpr std::size_t kMostTriangles = 600;  // of one look

std::string text(const std::string& value) {
  std::string result = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) result += c;
  }
  return result + "\"";
}

// Lists and points, with commas where they belong.
class Json {
 public:
  Json() {
    stream_.imbue(std::locale::classic());
    stream_.precision(5);
  }

  void addPoints(const Points& points) {
    stream_ << "[";
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d& p = points[i];
      stream_ << (i == 0 ? "" : ", ") << "[" << p.x() << ", " << p.y() << ", " << p.z() << "]";
    }
    stream_ << "]";
  }

  std::ostringstream& stream() { return stream_; }

 private:
  std::ostringstream stream_;
};

void addTriangles(const Look& look, const Eigen::Isometry3d& world_from_body, bool& is_first,
                  Json& json) {
  const std::vector<std::array<unsigned, 3>>& triangles = look.mesh.triangles;
  const std::size_t stride = 1 + triangles.size() / kMostTriangles;
  for (std::size_t t = 0; t < triangles.size(); t += stride) {
    Points corners;
    for (const unsigned v : triangles[t]) {
      corners.push_back(world_from_body * look.body_from_look * look.mesh.vertices[v]);
    }
    if (!is_first) json.stream() << ", ";
    is_first = false;
    json.addPoints(corners);
  }
}

const char* nameOf(Shape::Kind kind) {
  switch (kind) {
    case Shape::Kind::kBox:
      return "box";
    case Shape::Kind::kCapsule:
      return "capsule";
    case Shape::Kind::kSphere:
      break;
  }
  return "sphere";
}

}  // namespace

std::string pictureData(const ImportResult& result) {
  const RobotDescription& robot = result.robot;
  const Eigen::Isometry3d world_from_base(Eigen::Translation3d(0.0, 0.0, standingHeight(robot)));
  const auto poses = baseFromBodies(robot, robot.neutralPose());
  const Eigen::Isometry3d base_from_link(
      Eigen::AngleAxisd(-robot.link_from_base_yaw_rad, Eigen::Vector3d::UnitZ()));
  Json json;
  json.stream() << "{\"name\": " << text(robot.name) << ", \"height_m\": " << standingHeight(robot)
                << ", \"ready\": " << (result.to_change.empty() ? "true" : "false")
                << ",\n\"looks\": [";
  bool is_first = true;
  for (std::size_t b = 0; b < poses.size(); ++b) {
    const Eigen::Isometry3d pose =
        world_from_base * poses[b] * (b == 0 ? base_from_link : Eigen::Isometry3d::Identity());
    for (const Look& look : result.imported.extras[b].looks) {
      addTriangles(look, pose, is_first, json);
    }
  }
  json.stream() << "],\n\"shapes\": [";
  const auto all = bodies(robot);
  is_first = true;
  for (std::size_t b = 0; b < all.size(); ++b) {
    for (const Shape& shape : all[b]->shapes) {
      Points points = corePoints(shape);
      for (Eigen::Vector3d& point : points) point = world_from_base * poses[b] * point;
      json.stream() << (is_first ? "" : ", ") << "{\"kind\": \"" << nameOf(shape.kind)
                    << "\", \"radius_m\": " << roundness_m(shape) << ", \"points\": ";
      is_first = false;
      json.addPoints(points);
      json.stream() << "}";
    }
  }
  json.stream() << "],\n\"on_floor\": [";
  for (std::size_t i = 0; i < result.standing.on_floor.size(); ++i) {
    json.stream() << (i == 0 ? "" : ", ") << text(result.standing.on_floor[i]);
  }
  json.stream() << "]}\n";
  return json.stream().str();
}

}  // namespace hexapod
