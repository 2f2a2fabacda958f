#include "ros_interface/panel/panel_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "common/text.h"
#include "geometry/pose2.h"
#include "repertoire/entry_choice.h"
#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

using hexapod_repertoire::ExecutorState;

// The mouse means an entry no farther away than this.
constexpr double kHoverReach_m = 0.03;
constexpr char kPaused[] = "paused";
constexpr char kDone[] = "done";

std::string nameOf(std::uint8_t state) {
  switch (state) {
    case ExecutorState::DISARMED:
      return "disarmed";
    case ExecutorState::STANDING_UP:
      return "standing up";
    case ExecutorState::READY:
      return "ready";
    case ExecutorState::WALKING:
      return "walking";
    case ExecutorState::HOLDING:
      return "holding";
    case ExecutorState::STOPPED:
      return "stopped";
    case ExecutorState::FAULT:
      return "fault";
    case ExecutorState::SITTING_DOWN:
      return "sitting down";
    default:
      return "unknown";
  }
}

bool sendsNothing(std::uint8_t state) {
  return state == ExecutorState::DISARMED || state == ExecutorState::STOPPED ||
         state == ExecutorState::FAULT;
}

std::string howItEnded(const hexapod_repertoire::StepReport& report) {
  return "entry " + std::to_string(report.entry_id) + " ended " +
         fixedText(100.0 * report.xy_error_m, 1) + " cm and " +
         fixedText(report.yaw_error_rad / kDegree, 1) + " deg from its prediction";
}

PanelModel::NodeLine absent(const std::string& name, const std::string& reason) {
  return {name, "not here", reason, true};
}

}  // namespace

void PanelModel::hearProgress(const hexapod_repertoire::LearningProgress& progress) {
  followRun(progress.run_id);
  progress_ = progress;
  const auto evaluations = static_cast<double>(progress.evaluations);
  if (progress.archive_size == 0) return;
  if (!curve_.empty() && evaluations <= curve_.back().evaluations) return;
  curve_.push_back({evaluations, 100.0 * progress.sparseness_m,
                    progress.median_orientation_error_rad / kDegree});
}

void PanelModel::hearHistory(const hexapod_repertoire::LearningHistory& history) {
  followRun(history.run_id);
  const std::size_t rows = std::min({history.evaluations.size(), history.sparseness_m.size(),
                                     history.median_orientation_error_rad.size()});
  std::vector<CurvePoint> curve;
  for (std::size_t i = 0; i < rows; ++i) {
    curve.push_back({static_cast<double>(history.evaluations[i]), 100.0 * history.sparseness_m[i],
                     history.median_orientation_error_rad[i] / kDegree});
  }
  const double known = curve.empty() ? -1.0 : curve.back().evaluations;
  std::copy_if(curve_.begin(), curve_.end(), std::back_inserter(curve),
               [known](const CurvePoint& point) { return point.evaluations > known; });
  curve_ = std::move(curve);
}

void PanelModel::followRun(const std::string& run_id) {
  if (run_id == run_id_) return;
  run_id_ = run_id;
  curve_.clear();
}

void PanelModel::hearSummary(const hexapod_repertoire::WalkSummary& summary) {
  walk_ = summary.message;
}

void PanelModel::hearStep(const hexapod_repertoire::StepReport& report) {
  walk_ = "Step " + std::to_string(report.step) + ": " + howItEnded(report) + ".";
}

void PanelModel::hearPlayed(const hexapod_repertoire::StepReport& report) {
  played_ = howItEnded(report);
}

void PanelModel::setFilter(const EntryFilter& filter) {
  filter_ = filter;
  ++entries_revision_;
}

void PanelModel::hearRepertoire(const hexapod_repertoire::Repertoire& repertoire) {
  ++entries_revision_;
  try {
    repertoire_ = fromMsg(repertoire);
    repertoire_problem_.clear();
  } catch (const std::invalid_argument& error) {
    repertoire_problem_ = error.what();
  }
}

void PanelModel::hearDiagnostics(const diagnostic_msgs::DiagnosticArray& diagnostics) {
  using diagnostic_msgs::DiagnosticStatus;
  for (const DiagnosticStatus& status : diagnostics.status) {
    const bool is_well = status.level == DiagnosticStatus::OK;
    diagnostics_[status.name] = {status.name, is_well ? "well" : "look", status.message, is_well};
  }
}

