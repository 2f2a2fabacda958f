#include "learning/checkpoint.h"

#include <array>
#include <map>
#include <sstream>
#include <stdexcept>

#include "common/text.h"
#include "evolution/evolution_state.h"

namespace hexapod {
namespace {

constexpr std::array<LearningPhase, 5> kPhases = {
    LearningPhase::kEvolving, LearningPhase::kVerifying, LearningPhase::kValidating,
    LearningPhase::kTryingWorlds, LearningPhase::kDone};
// Evolution's own texts stand beside these.
constexpr const char* kPhaseKey = "session.phase";
constexpr const char* kElapsedKey = "session.elapsed_s";
constexpr const char* kSimulationsKey = "session.simulations";
constexpr const char* kArchiveOrderKey = "session.archive_order";
constexpr const char* kDroppedKey = "session.dropped";

[[noreturn]] void fail(const std::string& name, const std::string& expected,
                       const std::string& found) {
  throw std::invalid_argument("The learner state '" + name + "' cannot be used: expected " +
                              expected + ", found " + found + ".");
}

std::string textOf(const LearnerState& state, const std::string& name) {
  const auto found = state.find(name);
  if (found == state.end()) fail(name, "a text", "none");
  return found->second;
}

LearningPhase phaseFrom(const LearnerState& state) {
  const std::string text = textOf(state, kPhaseKey);
  for (const LearningPhase phase : kPhases) {
    if (text == toString(phase)) return phase;
  }
  fail(kPhaseKey, "evolving, verifying, validating, trying_worlds or done", "'" + text + "'");
}

double elapsedFrom(const LearnerState& state) {
  const std::string text = textOf(state, kElapsedKey);
  const auto number = doubleFromText(text);
  if (!number || !(*number >= 0.0)) fail(kElapsedKey, "seconds", "'" + text + "'");
  return *number;
}

std::int64_t simulationsFrom(const LearnerState& state) {
  const std::string text = textOf(state, kSimulationsKey);
  const auto number = integerFromText(text);
  if (!number || *number < 0) fail(kSimulationsKey, "a count", "'" + text + "'");
  return *number;
}

/// A line: "id genome x_m y_m yaw_rad cost evaluation".
std::string lineOf(const Entry& entry) {
  std::string line = std::to_string(entry.id) + " " + toString(entry.genome);
  for (const double number :
       {entry.end_pose.x_m, entry.end_pose.y_m, entry.end_pose.yaw_rad, entry.cost}) {
    line += " " + exactText(number);
  }
  return line + " " + std::to_string(entry.evaluation) + "\n";
}

Entry entryFrom(const std::string& line) {
  Entry entry;
  std::istringstream words(line);
  std::string genome, word;
  const auto integer = [&] {
    words >> word;
    const auto number = integerFromText(word);
    if (!words || !number) fail(kDroppedKey, "entries of 7 values", "'" + line + "'");
    return *number;
  };
  const auto number = [&] {
    words >> word;
    const auto number = doubleFromText(word);
    if (!words || !number) fail(kDroppedKey, "entries of 7 values", "'" + line + "'");
    return *number;
  };
  entry.id = integer();
  words >> genome;
  entry.genome = genomeFromString(genome);
  entry.end_pose = {number(), number(), number()};
  entry.cost = number();
  entry.evaluation = integer();
  return entry;
}

std::vector<Entry> droppedFrom(const LearnerState& state) {
  std::vector<Entry> dropped;
  std::istringstream lines(textOf(state, kDroppedKey));
  for (std::string line; std::getline(lines, line);) dropped.push_back(entryFrom(line));
  return dropped;
}

/// The entries in the order of the archive that was saved, as it was before validation.
std::vector<Entry> archiveFrom(const StoredRepertoire& stored) {
  std::map<std::int64_t, Entry> by_id;
  for (const Entry& entry : droppedFrom(stored.learner_state)) by_id[entry.id] = entry;
  for (const Entry& entry : stored.repertoire.entries) by_id[entry.id] = entry;
  std::vector<Entry> archive;
  std::istringstream ids(textOf(stored.learner_state, kArchiveOrderKey));
  for (std::string id; ids >> id;) {
    const auto number = integerFromText(id);
    const auto found = number ? by_id.find(*number) : by_id.end();
    if (found == by_id.end()) fail(kArchiveOrderKey, "ids of entries, each once", "'" + id + "'");
    archive.push_back(found->second);
    archive.back().execution.reset();
    by_id.erase(found);
  }
  if (!by_id.empty()) {
    fail(kArchiveOrderKey, "the id of every entry", "no " + std::to_string(by_id.begin()->first));
  }
  return archive;
}

}  // namespace

std::string toString(LearningPhase phase) {
  switch (phase) {
    case LearningPhase::kEvolving:
      return "evolving";
    case LearningPhase::kVerifying:
      return "verifying";
    case LearningPhase::kValidating:
      return "validating";
    case LearningPhase::kTryingWorlds:
      return "trying_worlds";
    case LearningPhase::kDone:
      return "done";
  }
  return "unknown";
}

LearnerState toLearnerState(const Checkpoint& checkpoint) {
  LearnerState state = toTexts(checkpoint.evolution);
  state[kPhaseKey] = toString(checkpoint.phase);
  state[kElapsedKey] = exactText(checkpoint.elapsed_s);
  state[kSimulationsKey] = std::to_string(checkpoint.simulations);
  std::string& order = state[kArchiveOrderKey];
  for (const Entry& entry : checkpoint.evolution.archive) order += std::to_string(entry.id) + "\n";
  std::string& dropped = state[kDroppedKey];
  for (const Entry& entry : checkpoint.evolution.archive) {
    if (checkpoint.dropped.count(entry.id) > 0) dropped += lineOf(entry);
  }
  return state;
}

Checkpoint checkpointFrom(const StoredRepertoire& stored) {
  const LearnerState& state = stored.learner_state;
  std::set<std::int64_t> dropped;
  for (const Entry& entry : droppedFrom(state)) dropped.insert(entry.id);
  return {stateFromTexts(state, archiveFrom(stored)), phaseFrom(state), elapsedFrom(state),
          simulationsFrom(state), dropped};
}

}  // namespace hexapod
