#include "ros_interface/browser/browser_node.h"

#include <ros/callback_queue.h>
#include <ros/console.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <limits>
#include <utility>

#include "hexapod_repertoire/ExcludeEntry.h"
#include "hexapod_repertoire/StepReport.h"
#include "repertoire/describe_entry.h"
#include "repertoire/entry_choice.h"
#include "ros_interface/browser/entry_recording.h"
#include "ros_interface/common/conversions.h"
#include "ros_interface/common/names.h"
#include "ros_interface/display/gait_markers.h"
#include "ros_interface/display/repertoire_markers.h"
#include "ros_interface/display/scene_markers.h"

namespace hexapod {
namespace {

constexpr char kOtherRobot[] =
    "The repertoire was learned for another robot than that of robot_config.";
constexpr double kPoll_s = 0.05;
constexpr std::size_t kNeighbours = 5;
// The diagram of a gait, behind the texts beside the repertoire.
constexpr double kGaitAhead_m = -0.2;
constexpr double kGaitWider_m = 0.2;
constexpr double kHistory_s = 10.0;
// A robot that stands sways by less than this.
constexpr double kMoved_m = 0.002;
constexpr double kMoved_rad = 0.01;

// With the prefix of the robot's other frames.
std::string originFrame(const std::string& global_frame) {
  const std::size_t slash = global_frame.rfind('/');
  const std::string prefix = slash == std::string::npos ? "" : global_frame.substr(0, slash + 1);
  return prefix + names::kRepertoireOriginFrame;
}

}  // namespace

BrowserNode::BrowserNode(ros::NodeHandle& node, ros::NodeHandle& private_node,
                         const BrowserOptions& options, const RobotDescription& robot)
    : options_(options),
      robot_(robot),
      origin_frame_(originFrame(options.pose.global_frame)),
      buffer_(ros::Duration(kHistory_s)),
      ears_(clock_, buffer_),
      poses_(options_.pose, clock_, buffer_),
      marker_publisher_(
          node.advertise<visualization_msgs::MarkerArray>("repertoire_markers", 1, true)),
      entry_publisher_(node.advertise<visualization_msgs::MarkerArray>("entry_markers", 1, true)),
      step_publisher_(private_node.advertise<hexapod_repertoire::StepReport>("step_report", 10)),
      handle_(node, origin_frame_, buffer_,
              [this](ArchiveHandle::Wish wish, const Entry& entry) { onClick(wish, entry); }) {
  standAt({});
  if (options_.player == Player::kRobot) {
    makeRobotPlayer(node);
  } else {
    model_ = std::make_unique<ModelPlayer>(
        node, robot_, clock_,
        ModelPlayer::Frames{options_.pose.global_frame, options_.pose.base_frame});
  }
  repertoire_subscriber_ = node.subscribe(names::kRepertoire, 1, &BrowserNode::receive, this);
  filter_subscriber_ =
      node.subscribe(names::kRepertoireFilter, 1, &BrowserNode::receiveFilter, this);
  choose_ = private_node.advertiseService("choose", &BrowserNode::onChoose, this);
  exclude_ = node.serviceClient<hexapod_repertoire::ExcludeEntry>("repertoire_server/exclude");
}

void BrowserNode::makeRobotPlayer(ros::NodeHandle& node) {
  executor_ = std::make_unique<ExecutorTopics>(node, clock_);
  const ros::Duration settle(options_.pose.pose_settle_s);
  player_ =
      std::make_unique<RobotPlayer>(executor_->client(), poses_, settle,
                                    [this](const RobotPlayer::Report& report) { tell(report); });
  state_subscriber_ = node.subscribe(names::kExecutorState, 10, &BrowserNode::receiveState, this);
}

void BrowserNode::run(const std::atomic<bool>& leave) {
  while (!leave && ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kPoll_s));
    handle_.lookForPointer();
    if (!player_) continue;
    executor_->client().whyNotReady();  // keeps an eye on it
    followRobot();
  }
}

void BrowserNode::receiveState(const hexapod_repertoire::ExecutorState::ConstPtr& state) {
  using State = hexapod_repertoire::ExecutorState;
  moving_ = state->state == State::WALKING || state->state == State::HOLDING;
}

/// The archive goes where the robot has come to rest.
void BrowserNode::followRobot() {
  const PoseReading reading = poses_.latest();
  if (moving_ || player_->isPlaying() || !reading.pose) return;
  const bool has_moved = distance(origin_, *reading.pose) > kMoved_m ||
                         headingDistance(origin_, *reading.pose) > kMoved_rad;
  if (has_moved) standAt(*reading.pose);
}

void BrowserNode::standAt(const Pose2& pose) {
  origin_ = pose;
  origin_broadcaster_.sendTransform(
      toTransformMsg(inSpace(pose), options_.pose.global_frame, origin_frame_, clock_.rosNow()));
}

void BrowserNode::receive(const hexapod_repertoire::Repertoire::ConstPtr& message) {
  try {
    repertoire_ = fromMsg(*message);
    learned_ = learnedWorldOf(robot_, repertoire_);
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("The repertoire cannot be shown: " << error.what());
    return;
  }
  showRepertoire();
  const auto best = bestEntry(repertoire_.entries);
  if (!model_ || !options_.play_best || clicked_ || !best) return;
  const Entry& entry = repertoire_.entries[*best];
  if (best_ == entry.id) return;
  best_ = entry.id;
  EntryPicture picture = pictureOf(entry);
  picture.remark = playOnModel(entry);
  show(picture);
}

void BrowserNode::receiveFilter(const hexapod_repertoire::RepertoireFilter::ConstPtr& message) {
  const auto orAny = [](double most) {
    return most < 0.0 ? std::numeric_limits<double>::infinity() : most;
  };
  filter_ = {orAny(message->max_orientation_error_rad), orAny(message->max_spread_m)};
  if (learned_) showRepertoire();
}