bool PanelModel::offers(Ask ask) const {
  const bool learns = presence_.learner && progress_;
  const bool has_executor = presence_.executor && executor_;
  switch (ask) {
    case Ask::kStart:
      return learns && progress_->phase == kPaused;
    case Ask::kPause:
      return learns && progress_->phase != kPaused && progress_->phase != kDone;
    case Ask::kSave:
      return learns;
    case Ask::kArm:
      return has_executor && sendsNothing(executor_->state);
    case Ask::kStop:
      return true;  // also when nobody was heard: whoever presses it means it
    case Ask::kStand:
    case Ask::kSit:
      return has_executor && executor_->state == ExecutorState::READY;
    case Ask::kCancel:
      return presence_.planner;
    case Ask::kGo:
      return presence_.planner && has_executor && !sendsNothing(executor_->state);
    case Ask::kLoad:
      return !presence_.learner;
    case Ask::kEntry:
      return presence_.browser;
  }
  return false;
}

std::string PanelModel::learningSentence() const {
  if (!presence_.learner || !progress_) {
    return "Nobody learns here. To begin: ./run learn rviz:=true start_paused:=true";
  }
  const NodeLine line = learnerLine();
  return "Learner " + line.state + ": " + line.reason;
}

std::string PanelModel::walkingSentence() const {
  if (!presence_.executor || !executor_)
    return "Nobody walks here. To begin: ./run walk rviz:=true";
  std::string text = "Executor " + nameOf(executor_->state) + ". " + executor_->reason;
  if (!belief_.empty()) text += "\n" + belief_;
  if (!walk_.empty()) text += "\n" + walk_;
  return text;
}

std::string PanelModel::repertoireSentence() const {
  if (!repertoire_problem_.empty()) return repertoire_problem_;
  if (repertoire_.entries.empty()) return "No repertoire is published.";
  std::string text = std::to_string(entries().size()) + " of " +
                     std::to_string(repertoire_.entries.size()) + " entries of run " +
                     repertoire_.run_id;
  if (!repertoire_.body().empty()) text += ", learned for this body: " + repertoire_.body();
  return text + ".";
}

std::optional<Entry> PanelModel::entryAt(double x_m, double y_m) const {
  std::vector<Entry> passed;
  std::copy_if(repertoire_.entries.begin(), repertoire_.entries.end(), std::back_inserter(passed),
               [this](const Entry& entry) { return filter_.passes(entry); });
  const auto found = entryNear(passed, x_m, y_m, kHoverReach_m);
  if (!found) return std::nullopt;
  return passed[*found];
}

std::vector<PanelModel::EntryLine> PanelModel::entries() const {
  std::vector<EntryLine> lines;
  for (const Entry& entry : repertoire_.entries) {
    if (!filter_.passes(entry)) continue;
    EntryLine line{entry.id, entry.expectedPose(), orientationError(entry.expectedPose()) / kDegree,
                   std::nullopt};
    if (entry.execution) line.spread_cm = 100.0 * entry.execution->spread_m;
    lines.push_back(line);
  }
  return lines;
}

PanelModel::NodeLine PanelModel::learnerLine() const {
  if (!presence_.learner || !progress_) return absent("learner", "./run learn");
  std::string reason = std::to_string(progress_->evaluations) + " of " +
                       std::to_string(progress_->evaluations_budget) + " candidates, " +
                       std::to_string(progress_->archive_size) + " entries";
  if (progress_->eta_s > 0.0) reason += ", " + fixedText(progress_->eta_s, 0) + " s left";
  return {"learner", progress_->phase, reason, true};
}

PanelModel::NodeLine PanelModel::executorLine() const {
  if (!presence_.executor || !executor_) return absent("executor", "./run walk");
  const bool is_well =
      executor_->state != ExecutorState::FAULT && executor_->state != ExecutorState::STOPPED;
  return {"executor", nameOf(executor_->state), executor_->reason, is_well};
}

PanelModel::NodeLine PanelModel::plannerLine() const {
  if (!presence_.planner) return absent("planner", "./run walk");
  return {"planner", "here", walk_.empty() ? "no goal yet" : walk_, true};
}

PanelModel::NodeLine PanelModel::browserLine() const {
  if (!presence_.browser) return absent("browser", "roslaunch hexapod_repertoire rviz.launch");
  return {"browser", "here", played_.empty() ? "nothing was played yet" : played_, true};
}

std::vector<PanelModel::NodeLine> PanelModel::nodes() const {
  std::vector<NodeLine> lines = {learnerLine(), executorLine(), plannerLine(), browserLine()};
  for (const auto& [name, line] : diagnostics_) lines.push_back(line);
  return lines;
}

}  // namespace hexapod
