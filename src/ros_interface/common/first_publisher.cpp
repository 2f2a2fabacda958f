#include "ros_interface/common/first_publisher.h"

#include <algorithm>
#include <utility>

namespace hexapod {

FirstPublisher::FirstPublisher(std::function<std::vector<std::string>()> publishers)
    : publishers_(std::move(publishers)) {}

std::string FirstPublisher::whyRefused(const std::string& publisher) const {
  if (in_use_.empty() || publisher == in_use_) return "";
  const std::vector<std::string> now = publishers_();
  if (std::find(now.begin(), now.end(), in_use_) == now.end()) return "";
  return "Two nodes publish a repertoire: " + in_use_ + " and " + publisher + ". The one of " +
         in_use_ + " stays in use; stop one of them.";
}

}  // namespace hexapod
