#include "ros_interface/learner/learner_node.h"

#include <chrono>
#include <functional>
#include <thread>
#include <utility>

#include "ros_interface/common/node_process.h"
#include "ros_interface/common/robot_param.h"
#include "ros_interface/learner/executor_trial_robot.h"

namespace hexapod {
namespace {

constexpr std::chrono::milliseconds kPoll{50};

// Calls a function once the process is asked to leave, or at its own end.
class LeavingWatch {
 public:
  explicit LeavingWatch(std::function<void()> leave)
      : thread_([this, leave = std::move(leave)] {
          while (!askedToLeave() && !over_) std::this_thread::sleep_for(kPoll);
          leave();
        }) {}
  ~LeavingWatch() {
    over_ = true;
    thread_.join();
  }
  LeavingWatch(const LeavingWatch&) = delete;
  LeavingWatch& operator=(const LeavingWatch&) = delete;

 private:
  std::atomic<bool> over_{false};
  std::thread thread_;
};

std::unique_ptr<TrialRobot> robotToTry(ros::NodeHandle& node, const LearnerOptions& options,
                                       const Clock& clock) {
  const TransferOptions& transfer = options.learn.transfer;
  if (!transfer.transferability || !transfer.robot_body.empty()) return nullptr;
  return std::make_unique<ExecutorTrialRobot>(node, options.pose, clock, askedToLeave);
}

}  // namespace

LearnerNode::LearnerNode(ros::NodeHandle& node, ros::NodeHandle& private_node,
                         const LearnerOptions& options)
    : robot_(robotToTry(node, options, clock_)),
      core_(robotFromParams(node, options.robot_config), options, clock_, *this, askedToLeave,
            robot_.get()),
      repertoire_publisher_(node, options.pose.base_frame),
      progress_publisher_(
          private_node.advertise<hexapod_repertoire::LearningProgress>("progress", 1, true)),
      history_publisher_(
          private_node.advertise<hexapod_repertoire::LearningHistory>("history", 1, true)),
      save_(private_node.advertiseService("save", &LearnerNode::onSave, this)),
      pause_(private_node.advertiseService("pause", &LearnerNode::onPause, this)) {}

int LearnerNode::run() {
  // A request to leave must reach into a generation under way.
  const LeavingWatch watch([this] { core_.requestStop(); });
  return core_.run();
}

void LearnerNode::show(const Repertoire& repertoire) { repertoire_publisher_.publish(repertoire); }

void LearnerNode::tell(const hexapod_repertoire::LearningProgress& progress) {
  progress_publisher_.publish(progress);
}

void LearnerNode::tell(const hexapod_repertoire::LearningHistory& history) {
  history_publisher_.publish(history);
}

bool LearnerNode::onSave(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const LearnerCore::Answer answer = core_.save();
  response.success = answer.success;
  response.message = answer.message;
  return true;
}

bool LearnerNode::onPause(std_srvs::SetBool::Request& request,
                          std_srvs::SetBool::Response& response) {
  const LearnerCore::Answer answer = core_.pause(request.data);
  response.success = answer.success;
  response.message = answer.message;
  return true;
}

}  // namespace hexapod
