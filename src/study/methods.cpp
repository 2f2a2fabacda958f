#include "study/methods.h"

#include <functional>
#include <stdexcept>
#include <utility>

#include "repertoire/metrics.h"
#include "study/br_method.h"
#include "study/k_means.h"
#include "study/map_elites.h"
#include "study/targets_method.h"

namespace hexapod {
namespace {

using Maker =
    std::function<std::unique_ptr<Method>(const Task&, const StudyOptions&, const Random&)>;

std::unique_ptr<Method> makeBrEvolution(const Task& task, const StudyOptions& options,
                                        const Random& random) {
  return std::make_unique<BrMethod>(options.evolution, task.space, *task.evaluator, random,
                                    task.symmetries);
}

std::unique_ptr<Method> makeTargets(const Task& task, const StudyOptions& options,
                                    const Random& random) {
  return std::make_unique<TargetsMethod>(options.evolution, task.space, *task.evaluator, random,
                                         controlTargets(options), options.target_radius_m);
}

std::unique_ptr<Method> makeMapElites(const Task& task, const StudyOptions& options,
                                      const Random& random) {
  return std::make_unique<MapElites>(options.evolution, task.space, *task.evaluator, random,
                                     options.cell_m);
}

/// One line for every algorithm.
const std::vector<std::pair<std::string, Maker>>& makers() {
  static const std::vector<std::pair<std::string, Maker>> kMakers = {
      {"br_evolution", makeBrEvolution}, {"targets", makeTargets}, {"map_elites", makeMapElites}};
  return kMakers;
}

}  // namespace

std::vector<Target> controlTargets(const StudyOptions& options) {
  return kMeans(RegionOfInterest().grid(), static_cast<std::size_t>(options.targets),
                Random(static_cast<std::uint64_t>(options.targets_seed)));
}

std::vector<std::string> methodNames() {
  std::vector<std::string> names;
  for (const auto& [name, make] : makers()) names.push_back(name);
  return names;
}

std::unique_ptr<Method> makeMethod(const std::string& name, const Task& task,
                                   const StudyOptions& options, const Random& random) {
  std::string known;
  for (const auto& [maker_name, make] : makers()) {
    if (maker_name == name) return make(task, options, random);
    known += (known.empty() ? "" : ", ") + maker_name;
  }
  throw std::invalid_argument("There is no algorithm '" + name + "'; there are " + known + ".");
}

}  // namespace hexapod
