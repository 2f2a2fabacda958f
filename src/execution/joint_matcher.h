#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace hexapod {

/// Brings named joint values into the order of the robot description, or says what is wrong.
///
/// The last check before numbers from a wire meet physics: every joint exactly once and no other,
/// every value finite. One owner; not thread-safe.
class JointMatcher {
 public:
  /// Throws std::invalid_argument when a name occurs twice.
  explicit JointMatcher(const std::vector<std::string>& names);

  /// True when the message fits; its values are then in values(), else problem() is a sentence.
  bool match(const std::vector<std::string>& names, const std::vector<double>& values);

  /// Values of the last message that fitted, in joint order.
  const std::vector<double>& values() const { return values_; }
  const std::string& problem() const { return problem_; }

 private:
  bool refuse(const std::string& problem);

  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> index_;
  std::vector<double> candidate_;
  std::vector<bool> seen_;
  std::vector<double> values_;
  std::string problem_;
};

}  // namespace hexapod
