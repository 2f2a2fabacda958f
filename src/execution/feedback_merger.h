#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "execution/joint_readings.h"
#include "execution/source_clock.h"

namespace hexapod {

/// A message with joint angles as it arrived, in the driver's names and units.
struct FeedbackMessage {
  const std::vector<std::string>& names;
  const std::vector<double>& positions_rad;
  std::int64_t stamp_ns = 0;  ///< ROS time; 0: not stamped, new when it arrives
  std::string source;         ///< the node that sent it
  Arrival arrival;
};

/// Makes one set of readings, joint by joint, of messages that may come from several drivers, each
/// for some of the joints, in any order and with other devices' joints among them.
///
/// Believed is what is fresh (SourceClock) and new: a joint's reading with the stamp of its last
/// one tells nothing. Every joint belongs to the source that reported it first, until that has been
/// silent for longer than any feedback timeout allows: what another source says of it is left out,
/// and the joint is contested for as long as both talk. A message with a number that is none, a
/// joint twice or other than one position per name is refused as a whole. Not thread-safe.
class FeedbackMerger {
 public:
  enum class Result {
    kUsed,     ///< at least one joint has a new reading
    kNothing,  ///< no joint of this robot, or nothing new of them
    kRefused   ///< see problem()
  };

  /// `names` as the driver calls the joints, in joint order; no name twice. `timeout_s`: the age
  /// beyond which a reading is not believed.
  FeedbackMerger(const std::vector<std::string>& names, double timeout_s);

  Result add(const FeedbackMessage& message);

  /// When something happened that `source` tells, on the arrival's steady time; nothing when its
  /// stamp is not fresh, see problem(). What is not stamped (0) happens when it comes.
  std::optional<std::int64_t> timeOf(const std::string& source, std::int64_t stamp_ns,
                                     const Arrival& arrival);

  /// Angles as the driver counts them.
  const JointReadings& readings() const { return readings_; }

  /// A sentence about the last message refused; "" when none was.
  const std::string& problem() const { return problem_; }

  /// "/driver and /joint_state_publisher" for a contested joint, else "".
  std::string rivals(int joint) const;

 private:
  struct Claim {
    std::string owner;
    std::int64_t owner_heard_ns = 0;  // steady
    std::int64_t stamp_ns = 0;
    std::string rival;
    std::int64_t rival_heard_ns = 0;  // steady
  };

  struct Source {
    SourceClock clock;
    std::int64_t heard_ns;  // steady
  };

  SourceClock& clockOf(const std::string& name, std::int64_t now_ns);
  bool findJoints(const FeedbackMessage& message);
  bool take(std::size_t joint, double position_rad, const FeedbackMessage& message);
  int contestedJoint(std::int64_t now_ns) const;
  Result refuse(const std::string& problem);

  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> index_;
  std::int64_t timeout_ns_;
  std::int64_t patience_ns_;               // with a silent source; the executor has less
  std::map<std::string, Source> sources_;  // by name; silent ones go when a new one comes
  std::vector<Claim> claims_;              // by joint
  JointReadings readings_;
  std::vector<std::pair<std::size_t, double>> found_;  // joints of the message and their positions
  std::string problem_;
};

}  // namespace hexapod
