#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/bench_cases.h"

namespace hexapod {

/// Half of the controllers random, half of them candidates of the end of a BR-Evolution run on the
/// engine reduced; all different gaits.
std::vector<Genome> mixedControllers(const BenchCase& bench_case, std::size_t count,
                                     std::uint64_t seed, int threads);

/// How far the engine reduced ends from ODE, over whole behaviours of default options.
struct Agreement {
  std::vector<double> apart_m;    ///< end poses, unrounded, of those that walked in both, ascending
  std::vector<double> apart_rad;  ///< their headings, likewise
  std::size_t compared = 0;
  std::size_t failed = 0;             ///< in ODE
  std::vector<std::string> verdicts;  ///< a line for each controller whose verdicts differ
};

/// Called with the controllers done so far.
using AgreementProgress = std::function<void(const Agreement&)>;

/// Plays every controller from the stand in both engines. Throws as WorldPool does.
Agreement compareEngines(const BenchCase& bench_case, const std::vector<Genome>& genomes,
                         int threads, const AgreementProgress& progress);

/// A row of the table of agreements, whose heading is kAgreementHeading.
std::string describe(const std::string& name, const Agreement& agreement);

extern const char* const kAgreementHeading;

}  // namespace hexapod
