#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "hexapod_repertoire/LearningHistory.h"
#include "hexapod_repertoire/LearningProgress.h"
#include "learning/learning_session.h"
#include "learning/progress_display.h"
#include "ros_interface/common/clock.h"
#include "ros_interface/learner/learner_options.h"

namespace hexapod {

/// Whom a learner tells how far it is. Called by the thread of LearnerCore::run().
class LearnerAudience {
 public:
  virtual ~LearnerAudience() = default;
  /// The repertoire as it is now.
  virtual void show(const Repertoire& repertoire) = 0;
  virtual void tell(const hexapod_repertoire::LearningProgress& progress) = 0;
  /// Whenever it has grown.
  virtual void tell(const hexapod_repertoire::LearningHistory& history) = 0;
};

/// A LearningSession as a node has it, without the wire: what is told when, what ~save and ~pause
/// do and answer, what becomes of a save that failed, the exit code and the last words.
///
/// Repertoires are shown when they changed, at most every publish_period_s, and at the end;
/// progress is told once a second, paused or not, and shown as a ProgressDisplay does. save(),
/// pause() and requestStop() may be called from any thread.
class LearnerCore {
 public:
  struct Answer {
    bool success = false;
    std::string message;  ///< a sentence
  };

  /// Throws as LearningSession does. `leaves`: somebody asked the node to leave. Clock, audience
  /// and the robot that entries are tried on, where there is one, must outlive it.
  LearnerCore(const RobotDescription& robot, const LearnerOptions& options, const Clock& clock,
              LearnerAudience& audience, std::function<bool()> leaves,
              TrialRobot* trial_robot = nullptr);

  /// Learns in the calling thread until done or asked to leave; with exit_when_done false it waits
  /// then until it is. What could not be saved is tried again all the while, and some times more
  /// before it returns. Returns the exit code: 0 when all that was learned is in the file.
  int run();

  /// Ends learning within one simulated behaviour.
  void requestStop() { session_.requestStop(); }

  /// Writes the file: LearningSession::saveNow().
  Answer save();
  /// Pauses after what is under way, or goes on; refused once learning has ended.
  Answer pause(bool pause);

  /// What was learned, where it is and what to do with it; or what went wrong.
  std::string lastWords() const;

 private:
  /// Something that is done every now and then.
  class Now {
   public:
    /// True at first, and when the period has passed since it last was.
    bool isDue(std::int64_t now_ns, double period_s);

   private:
    std::optional<std::int64_t> last_ns_;
  };

  void onProgress();
  void waitWhilePaused();
  void tell(const LearningStatus& status);
  void tellHistory();
  void complain(const std::string& problem);
  void retrySaving();
  bool isDue(Now& now, double period_s) const { return now.isDue(clock_.steadyNow_ns(), period_s); }
  void sleep(std::int64_t ns) const;

  LearnerOptions options_;
  const Clock& clock_;
  LearnerAudience& audience_;
  std::function<bool()> leaves_;
  LearningSession session_;
  ProgressDisplay display_;
  std::string run_id_;
  std::atomic<bool> paused_{false};
  std::atomic<bool> ended_{false};
  std::size_t told_rows_ = 0;
  Now told_;
  Now shown_;
  Now complained_;
  Now tried_;
};

}  // namespace hexapod
