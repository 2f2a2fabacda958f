#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "hexapod_repertoire/ChooseEntry.h"
#include "hexapod_repertoire/ExecutorState.h"
#include "hexapod_repertoire/Repertoire.h"
#include "hexapod_repertoire/RepertoireFilter.h"
#include "repertoire/entry_filter.h"
#include "ros_interface/browser/archive_handle.h"
#include "ros_interface/browser/browser_options.h"
#include "ros_interface/browser/model_player.h"
#include "ros_interface/browser/robot_player.h"
#include "ros_interface/display/entry_markers.h"
#include "ros_interface/robot_client/executor_topics.h"
#include "ros_interface/robot_client/tf_pose_source.h"
#include "ros_interface/robot_client/transform_ears.h"

namespace hexapod {

/// A repertoire to look at and to click in rviz: repertoire_markers, entry_markers (latched), the
/// interactive marker of repertoire_handles, ~step_report for what the robot played, ~choose to
/// show or play an entry by its id. Entries that repertoire_filter leaves out are not there.
///
/// The archive is drawn in the frame repertoire_origin, with the prefix of global_frame, which this
/// node publishes: where the robot last stood. It stays there while the body moves.
class BrowserNode {
 public:
  /// Throws std::invalid_argument when the robot cannot be simulated.
  BrowserNode(ros::NodeHandle& node, ros::NodeHandle& private_node, const BrowserOptions& options,
              const RobotDescription& robot);

  /// Serves until `leave` is set or ROS shuts down.
  void run(const std::atomic<bool>& leave);

 private:
  void receive(const hexapod_repertoire::Repertoire::ConstPtr& message);
  void receiveState(const hexapod_repertoire::ExecutorState::ConstPtr& state);
  void receiveFilter(const hexapod_repertoire::RepertoireFilter::ConstPtr& message);
  bool onChoose(hexapod_repertoire::ChooseEntry::Request& request,
                hexapod_repertoire::ChooseEntry::Response& response);
  void showRepertoire();
  std::string choose(const Entry& entry, bool play);
  void showGait(const Entry& entry);
  std::string exclude(const Entry& entry);
  EntryPicture pictureOf(const Entry& entry) const;
  void onClick(ArchiveHandle::Wish wish, const Entry& entry);
  std::string playOnModel(const Entry& entry);
  void tell(const RobotPlayer::Report& report);
  void show(const EntryPicture& picture);
  void standAt(const Pose2& pose);
  void followRobot();
  void makeRobotPlayer(ros::NodeHandle& node);

  const BrowserOptions options_;
  const RobotDescription robot_;
  const std::string origin_frame_;
  SystemClock clock_;
  tf2::BufferCore buffer_;
  TransformEars ears_;
  TfPoseSource poses_;
  tf2_ros::StaticTransformBroadcaster origin_broadcaster_;
  Pose2 origin_;
  ros::Publisher marker_publisher_;
  ros::Publisher entry_publisher_;
  ros::Publisher step_publisher_;
  ArchiveHandle handle_;
  Repertoire repertoire_;
  EntryFilter filter_;
  Repertoire shown_;  // what passes the filter
  std::optional<LearnedWorld> learned_;
  bool clicked_ = false;
  std::optional<std::int64_t> best_;  // id of the entry that is played until one is clicked
  bool moving_ = true;                // until the executor says otherwise
  std::uint32_t steps_ = 0;           // thread of the robot player
  std::unique_ptr<ModelPlayer> model_;
  std::unique_ptr<ExecutorTopics> executor_;
  std::unique_ptr<RobotPlayer> player_;
  ros::Subscriber repertoire_subscriber_;
  ros::Subscriber state_subscriber_;
  ros::Subscriber filter_subscriber_;
  ros::ServiceServer choose_;
  ros::ServiceClient exclude_;
};

}  // namespace hexapod
