#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hexapod_repertoire/BodyBelief.h"
#include "hexapod_repertoire/ExecutorState.h"
#include "hexapod_repertoire/LearningHistory.h"
#include "hexapod_repertoire/LearningProgress.h"
#include "hexapod_repertoire/Repertoire.h"
#include "hexapod_repertoire/StepReport.h"
#include "hexapod_repertoire/WalkSummary.h"
#include "repertoire/entry_filter.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// What a person can ask of the nodes.
enum class Ask { kStart, kPause, kSave, kArm, kStop, kStand, kSit, kCancel, kGo, kLoad, kEntry };

/// What the panel in rviz shows and offers, made of what was heard. Knows neither Qt nor how
/// messages come. For one thread.
class PanelModel {
 public:
  /// Those whose presence is known by who publishes.
  struct Presence {
    bool learner = false;
    bool executor = false;
    bool planner = false;
    bool browser = false;
  };
  /// A point of both learning curves.
  struct CurvePoint {
    double evaluations = 0.0;
    double sparseness_cm = 0.0;
    double error_deg = 0.0;
  };
  /// A row of the list of entries.
  struct EntryLine {
    std::int64_t id = 0;
    Pose2 end;
    double error_deg = 0.0;
    std::optional<double> spread_cm;  ///< once validated
  };
  /// A row of the table of nodes.
  struct NodeLine {
    std::string name;
    std::string state;
    std::string reason;
    bool is_well = true;
  };

  void hearProgress(const hexapod_repertoire::LearningProgress& progress);
  /// Of what was before the panel came.
  void hearHistory(const hexapod_repertoire::LearningHistory& history);
  void hearExecutor(const hexapod_repertoire::ExecutorState& state) { executor_ = state; }
  void hearBelief(const hexapod_repertoire::BodyBelief& belief) { belief_ = belief.sentence; }
  void hearSummary(const hexapod_repertoire::WalkSummary& summary);
  /// Of the planner, and of the browser.
  void hearStep(const hexapod_repertoire::StepReport& report);
  void hearPlayed(const hexapod_repertoire::StepReport& report);
  void hearRepertoire(const hexapod_repertoire::Repertoire& repertoire);
  void hearDiagnostics(const diagnostic_msgs::DiagnosticArray& diagnostics);
  void setPresence(const Presence& presence) { presence_ = presence; }

  void setFilter(const EntryFilter& filter);
  const EntryFilter& filter() const { return filter_; }

  /// False while nobody would do it, or it would change nothing.
  bool offers(Ask ask) const;

  /// Of the run so far, evaluations growing.
  const std::vector<CurvePoint>& curve() const { return curve_; }
  std::string learningSentence() const;
  std::string walkingSentence() const;
  std::string repertoireSentence() const;
  /// Entries that pass the filter, by id.
  std::vector<EntryLine> entries() const;
  /// The entry of entries() that is expected to end at a place in the frame of the start [m], or
  /// near it.
  std::optional<Entry> entryAt(double x_m, double y_m) const;
  /// Grows whenever entries() may have changed.
  int entriesRevision() const { return entries_revision_; }
  std::vector<NodeLine> nodes() const;

 private:
  /// The curve begins anew with another run.
  void followRun(const std::string& run_id);
  NodeLine learnerLine() const;
  NodeLine executorLine() const;
  NodeLine plannerLine() const;
  NodeLine browserLine() const;

  Presence presence_;
  std::optional<hexapod_repertoire::LearningProgress> progress_;
  std::string run_id_;  // of the curve
  std::vector<CurvePoint> curve_;
  std::optional<hexapod_repertoire::ExecutorState> executor_;
  std::string belief_;
  std::string walk_;    // how the walk goes, or went
  std::string played_;  // the same of what the browser had played
  Repertoire repertoire_;
  std::string repertoire_problem_;
  EntryFilter filter_;
  int entries_revision_ = 0;
  std::map<std::string, NodeLine> diagnostics_;
};

}  // namespace hexapod
