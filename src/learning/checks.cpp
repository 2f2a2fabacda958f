#include "learning/checks.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "common/random.h"
#include "common/text.h"
#include "evaluation/assessment.h"
#include "evaluation/validation.h"
#include "evaluation/verify.h"

namespace hexapod {
namespace {

// Other generators get the seed as it is.
constexpr std::uint64_t kSampling = 0x73616d706c65;

// One behaviour in ODE takes about as long as so many in batches of the fast engine.
constexpr double kCostInOde = 100.0;
// One of the other worlds has a step a third as long.
constexpr double kCostOfSmallSteps = 2.0;

struct Differences {
  double m = 0.0;
  double rad = 0.0;
};

std::vector<Genome> genomesOf(const std::vector<Entry>& entries) {
  std::vector<Genome> genomes;
  for (const Entry& entry : entries) genomes.push_back(entry.genome);
  return genomes;
}

bool isVerified(const LearningRun& run) {
  return run.options().verify_with_ode && run.engine().engine != Engine::kOde;
}

std::size_t sampleSize(const LearningRun& run) {
  const auto wanted = static_cast<std::size_t>(run.options().verification_sample);
  const std::size_t all = run.learned().size();
  return wanted == 0 ? all : std::min(wanted, all);
}

double costOfVerification(const LearningRun& run) {
  return kCostInOde * static_cast<double>(sampleSize(run));
}

/// The entries with those that the sample is drawn of first, all where the sample is to be all.
std::vector<Entry> sampledFirst(const LearningRun& run, std::size_t sample) {
  std::vector<Entry> entries = run.learned();
  Random random(static_cast<std::uint64_t>(run.options().seed) ^ kSampling);
  for (std::size_t k = 0; k < sample; ++k) {
    std::swap(entries[k], entries[k + random.below(entries.size() - k)]);
  }
  return entries;
}

/// Replays entries in ODE and adds what it says to the findings; false when some do not hold.
bool replay(const LearningRun& run, const std::vector<Entry>& entries, const PlayHooks& hooks,
            Findings& findings, Differences& largest) {
  const Verification found =
      verifyInOde(run.worlds(), run.options().behavior, genomesOf(entries), hooks);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!found.holds[i]) findings.dropped.insert(entries[i].id);
  }
  largest.m = std::max(largest.m, found.largest_difference_m);
  largest.rad = std::max(largest.rad, found.largest_difference_rad);
  return findings.dropped.empty();
}

Findings verifyEntries(const LearningRun& run, const PlayHooks& hooks) {
  const std::size_t all = run.learned().size();
  const std::size_t sample = sampleSize(run);
  const std::vector<Entry> entries = sampledFirst(run, sample);
  const auto rest = entries.begin() + static_cast<std::ptrdiff_t>(sample);
  Findings findings;
  Differences largest;
  std::size_t replayed = sample;
  if (!replay(run, {entries.begin(), rest}, hooks, findings, largest) && sample < all) {
    replay(run, {rest, entries.end()}, hooks, findings, largest);
    replayed = all;
  }
  findings.facts["verified_entries"] = std::to_string(replayed - findings.dropped.size());
  findings.facts["dropped_entries"] = std::to_string(findings.dropped.size());
  findings.facts["largest_difference_m"] = exactText(largest.m);
  findings.facts["largest_difference_rad"] = exactText(largest.rad);
  return findings;
}

bool isValidated(const LearningRun& run) { return run.options().validation_trials > 0; }

std::size_t heldEntries(const LearningRun& run) { return run.learned().size() - run.dropped(); }

double costOfValidation(const LearningRun& run) {
  return static_cast<double>(heldEntries(run)) *
         static_cast<double>(run.options().validation_trials);
}

Findings validateEntries(const LearningRun& run, const PlayHooks& hooks) {
  const std::vector<Entry> entries = run.entries();
  ValidationOptions options;
  options.trials = run.options().validation_trials;
  options.start_states = std::max(options.start_states, options.trials);
  options.seed = static_cast<std::uint64_t>(run.options().seed);
  const std::vector<Execution> executions =
      validate(run.worlds(), run.options().behavior, genomesOf(entries), options, hooks);
  Findings findings;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    findings.executions[entries[i].id] = executions[i];
  }
  return findings;
}

bool isTriedElsewhere(const LearningRun& run) { return run.options().resimulate; }

double costOfOtherWorlds(const LearningRun& run) {
  const std::size_t trials = heldOutTrials(run.robot(), run.worlds()->physics()).size();
  return static_cast<double>(heldEntries(run)) * (static_cast<double>(trials) + kCostOfSmallSteps);
}

}  // namespace

Findings tryOtherWorlds(const LearningRun& run, const PlayHooks& hooks) {
  const std::vector<TrialResult> results =
      resimulate(run.worlds(), run.options().behavior, run.entries(),
                 heldOutTrials(run.robot(), run.worlds()->physics()), hooks);
  Findings findings;
  findings.facts = factsOf(results);
  findings.held_out = heldOutMedians(results);
  return findings;
}

bool isTransferred(const LearningRun& run) { return !run.trials().empty(); }

double costOfTransfer(const LearningRun&) { return 0.0; }

/// Where entries are expected on the robot that some were tried on.
Findings transferEntries(const LearningRun& run, const PlayHooks&) {
  Findings findings;
  for (const Entry& entry : run.entries()) {
    if (!entry.execution) continue;
    findings.executions[entry.id] = run.disparities()->onRobot(entry);
  }
  return findings;
}

const std::vector<Check>& checks() {
  static const std::vector<Check> all = {
      {LearningPhase::kVerifying, isVerified, costOfVerification, verifyEntries},
      {LearningPhase::kValidating, isValidated, costOfValidation, validateEntries},
      {LearningPhase::kTryingWorlds, isTriedElsewhere, costOfOtherWorlds, tryOtherWorlds},
      {LearningPhase::kTransferring, isTransferred, costOfTransfer, transferEntries},
  };
  return all;
}

}  // namespace hexapod
