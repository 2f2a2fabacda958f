#include "ros_interface/executor/belief_listener.h"

#include "ros_interface/common/names.h"

namespace hexapod {
namespace {

constexpr std::uint32_t kBeliefQueue = 10;
// How often is looked whether what was told is too old.
constexpr double kBeliefLook_s = 0.1;

}  // namespace

BeliefListener::BeliefListener(const ros::NodeHandle& node, SharedExecutor& executor,
                               const RobotDescription& robot, const ExecutorOptions& options,
                               const Clock& clock)
    : executor_(executor),
      clock_(clock),
      judge_(robot, options.max_dead_legs, options.dead_legs),
      node_(node) {
  node_.setCallbackQueue(&queue_);
  if (options.max_dead_legs > 0) {
    subscriber_ = node_.subscribe<hexapod_repertoire::BodyBelief>(
        names::kBodyBelief, kBeliefQueue,
        boost::function<void(const Event&)>([this](const Event& event) { onBelief(event); }),
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  }
  thread_ = std::thread([this] { run(); });
}

BeliefListener::~BeliefListener() {
  running_ = false;
  thread_.join();
}

std::string BeliefListener::problem() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return problem_;
}

void BeliefListener::run() {
  while (running_) {
    queue_.callAvailable(ros::WallDuration(kBeliefLook_s));
    apply();
  }
}

void BeliefListener::onBelief(const Event& event) {
  const hexapod_repertoire::BodyBelief& message = *event.getConstMessage();
  judge_.hear({event.getPublisherName(),
               message.robot_id,
               message.dead_joints,
               toNs(message.header.stamp),
               {toNs(clock_.rosNow()), clock_.robotNow_ns()},
               clock_.steadyNow_ns()});
  apply();
}

// What a stop came in between of is asked for again.
void BeliefListener::apply() {
  const std::int64_t now_ns = clock_.steadyNow_ns();
  const JointTolerance tolerance = judge_.tolerance(now_ns);
  if (!(tolerance == applied_) && executor_.tolerate(tolerance).accepted()) applied_ = tolerance;
  const std::lock_guard<std::mutex> lock(mutex_);
  problem_ = judge_.problem(now_ns);
}

}  // namespace hexapod
