#include "learning/checks.h"

#include <algorithm>

#include "common/text.h"
#include "evaluation/assessment.h"
#include "evaluation/validation.h"
#include "evaluation/verify.h"

namespace hexapod {
namespace {

std::vector<Genome> genomesOf(const std::vector<Entry>& entries) {
  std::vector<Genome> genomes;
  for (const Entry& entry : entries) genomes.push_back(entry.genome);
  return genomes;
}

bool isVerified(const LearningRun& run) {
  return run.options().verify_with_ode && run.engine().engine != Engine::kOde;
}

std::optional<Findings> verifyEntries(const LearningRun& run, const CheckHooks& hooks) {
  const std::vector<Entry>& entries = run.learned();
  const Verification verification =
      verifyInOde(*run.worlds(), run.options().behavior, genomesOf(entries),
                  {hooks.progress, &hooks.cancelled});
  if (hooks.cancelled) return std::nullopt;
  Findings findings;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!verification.holds[i]) findings.dropped.insert(entries[i].id);
  }
  findings.facts["verified_entries"] = std::to_string(entries.size() - findings.dropped.size());
  findings.facts["dropped_entries"] = std::to_string(findings.dropped.size());
  findings.facts["largest_difference_m"] = exactText(verification.largest_difference_m);
  findings.facts["largest_difference_rad"] = exactText(verification.largest_difference_rad);
  return findings;
}

bool isValidated(const LearningRun& run) { return run.options().validation_trials > 0; }

std::optional<Findings> validateEntries(const LearningRun& run, const CheckHooks& hooks) {
  const std::vector<Entry> entries = run.entries();
  ValidationOptions options;
  options.trials = run.options().validation_trials;
  options.start_states = std::max(options.start_states, options.trials);
  options.seed = static_cast<std::uint64_t>(run.options().seed);
  const std::vector<Execution> executions =
      validate(*run.worlds(), run.options().behavior, genomesOf(entries), options,
               {hooks.progress, &hooks.cancelled});
  if (hooks.cancelled) return std::nullopt;
  Findings findings;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    findings.executions[entries[i].id] = executions[i];
  }
  return findings;
}

bool isTriedElsewhere(const LearningRun& run) { return run.options().resimulate; }

}  // namespace

std::optional<Findings> tryOtherWorlds(const LearningRun& run, const CheckHooks& hooks) {
  const std::vector<Entry> entries = run.entries();
  const std::vector<Trial> trials = heldOutTrials(run.robot(), run.worlds()->physics());
  std::vector<TrialResult> results;
  try {
    for (const Trial& trial : trials) {
      const auto found =
          resimulate(run.worlds(), run.options().behavior, entries, {trial}, &hooks.cancelled);
      results.push_back(found.front());
      if (hooks.progress) hooks.progress(results.size(), trials.size());
    }
  } catch (const EvaluationCancelled&) {
    return std::nullopt;
  }
  Findings findings;
  findings.facts = factsOf(results);
  findings.held_out = heldOutMedians(results);
  return findings;
}

const std::vector<Check>& checks() {
  static const std::vector<Check> all = {
      {LearningPhase::kVerifying, isVerified, verifyEntries},
      {LearningPhase::kValidating, isValidated, validateEntries},
      {LearningPhase::kTryingWorlds, isTriedElsewhere, tryOtherWorlds},
  };
  return all;
}

}  // namespace hexapod
