#include "ros_interface/display/repertoire_markers.h"

#include <algorithm>
#include <cmath>

#include "geometry/arc.h"
#include "geometry/pose2.h"
#include "ros_interface/display/marker_parts.h"

namespace hexapod {
namespace {

using visualization_msgs::Marker;

constexpr double kWorstShown_rad = 10.0 * kDegree;
constexpr double kDiscRadius_m = 0.008;
constexpr double kNeedle_m = 0.025;
constexpr double kDiscsAt_m = 0.005;
constexpr double kHeadingsAt_m = 0.006;
constexpr double kTangentsAt_m = 0.008;
// Of more entries than these everything is smaller, and simpler: a graphics card in software draws
// so many triangles a second.
constexpr std::size_t kManyEntries = 2000;

/// What is drawn of each entry, all of it by triangles.
class Symbols {
 public:
  Symbols(const std::string& frame, std::size_t entries)
      : is_simple_(entries > kManyEntries),
        size_(std::min(
            1.0, std::sqrt(static_cast<double>(kManyEntries) / static_cast<double>(entries + 1)))),
        discs_(marker(frame, "end_points", 0, Marker::TRIANGLE_LIST, 1.0)),
        headings_(marker(frame, "headings", 1, Marker::TRIANGLE_LIST, 1.0)),
        tangents_(marker(frame, "tangents", 2, Marker::TRIANGLE_LIST, 1.0)) {
    headings_.color = color(0.1, 0.35, 0.9);
    tangents_.color = color(0.1, 0.1, 0.1);
  }

  void add(const Entry& entry) {
    const Pose2& pose = entry.expectedPose();
    addDisc(pose, entry.usable() ? errorColor(orientationError(pose)) : color(0.5, 0.5, 0.5));
    addNeedle(headings_, pose, {0.0, 1.0}, {0.003, kHeadingsAt_m});
    // Dashed, and above the needle of the heading: where both agree, both are seen.
    const Pose2 along{pose.x_m, pose.y_m, arcThrough(pose.x_m, pose.y_m).heading_rad};
    if (!is_simple_) addNeedle(tangents_, along, {0.2, 0.5}, {0.002, kTangentsAt_m});
    addNeedle(tangents_, along, {0.7, 1.0}, {0.002, kTangentsAt_m});
  }

  visualization_msgs::MarkerArray markers() const {
    visualization_msgs::MarkerArray array;
    for (Marker list : {discs_, headings_, tangents_}) {
      list.scale.z = 1.0;
      list.frame_locked = true;
      array.markers.push_back(shown(list));
    }
    return array;
  }

 private:
  struct Span {  // as shares of kNeedle_m
    double from;
    double to;
  };
  struct Line {
    double width_m;
    double height_m;
  };

  /// Two triangles that make a star of six points: in the size of a dot a disc, for half of the
  /// triangles. One, where it is smaller than that.
  void addDisc(const Pose2& pose, const std_msgs::ColorRGBA& tint) {
    const int triangles = is_simple_ ? 1 : 2;
    const double radius_m = size_ * kDiscRadius_m;
    for (int i = 0; i < 3 * triangles; ++i) {
      const double angle = 2.0 * M_PI * i / 3.0 + (i < 3 ? 0.0 : M_PI);
      discs_.points.push_back(point(pose.x_m + radius_m * std::cos(angle),
                                    pose.y_m + radius_m * std::sin(angle), kDiscsAt_m));
    }
    discs_.colors.insert(discs_.colors.end(), triangles, tint);
  }

  /// Wide where it begins, a point where it ends.
  void addNeedle(Marker& list, const Pose2& pose, const Span& span, const Line& line) {
    const auto at = [&](double share, double aside) {
      const Pose2 place =
          pose * Pose2{size_ * share * kNeedle_m, size_ * aside * line.width_m, 0.0};
      list.points.push_back(point(place.x_m, place.y_m, line.height_m));
    };
    at(span.from, -0.5);
    at(span.to, 0.0);
    at(span.from, 0.5);
  }

  const bool is_simple_;
  const double size_;
  Marker discs_;
  Marker headings_;
  Marker tangents_;
};

}  // namespace

std_msgs::ColorRGBA errorColor(double orientation_error_rad) {
  // SHADES of pictures.py.
  constexpr double kScale[][3] = {{0.361, 0.786, 0.388},
                                  {0.120, 0.622, 0.535},
                                  {0.174, 0.445, 0.558},
                                  {0.261, 0.247, 0.523},
                                  {0.267, 0.005, 0.329}};
  constexpr int kSpans = 4;
  const double place = kSpans * std::min(1.0, std::abs(orientation_error_rad) / kWorstShown_rad);
  const int span = std::min(kSpans - 1, static_cast<int>(place));
  const auto mixed = [&](int channel) {
    const double light = kScale[span][channel];
    return light + (place - span) * (kScale[span + 1][channel] - light);
  };
  return color(mixed(0), mixed(1), mixed(2));
}

visualization_msgs::MarkerArray repertoireMarkers(const Repertoire& repertoire,
                                                  const std::string& frame) {
  Symbols symbols(frame, repertoire.entries.size());
  for (const Entry& entry : repertoire.entries) symbols.add(entry);
  return symbols.markers();
}

}  // namespace hexapod
