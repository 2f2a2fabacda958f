#include "ros_interface/planner/planner_node.h"

#include <ros/console.h>
#include <ros/init.h>

#include "ros_interface/common/conversions.h"
#include "ros_interface/common/names.h"
#include "ros_interface/display/body_markers.h"
#include "simulation/swept_footprint.h"

namespace hexapod {
namespace {

constexpr char kBodyMarkersTopic[] = "body_markers";
constexpr char kMapTopic[] = "map";
constexpr char kUpdateTopic[] = "map_updates";
// None may be missed; they are taken faster than they come.
constexpr std::uint32_t kUpdateQueue = 50;
constexpr double kPoll_s = 0.02;
constexpr std::int64_t kBeliefPeriod_ns = kSecond_ns;
constexpr std::int64_t kWarnPeriod_ns = 2 * kSecond_ns;
// Answers on their way to clients.
constexpr std::int64_t kFarewell_ns = kSecond_ns / 5;
// How much tf to keep: clients stamp their goals with the time they saw them.
constexpr double kHistory_s = 10.0;

}  // namespace

PlannerNode::PlannerNode(ros::NodeHandle& node, ros::NodeHandle& private_node,
                         const PlannerNodeOptions& options,
                         const std::optional<RobotDescription>& robot)
    : options_(options),
      robot_(robot),
      master_({node.resolveName(names::kRepertoire)}),
      buffer_(ros::Duration(kHistory_s)),
      ears_(clock_, buffer_),
      poses_(options_.pose, clock_, buffer_),
      executor_(node, clock_),
      belief_publisher_(
          node.advertise<hexapod_repertoire::BodyBelief>(names::kBodyBelief, 1, true)),
      body_publisher_(node.advertise<visualization_msgs::MarkerArray>(kBodyMarkersTopic, 1, true)),
      self_image_(clock_, robot,
                  [this](const hexapod_repertoire::BodyBelief& belief) { publishBelief(belief); }),
      paths_(robot),
      repertoire_(
          options.planner, robot ? robot->digest : "",
          [this, topic = node.resolveName(names::kRepertoire)] {
            return master_.otherPublishers(topic);
          },
          [this](const hexapod::Repertoire& repertoire) -> std::shared_ptr<Foresight> {
            if (options_.adaptation == Adaptation::kNone) return nullptr;
            return self_image_.foresightFor(repertoire);
          },
          [this](const hexapod::Repertoire& repertoire) { return paths_.known(repertoire); }),
      relearned_publisher_(private_node.advertise<Repertoire>("relearned_repertoire", 1, true)),
      relearner_(options_, robot, repertoire_,
                 [this](const hexapod::Repertoire& relearned) {
                   relearned_publisher_.publish(toMsg(relearned, clock_.rosNow()));
                 }),
      map_(options_, buffer_, robot ? std::make_optional(sweptFootprint(*robot)) : std::nullopt),
      display_(node, private_node, clock_,
               {options.pose.global_frame, [this] { return self_image_.told().sentence; },
                options.pose.base_frame, map_.footprint().value_or(Footprint())}),
      walker_({options_, clock_, poses_, repertoire_, executor_.client(), display_,
               [this] { return map_.obstacles(); }, [this] { return map_.problem(); }}),
      actions_(node, goal_queue_, walker_),
      services_(node, private_node, goal_queue_, walker_),
      cmd_vel_(options.cmd_vel ? std::make_unique<TwistDoor>(node, goal_queue_, clock_, walker_,
                                                             options.cmd_vel_timeout_s)
                               : nullptr),
      goal_spinner_(1, &goal_queue_),
      repertoire_subscriber_(node.subscribe(names::kRepertoire, 1, &PlannerNode::receive, this)),
      reset_belief_service_(
          private_node.advertiseService("reset_belief", &PlannerNode::onResetBelief, this)),
      map_spinner_(1, &map_queue_),
      next_warning_ns_(clock_.steadyNow_ns() + kWarnPeriod_ns) {
  updater_.setHardwareID("hexapod");
  updater_.add("planner", this, &PlannerNode::report);
  goal_spinner_.start();
  ros::NodeHandle map_node(node);
  map_node.setCallbackQueue(&map_queue_);
  map_subscriber_ = map_node.subscribe(kMapTopic, 1, &PlannerNode::receiveMap, this);
  update_subscriber_ =
      map_node.subscribe(kUpdateTopic, kUpdateQueue, &PlannerNode::receiveUpdate, this);
  map_spinner_.start();
}

void PlannerNode::receiveMap(const nav_msgs::OccupancyGrid::ConstPtr& map) {
  tellOfMap(map_.take(*map));
}

void PlannerNode::receiveUpdate(const map_msgs::OccupancyGridUpdate::ConstPtr& update) {
  tellOfMap(map_.take(*update));
}

/// Once, however often the same thing is wrong.
void PlannerNode::tellOfMap(const std::string& problem) {
  if (!problem.empty() && problem != map_problem_) ROS_ERROR_STREAM(problem);
  map_problem_ = problem;
}

PlannerNode::End PlannerNode::run(const std::atomic<bool>& leave) {
  End end = End::kAskedToLeave;
  while (!leave && ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kPoll_s));
    poses_.latest();  // keeps an eye on it
    walker_.look();
    updater_.update();
    warn();
    lookAtBelief();
    if (!master_.masterIsLost()) continue;
    end = End::kMasterLost;
    break;
  }
  answerAll(end);
  return end;
}

