#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "gait/behavior.h"
#include "hexapod_repertoire/ExecuteBehaviorGoal.h"
#include "hexapod_repertoire/Repertoire.h"
#include "robot/robot_description.h"

namespace hexapod {

/// What may be played: the entries of the last repertoire that fits this robot, and bare genomes,
/// both as the repertoire says: gait, way back, rest and levels of genes are what it was learned
/// with. (A bare genome may have its own levels.)
/// Trusts no message. Not thread-safe.
class PlayableBehaviors {
 public:
  /// `options`: the command period, and how bare genomes are played until there is a repertoire.
  PlayableBehaviors(const RobotDescription& robot, const BehaviorOptions& options);

  /// Takes over a repertoire, or returns a sentence why it does not fit: another robot, joints or
  /// command period, times that contradict each other, illegal entries. Refused, the one before
  /// stays in use.
  std::string update(const hexapod_repertoire::Repertoire& message);

  /// The behaviour of a goal; nullptr with a sentence in `problem` when it names none.
  std::shared_ptr<const Behavior> find(const hexapod_repertoire::ExecuteBehaviorGoal& goal,
                                       std::string& problem) const;

  std::size_t entryCount() const { return genomes_.size(); }

  /// How behaviours are played now.
  const BehaviorOptions& options() const { return options_; }

  /// The body they were learned for, as a text; empty: the robot as its files describe it.
  const std::string& body() const { return body_; }

 private:
  using Genomes = std::unordered_map<std::int64_t, Genome>;

  std::string mismatch(const hexapod_repertoire::Repertoire& message) const;
  std::string readOptions(const hexapod_repertoire::Repertoire& message,
                          BehaviorOptions& options) const;
  std::string readEntries(const hexapod_repertoire::Repertoire& message, std::int64_t gene_levels,
                          Genomes& genomes) const;
  std::string checkGenome(const Genome& genome, std::int64_t gene_levels) const;
  /// The robot, of which no other joints move; a sentence in `problem` when it has not all of them.
  RobotDescription movingOnly(const std::vector<std::string>& joints, std::string& problem) const;

  const RobotDescription& robot_;
  BehaviorOptions options_;
  std::string run_id_;
  std::string body_;
  std::string problem_;  // why there is none
  Genomes genomes_;
};

}  // namespace hexapod
