#pragma once

#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/comma_locale.h"
#include "common/random.h"
#include "gait/random_genome.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// A folder of its own that goes with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "repertoire_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Entries with ids 1 .. count, distinct genomes, ends within +-half_width_m; every other one
/// validated.
inline std::vector<Entry> randomEntries(std::size_t count, Random& random,
                                        double half_width_m = 0.8) {
  std::vector<Entry> entries;
  std::set<Genome> genomes;
  while (entries.size() < count) {
    Entry entry;
    entry.genome = randomGenome(random);
    if (!genomes.insert(entry.genome).second) continue;
    entry.id = static_cast<std::int64_t>(entries.size()) + 1;
    entry.end_pose = {random.uniform(-half_width_m, half_width_m),
                      random.uniform(-half_width_m, half_width_m), random.uniform(-3.0, 3.0)};
    entry.cost = random.uniform(0.0, 3.0);
    entry.evaluation = 10 * entry.id;
    if (entry.id % 2 == 0) {
      entry.execution = Execution{{random.uniform(), random.uniform(), random.uniform()},
                                  random.uniform(),
                                  random.uniform(),
                                  8,
                                  static_cast<int>(random.below(3))};
    }
    entries.push_back(entry);
  }
  return entries;
}

inline Repertoire sampleRepertoire(std::size_t entries = 40) {
  Random random(11);
  Repertoire repertoire;
  repertoire.run_id = "run-11";
  repertoire.robot_id = "0123456789abcdef";
  repertoire.seed = 0xffffffffffffffff;
  repertoire.generation = 12;
  repertoire.evaluations = 1200;
  repertoire.behavior_duration_s = 3.9;
  repertoire.joint_names = {"body_leg_0", "leg_0_1_2", "leg_0_2_3"};
  repertoire.options = {{"novelty_threshold_m", "0.1"}, {"seed", "11"}};
  repertoire.facts = {{"engine", "ode"}};
  repertoire.entries = randomEntries(entries, random);
  repertoire.history = {{100, 20, 0.05, 0.4, 0.3, 1.25, HeldOut{0.06, 0.5, 0.01}},
                        {1200, 40, 0.1 + 0.2, 1.0 / 3.0, 0.7, 9.0, std::nullopt}};
  repertoire.trials = {
      {100, randomGenome(random), {0.3, 0.1, 0.2}, 0.25, Pose2{0.2, 0.1, 1.0 / 3.0}},
      {200, randomGenome(random), {0.1 + 0.2, -0.1, 0.0}, 0.5, std::nullopt}};
  return repertoire;
}

inline std::string contentOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline void writeContent(const std::string& file, const std::string& content) {
  // Some file systems wait for the disk when a file is overwritten, not when it is new.
  std::filesystem::remove(file);
  std::ofstream(file, std::ios::binary) << content;
}

/// The sentence that a call throws, or "" when it throws none.
template <typename Call>
std::string complaintOf(Call call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace hexapod
