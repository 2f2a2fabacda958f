#include "study/methods.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "common/text.h"
#include "evolution/algorithms.h"
#include "evolution/k_means.h"
#include "evolution/targets.h"
#include "repertoire/metrics.h"

namespace hexapod {
namespace {

constexpr const char* kTargets = "targets";

Method makeTargets(const Task& task, const StudyOptions& options, const Random& random) {
  auto targets = std::make_unique<Targets>(options.evolution, task.space, random,
                                           controlTargets(options), options.target_radius_m);
  const Targets* found = targets.get();
  return {std::move(targets), [found] {
            return std::map<std::string, std::vector<Entry>>{{"nearest", found->nearest()},
                                                             {"orientation", found->bestAligned()}};
          }};
}

}  // namespace

std::vector<Target> controlTargets(const StudyOptions& options) {
  return kMeans(RegionOfInterest().grid(), static_cast<std::size_t>(options.targets),
                Random(static_cast<std::uint64_t>(options.targets_seed)));
}

std::vector<std::string> methodNames() {
  std::vector<std::string> names = algorithmNames();
  names.insert(names.begin() + 1, kTargets);
  return names;
}

Method makeMethod(const std::string& name, const Task& task, const StudyOptions& options,
                  const Random& random) {
  const std::vector<std::string> names = methodNames();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw std::invalid_argument("There is no algorithm '" + name + "'; there are " + listed(names) +
                                ".");
  }
  if (name == kTargets) return makeTargets(task, options, random);
  std::unique_ptr<Algorithm> algorithm =
      makeAlgorithm({name, options.evolution, options.map_elites}, task, random);
  const Algorithm* found = algorithm.get();
  return {std::move(algorithm), [found, name] {
            return std::map<std::string, std::vector<Entry>>{{name, found->entries()}};
          }};
}

}  // namespace hexapod
