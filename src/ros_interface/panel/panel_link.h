#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ros_interface/panel/panel_model.h"

namespace hexapod {

/// A PanelModel's ears and hands on ROS: tells it what topics say, calls services and publishes.
/// Calls return at once; several may be under way, so that a stop waits for nothing.
class PanelLink {
 public:
  struct Panel {
    /// Brings a function into the thread that everything else here is called from.
    std::function<void(std::function<void()>)> post;
    /// The model heard something; in that thread.
    std::function<void()> changed;
    /// The answer to something asked, a sentence; in that thread.
    std::function<void(const std::string&)> tell;
  };

  /// The model must outlive it.
  PanelLink(const ros::NodeHandle& node, PanelModel& model, Panel panel);
  ~PanelLink();
  PanelLink(const PanelLink&) = delete;
  PanelLink& operator=(const PanelLink&) = delete;

  /// What needs no more words: all but kGo, kLoad and kEntry.
  void ask(Ask ask);
  void go(const geometry_msgs::PoseStamped& goal);
  void load(const std::string& file);
  void choose(std::int64_t entry_id, bool play);
  void publishFilter(const EntryFilter& filter);
  /// Where the mouse is, in the frame of the repertoire's origin [m].
  void publishPointer(double x_m, double y_m);
  /// Tells the model who is here. To be called every now and then.
  void lookAround();

 private:
  template <class Message>
  ros::Subscriber listen(const std::string& topic, void (PanelModel::*hear)(const Message&));
  template <class Service>
  void call(const std::string& name, Service service);

  PanelModel& model_;
  const Panel panel_;
  ros::CallbackQueue topics_;
  ros::CallbackQueue calls_;
  ros::NodeHandle node_;
  ros::Publisher filter_publisher_;
  ros::Publisher pointer_publisher_;
  ros::Subscriber progress_;
  ros::Subscriber executor_;
  ros::Subscriber plan_;
  ros::Subscriber handles_;
  std::vector<ros::Subscriber> others_;
  ros::AsyncSpinner topic_spinner_;
  ros::AsyncSpinner call_spinner_;
};

}  // namespace hexapod
