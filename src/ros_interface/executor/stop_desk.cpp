#include "ros_interface/executor/stop_desk.h"

namespace hexapod {

bool StopDesk::hear(bool pressed) {
  executor_.setEStop(pressed);
  return !pressed_.exchange(pressed) && pressed;
}

std::string StopDesk::stop() {
  executor_.stop(Reason::kStopRequested);
  return "Stopped; nothing is sent until ~arm.";
}

}  // namespace hexapod
