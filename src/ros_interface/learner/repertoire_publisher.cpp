#include "ros_interface/learner/repertoire_publisher.h"

#include <utility>

#include "ros_interface/common/conversions.h"
#include "ros_interface/common/names.h"

namespace hexapod {

RepertoirePublisher::RepertoirePublisher(ros::NodeHandle& node, std::string base_frame)
    : base_frame_(std::move(base_frame)),
      repertoire_publisher_(
          node.advertise<hexapod_repertoire::Repertoire>(names::kRepertoire, 1, true)),
      service_(node.advertiseService("get_repertoire", &RepertoirePublisher::answer, this)) {}

void RepertoirePublisher::publish(const Repertoire& repertoire) {
  const auto message = toMsg(repertoire, ros::Time::now(), base_frame_);
  repertoire_publisher_.publish(message);
  const std::lock_guard<std::mutex> lock(mutex_);
  latest_ = message;
  published_ = true;
}

bool RepertoirePublisher::answer(hexapod_repertoire::GetRepertoire::Request&,
                                 hexapod_repertoire::GetRepertoire::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  response.success = published_;
  response.message = published_ ? "The repertoire of run " + latest_.run_id + "."
                                : "No repertoire yet: learning has just begun; ask again in a few "
                                  "seconds or subscribe to the topic repertoire.";
  response.repertoire = latest_;
  return true;
}

}  // namespace hexapod
