#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tf2_ros/transform_broadcaster.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "repertoire/repertoire.h"
#include "robot/robot_description.h"
#include "ros_interface/common/clock.h"
#include "self_model/learned_world.h"
#include "simulation/recording.h"

namespace hexapod {

/// Moves the model in rviz as the robot would move: plays entries in simulation, as they were
/// learned, and publishes joint_states and tf in real time. The frame on the floor stays where it
/// is, so that the repertoire around it does, and the body moves away from it.
///
/// For a session without a robot: it is the only one who says where the body is. From any thread.
class ModelPlayer {
 public:
  struct Frames {
    std::string global;
    std::string base;  ///< of the robot on the floor
  };

  /// The clock must outlive it.
  ModelPlayer(ros::NodeHandle& node, const RobotDescription& robot, const Clock& clock,
              Frames frames);
  ~ModelPlayer();
  ModelPlayer(const ModelPlayer&) = delete;
  ModelPlayer& operator=(const ModelPlayer&) = delete;

  /// Plays a genome from now on, again and again with a pause in between; what is being played is
  /// broken off. Returns at once.
  void play(const LearnedWorld& learned, const Genome& genome);

 private:
  struct Order {
    LearnedWorld learned;
    Genome genome;
  };

  void work();
  /// False when something else is to be done.
  bool show(const Recording& recording, double period_s);
  bool hold(const RecordedPose& pose, const Pose2& world_from_start, double duration_s);
  void publish(const RecordedPose& pose, const Pose2& world_from_start);
  bool isOutdated() const;

  const RobotDescription robot_;
  const Clock& clock_;
  const Frames frames_;
  const RecordedPose standing_;
  ros::Publisher joint_publisher_;
  tf2_ros::TransformBroadcaster transforms_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Order> next_;  // guarded by mutex_, as the next
  bool leaves_ = false;
  std::thread thread_;
};

}  // namespace hexapod