void BrowserNode::showRepertoire() {
  shown_ = repertoire_;
  shown_.entries.clear();
  std::copy_if(repertoire_.entries.begin(), repertoire_.entries.end(),
               std::back_inserter(shown_.entries),
               [this](const Entry& entry) { return filter_.passes(entry); });
  visualization_msgs::MarkerArray array = repertoireMarkers(shown_, origin_frame_);
  const auto scene = sceneMarkers(robot_, shown_, origin_frame_);
  array.markers.insert(array.markers.end(), scene.markers.begin(), scene.markers.end());
  marker_publisher_.publish(array);
  handle_.show(shown_.entries);
}

bool BrowserNode::onChoose(hexapod_repertoire::ChooseEntry::Request& request,
                           hexapod_repertoire::ChooseEntry::Response& response) {
  const auto& entries = repertoire_.entries;
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return entry.id == request.entry_id; });
  if (found == entries.end()) {
    response.message = "The published repertoire has no entry " + std::to_string(request.entry_id) +
                       "; it has " + std::to_string(entries.size()) + " entries.";
    return true;
  }
  const std::string problem = choose(*found, request.play != 0);
  response.success = problem.empty();
  response.message = problem.empty() ? describe(*found) : problem;
  return true;
}

void BrowserNode::onClick(ArchiveHandle::Wish wish, const Entry& entry) {
  EntryPicture picture = pictureOf(entry);
  switch (wish) {
    case ArchiveHandle::Wish::kPlay:
    case ArchiveHandle::Wish::kLookAt:
      choose(entry, wish == ArchiveHandle::Wish::kPlay);
      return;
    case ArchiveHandle::Wish::kGait:
      show(picture);
      showGait(entry);
      return;
    case ArchiveHandle::Wish::kNeighbours:
      picture.neighbours = neighboursOf(shown_.entries, entry, kNeighbours);
      break;
    case ArchiveHandle::Wish::kExclude:
      picture.remark = exclude(entry);
      break;
  }
  show(picture);
}

/// Shows an entry and plays it if asked; returns why it is not played, or "".
std::string BrowserNode::choose(const Entry& entry, bool play) {
  clicked_ = true;
  handle_.choose(entry.id);
  std::string remark;
  if (play) {
    remark = model_ ? playOnModel(entry) : player_->play(repertoire_.run_id, entry);
  }
  if (!remark.empty()) ROS_WARN_STREAM("Entry " << entry.id << " is not played: " << remark);
  EntryPicture picture = pictureOf(entry);
  picture.remark = remark;
  show(picture);
  return remark;
}

void BrowserNode::showGait(const Entry& entry) {
  if (repertoire_.robot_id != robot_.digest) {
    ROS_WARN_STREAM(kOtherRobot);
    return;
  }
  GaitPicture gait = gaitOf(robot_, recordEntry(robot_, *learned_, entry.genome),
                            learned_->behavior.command_period_s);
  gait.title = "entry " + std::to_string(entry.id);
  const Pose2 corner{kGaitAhead_m, roomBeside_m(robot_) + kGaitWider_m, 0.0};
  entry_publisher_.publish(gaitMarkers(gait, options_.pose.global_frame, origin_ * corner));
}

/// Has the file's server leave an entry out; returns what became of it.
std::string BrowserNode::exclude(const Entry& entry) {
  hexapod_repertoire::ExcludeEntry call;
  call.request.entry_id = entry.id;
  call.request.exclude = static_cast<std::uint8_t>(true);
  if (!exclude_.exists() || !exclude_.call(call)) {
    return "Only of a stored repertoire (./run view, ./run walk) can entries be left out.";
  }
  return call.response.message;
}

EntryPicture BrowserNode::pictureOf(const Entry& entry) const {
  return {options_.pose.global_frame, origin_, entry, {}, "", {}, roomBeside_m(robot_)};
}

/// Empty, or why not.
std::string BrowserNode::playOnModel(const Entry& entry) {
  if (repertoire_.robot_id != robot_.digest) {
    return kOtherRobot;
  }
  model_->play(*learned_, entry.genome);
  return "";
}

void BrowserNode::tell(const RobotPlayer::Report& report) {
  if (!report.problem.empty()) {
    ROS_WARN_STREAM("Entry " << report.entry.id << ": " << report.problem);
  }
  show({options_.pose.global_frame,
        report.start.value_or(Pose2()),
        report.entry,
        report.reached,
        report.problem,
        {},
        roomBeside_m(robot_)});
  if (!report.start || !report.reached) return;
  const Pose2 predicted = *report.start * report.entry.expectedPose();
  hexapod_repertoire::StepReport step;
  step.header.frame_id = options_.pose.global_frame;
  step.header.stamp = clock_.rosNow();
  step.step = ++steps_;
  step.entry_id = report.entry.id;
  step.start = toPose2DMsg(*report.start);
  step.predicted = toPose2DMsg(predicted);
  step.measured = toPose2DMsg(*report.reached);
  step.xy_error_m = distance(predicted, *report.reached);
  step.yaw_error_rad = headingDistance(predicted, *report.reached);
  step_publisher_.publish(step);
}

/// The diagram of another entry's gait goes.
void BrowserNode::show(const EntryPicture& picture) {
  visualization_msgs::MarkerArray array = entryMarkers(picture);
  const auto gone = noGaitMarkers(robot_.legs.size(), picture.frame);
  array.markers.insert(array.markers.end(), gone.markers.begin(), gone.markers.end());
  entry_publisher_.publish(array);
}

}  // namespace hexapod
