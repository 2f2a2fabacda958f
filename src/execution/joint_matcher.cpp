#include "execution/joint_matcher.h"

#include <cmath>
#include <stdexcept>

namespace hexapod {

JointMatcher::JointMatcher(const std::vector<std::string>& names)
    : names_(names), candidate_(names.size()), seen_(names.size()) {
  for (std::size_t j = 0; j < names.size(); ++j) {
    if (index_.emplace(names[j], j).second) continue;
    throw std::invalid_argument("Joint '" + names[j] + "' occurs twice; names must be unique.");
  }
}

bool JointMatcher::match(const std::vector<std::string>& names, const std::vector<double>& values) {
  if (names.size() != values.size()) {
    return refuse("It has " + std::to_string(names.size()) + " names and " +
                  std::to_string(values.size()) + " positions; expected one position per name.");
  }
  seen_.assign(names_.size(), false);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = index_.find(names[i]);
    if (found == index_.end()) {
      return refuse("Joint '" + names[i] + "' is not one of the robot's.");
    }
    const std::size_t j = found->second;
    if (seen_[j]) return refuse("Joint '" + names[i] + "' occurs twice.");
    if (!std::isfinite(values[i])) {
      return refuse("The position of joint '" + names[i] + "' is not a finite number.");
    }
    seen_[j] = true;
    candidate_[j] = values[i];
  }
  for (std::size_t j = 0; j < names_.size(); ++j) {
    if (!seen_[j]) return refuse("Joint '" + names_[j] + "' is missing.");
  }
  values_ = candidate_;
  return true;
}

bool JointMatcher::refuse(const std::string& problem) {
  problem_ = problem;
  return false;
}

}  // namespace hexapod
