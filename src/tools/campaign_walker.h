#pragma once

#include <cstdint>

#include "common/random.h"
#include "tools/walk_campaign.h"

namespace hexapod {

/// One robot of a campaign on its way: plans, plays one behaviour, measures, again.
class CampaignWalker {
 public:
  /// The references must outlive it. `number` tells walkers of one campaign apart.
  CampaignWalker(World& world, const Repertoire& repertoire, const LearnedWorld& learned,
                 const CampaignOptions& options, std::uint64_t number);

  /// Stands it up where it began.
  void restart() { world_.restart(); }
  Pose2 pose() const { return footprint(world_.worldFromBase()); }

  /// From where it stands; `self_model` is asked what it believes, null: there is none.
  GoalWalk walkTo(const Pose2& goal, AdaptivePlanner& planner, const SelfModel* self_model);

 private:
  bool arrived(const Pose2& goal) const;
  Pose2 measuredPose();
  Outcome playEntry(std::size_t entry);
  void noteBelief(const SelfModel& self_model, GoalWalk& walk) const;

  World& world_;
  const Repertoire& repertoire_;
  const LearnedWorld& learned_;
  const CampaignOptions& options_;
  Random random_;
};

}  // namespace hexapod