void PlannerNode::answerAll(End end) {
  walker_.close(GoalCode::SHUTDOWN,
                end == End::kMasterLost
                    ? "The ROS master is gone or was replaced; the planner leaves to be restarted."
                    : "The planner is shutting down.");
  clock_.waitUntil(clock_.steadyNow_ns() + kFarewell_ns, [] { return false; });
}

void PlannerNode::receive(const ros::MessageEvent<Repertoire const>& event) {
  const auto taken = repertoire_.take(*event.getConstMessage(), event.getPublisherName());
  if (taken.in_use) {
    ROS_INFO_STREAM(taken.message);
    paths_.serve(repertoire_.planner());
  } else {
    ROS_ERROR_STREAM(taken.message);
  }
}

bool PlannerNode::onResetBelief(std_srvs::Trigger::Request&,
                                std_srvs::Trigger::Response& response) {
  response.message = self_image_.forget();
  response.success = true;
  return true;
}

void PlannerNode::lookAtBelief() {
  if (clock_.steadyNow_ns() < next_belief_ns_) return;
  next_belief_ns_ = clock_.steadyNow_ns() + kBeliefPeriod_ns;
  self_image_.tellAgain();
  const std::string news = relearner_.look(self_image_.sureBody());
  if (news.empty()) return;
  ROS_INFO_STREAM(news);
  paths_.serve(repertoire_.planner());
}

// Called by one thread at a time.
void PlannerNode::publishBelief(const hexapod_repertoire::BodyBelief& belief) {
  belief_publisher_.publish(belief);
  body_publisher_.publish(bodyMarkers(*robot_, belief));
  if (belief.bodies.front() == believed_body_) return;
  if (!believed_body_.empty()) ROS_INFO_STREAM("Believed body: " << belief.sentence << ".");
  believed_body_ = belief.bodies.front();
}

void PlannerNode::warn() {
  if (clock_.steadyNow_ns() < next_warning_ns_) return;
  next_warning_ns_ = clock_.steadyNow_ns() + kWarnPeriod_ns;
  if (ros::Time::isSimTime() && clock_.rosNow().isZero()) {
    ROS_WARN(
        "/use_sim_time is true but no time comes on /clock; start what publishes /clock, or set "
        "/use_sim_time to false.");
  }
  const std::string map = map_.problem();
  if (!map.empty() && map == waiting_map_) ROS_WARN_STREAM(map);
  waiting_map_ = map;
}

void PlannerNode::report(diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  using Status = diagnostic_msgs::DiagnosticStatus;
  diagnostics.summary(Status::OK, "Ready for goals.");
  const auto planner = repertoire_.planner();
  const std::string executor = executor_.client().whyNotReady();
  const std::string pose = poses_.latest().problem;
  const std::string map = map_.problem();
  if (!map.empty()) diagnostics.mergeSummary(Status::WARN, map);
  if (!planner) diagnostics.mergeSummary(Status::WARN, "No repertoire has arrived.");
  if (!executor.empty()) diagnostics.mergeSummary(Status::WARN, executor);
  if (!pose.empty()) diagnostics.mergeSummary(Status::WARN, pose);
  const hexapod_repertoire::BodyBelief belief = self_image_.told();
  if (!belief.dead_joints.empty()) {
    diagnostics.mergeSummary(Status::WARN, "Walking with a body that is believed damaged.");
  }
  if (!belief.sentence.empty()) diagnostics.add("Believed body", belief.sentence);
  if (!planner) return;
  diagnostics.add("Run", planner->repertoire().run_id);
  diagnostics.add("Entries", planner->repertoire().entries.size());
  diagnostics.add("Entries planned with", planner->planner()->usableEntries());
  diagnostics.add("Entries whose way is simulated", paths_.count());
}

}  // namespace hexapod
