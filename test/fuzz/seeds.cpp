// Writes what the fuzzers begin with into folders that exist: <folder>/<fuzzer>/seed.
#include <fstream>
#include <string>

#include "learning/work_message.h"
#include "repertoire/fixtures.h"
#include "repertoire/repertoire_writer.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  const hexapod::Repertoire repertoire = hexapod::sampleRepertoire(3);
  hexapod::LearnerState state;
  state.values = {{"phase", "done"}};
  state.population.push_back({1, 1, repertoire.entries[0].genome, hexapod::Outcome(), 0, 0.5, 1});
  state.archive = repertoire.entries;
  state.dropped = {2};
  hexapod::saveRepertoire(folder + "/repertoire_file/seed", repertoire, state);
  const auto write = [&](const std::string& name, const std::string& content) {
    std::ofstream(folder + "/" + name, std::ios::binary) << content;
  };
  write("message/seed", std::string(150, '\1'));
  write("work_message/introduction", toMessage(hexapod::Introduction{"run", 2, ""}));
  write("work_message/task", toMessage(hexapod::Questions{1, {{0, 1, 2}, {3, 4, 0}}, {}}));
  write("work_message/result", toMessage(hexapod::Result{{hexapod::Outcome()}, 1, "no"}));
  write("seeded_mistake/seed", "joints:\n  a: {name: b, sign: 1, offset_rad: 20.5}\n");
  return 0;
}
