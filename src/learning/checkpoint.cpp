#include "learning/checkpoint.h"

#include <array>
#include <stdexcept>

#include "common/text.h"
#include "evolution/evolution_state.h"

namespace hexapod {
namespace {

constexpr std::array<LearningPhase, 6> kPhases = {
    LearningPhase::kEvolving,     LearningPhase::kVerifying,    LearningPhase::kValidating,
    LearningPhase::kTryingWorlds, LearningPhase::kTransferring, LearningPhase::kDone};
// Evolution's own values stand beside these.
constexpr const char* kPhaseKey = "session.phase";
constexpr const char* kElapsedKey = "session.elapsed_s";
constexpr const char* kSimulationsKey = "session.simulations";
// Only where trials are made.
constexpr const char* kAttemptsKey = "session.trial_attempts";

[[noreturn]] void fail(const std::string& name, const std::string& expected,
                       const std::string& found) {
  throw std::invalid_argument("The learner state '" + name + "' cannot be used: expected " +
                              expected + ", found " + found + ".");
}

std::string textOf(const LearnerState& state, const std::string& name) {
  const auto found = state.values.find(name);
  if (found == state.values.end()) fail(name, "a text", "none");
  return found->second;
}

LearningPhase phaseFrom(const LearnerState& state) {
  const std::string text = textOf(state, kPhaseKey);
  for (const LearningPhase phase : kPhases) {
    if (text == toString(phase)) return phase;
  }
  fail(kPhaseKey, "evolving, verifying, validating, trying_worlds, transferring or done",
       "'" + text + "'");
}

double elapsedFrom(const LearnerState& state) {
  const std::string text = textOf(state, kElapsedKey);
  const auto number = doubleFromText(text);
  if (!number || !(*number >= 0.0)) fail(kElapsedKey, "seconds", "'" + text + "'");
  return *number;
}

std::int64_t countFrom(const LearnerState& state, const std::string& name) {
  const std::string text = textOf(state, name);
  const auto number = integerFromText(text);
  if (!number || *number < 0) fail(name, "a count", "'" + text + "'");
  return *number;
}

std::int64_t attemptsFrom(const LearnerState& state) {
  return state.values.count(kAttemptsKey) > 0 ? countFrom(state, kAttemptsKey) : 0;
}

/// The archive is what the repertoire has, and what it leaves out.
void requireArchiveOf(const StoredRepertoire& stored) {
  const LearnerState& state = stored.learner_state;
  std::set<std::int64_t> kept, entries;
  for (const Entry& entry : state.archive) {
    if (state.dropped.count(entry.id) == 0) kept.insert(entry.id);
  }
  for (const Entry& entry : stored.repertoire.entries) entries.insert(entry.id);
  if (kept == entries) return;
  fail("archive", "the repertoire's " + std::to_string(entries.size()) + " entries",
       std::to_string(kept.size()) + " (files of format version 2 and before keep none)");
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
    case LearningPhase::kTransferring:
      return "transferring";
    case LearningPhase::kDone:
      return "done";
  }
  return "unknown";
}

LearnerState toLearnerState(const Checkpoint& checkpoint) {
  LearnerState state = toLearnerState(checkpoint.evolution);
  state.values[kPhaseKey] = toString(checkpoint.phase);
  state.values[kElapsedKey] = exactText(checkpoint.elapsed_s);
  state.values[kSimulationsKey] = std::to_string(checkpoint.simulations);
  state.dropped = checkpoint.dropped;
  if (checkpoint.trial_attempts > 0) {
    state.values[kAttemptsKey] = std::to_string(checkpoint.trial_attempts);
  }
  return state;
}

Checkpoint checkpointFrom(const StoredRepertoire& stored) {
  const LearnerState& state = stored.learner_state;
  requireArchiveOf(stored);
  return {evolutionStateFrom(state),         phaseFrom(state), elapsedFrom(state),
          countFrom(state, kSimulationsKey), state.dropped,    attemptsFrom(state)};
}

}  // namespace hexapod
