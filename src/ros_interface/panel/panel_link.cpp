#include "ros_interface/panel/panel_link.h"

#include <geometry_msgs/PointStamped.h>
#include <ros/service.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <utility>

#include "hexapod_repertoire/ChooseEntry.h"
#include "hexapod_repertoire/GoTo.h"
#include "hexapod_repertoire/LoadRepertoire.h"
#include "hexapod_repertoire/RepertoireFilter.h"
#include "ros_interface/common/names.h"

namespace hexapod {
namespace {

constexpr std::uint32_t kQueueSize = 20;
constexpr std::uint32_t kCallsAtOnce = 4;
constexpr char kPauseService[] = "learner/pause";

class Call : public ros::CallbackInterface {
 public:
  explicit Call(std::function<void()> body) : body_(std::move(body)) {}
  CallResult call() override {
    body_();
    return Success;
  }

 private:
  std::function<void()> body_;
};

std::string triggerOf(Ask ask) {
  switch (ask) {
    case Ask::kSave:
      return "learner/save";
    case Ask::kArm:
      return "executor/arm";
    case Ask::kStop:
      return "executor/stop";
    case Ask::kStand:
      return "executor/stand";
    case Ask::kSit:
      return "executor/sit";
    case Ask::kCancel:
      return "planner/cancel";
    default:
      return "";
  }
}

}  // namespace

PanelLink::PanelLink(const ros::NodeHandle& node, PanelModel& model, Panel panel)
    : model_(model),
      panel_(std::move(panel)),
      node_(node),
      topic_spinner_(1, &topics_),
      call_spinner_(kCallsAtOnce, &calls_) {
  node_.setCallbackQueue(&topics_);
  filter_publisher_ =
      node_.advertise<hexapod_repertoire::RepertoireFilter>(names::kRepertoireFilter, 1, true);
  pointer_publisher_ = node_.advertise<geometry_msgs::PointStamped>(names::kRepertoirePointer, 1);
  progress_ = listen("learner/progress", &PanelModel::hearProgress);
  executor_ = listen(names::kExecutorState, &PanelModel::hearExecutor);
  plan_ = listen("planner/walk_summary", &PanelModel::hearSummary);
  handles_ = listen("browser/step_report", &PanelModel::hearPlayed);
  others_ = {listen("learner/history", &PanelModel::hearHistory),
             listen("planner/step_report", &PanelModel::hearStep),
             listen(names::kBodyBelief, &PanelModel::hearBelief),
             listen(names::kRepertoire, &PanelModel::hearRepertoire),
             listen("/diagnostics", &PanelModel::hearDiagnostics)};
  topic_spinner_.start();
  call_spinner_.start();
}

PanelLink::~PanelLink() {
  topic_spinner_.stop();
  call_spinner_.stop();
}

template <class Message>
ros::Subscriber PanelLink::listen(const std::string& topic,
                                  void (PanelModel::*hear)(const Message&)) {
  const boost::function<void(const boost::shared_ptr<const Message>&)> receive =
      [this, hear](const boost::shared_ptr<const Message>& message) {
        panel_.post([this, hear, message] {
          (model_.*hear)(*message);
          panel_.changed();
        });
      };
  return node_.subscribe<Message>(topic, kQueueSize, receive);
}

template <class Service>
void PanelLink::call(const std::string& name, Service service) {
  const std::string full_name = node_.resolveName(name);
  calls_.addCallback(boost::make_shared<Call>([this, full_name, service]() mutable {
    std::string sentence;
    if (!ros::service::exists(full_name, false)) {
      sentence = "Nobody answers on " + full_name + ".";
    } else if (!ros::service::call(full_name, service)) {
      sentence = full_name + " gave no answer.";
    } else {
      sentence = service.response.message;
    }
    panel_.post([this, sentence] { panel_.tell(sentence); });
  }));
}

void PanelLink::ask(Ask ask) {
  if (ask == Ask::kStart || ask == Ask::kPause) {
    std_srvs::SetBool pause;
    pause.request.data = ask == Ask::kPause;
    call(kPauseService, pause);
    return;
  }
  call(triggerOf(ask), std_srvs::Trigger());
}

void PanelLink::go(const geometry_msgs::PoseStamped& goal) {
  hexapod_repertoire::GoTo go_to;
  go_to.request.target_pose = goal;
  call("go_to", go_to);
}

void PanelLink::load(const std::string& file) {
  hexapod_repertoire::LoadRepertoire load;
  load.request.file = file;
  call("repertoire_server/load", load);
}

void PanelLink::choose(std::int64_t entry_id, bool play) {
  hexapod_repertoire::ChooseEntry choose;
  choose.request.entry_id = entry_id;
  choose.request.play = static_cast<std::uint8_t>(play);
  call("browser/choose", choose);
}

void PanelLink::publishFilter(const EntryFilter& filter) {
  const auto orAny = [](double most) { return std::isfinite(most) ? most : -1.0; };
  hexapod_repertoire::RepertoireFilter message;
  message.max_orientation_error_rad = orAny(filter.max_orientation_error_rad);
  message.max_spread_m = orAny(filter.max_spread_m);
  filter_publisher_.publish(message);
}

void PanelLink::publishPointer(double x_m, double y_m) {
  geometry_msgs::PointStamped place;
  place.header.frame_id = names::kRepertoireOriginFrame;
  place.header.stamp = ros::Time::now();
  place.point.x = x_m;
  place.point.y = y_m;
  pointer_publisher_.publish(place);
}

void PanelLink::lookAround() {
  PanelModel::Presence presence;
  presence.learner = progress_.getNumPublishers() > 0;
  presence.executor = executor_.getNumPublishers() > 0;
  presence.planner = plan_.getNumPublishers() > 0;
  presence.browser = handles_.getNumPublishers() > 0;
  model_.setPresence(presence);
  panel_.changed();
}

}  // namespace hexapod
