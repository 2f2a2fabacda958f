#include "learning/warm_start.h"

#include <stdexcept>

#include "repertoire/digest.h"
#include "repertoire/repertoire_file.h"

namespace hexapod {

WarmStart warmStart(const RobotDescription& robot, const Repertoire& repertoire,
                    const std::string& source, std::size_t gene_levels) {
  const std::string nothing = "A run cannot begin with the entries of " + source + ": ";
  if (repertoire.entries.empty()) {
    throw std::invalid_argument(nothing + "it has none. Leave out 'from', or name another file.");
  }
  WarmStart start;
  Digest digest;
  for (const Entry& entry : repertoire.entries) {
    if (entry.genome.size() != robot.geneCount()) {
      throw std::invalid_argument(nothing + "they have " + std::to_string(entry.genome.size()) +
                                  " genes, and robot " + robot.name + " " +
                                  std::to_string(robot.geneCount()) +
                                  ". Name a repertoire of a robot with as many legs.");
    }
    try {
      start.genomes.push_back(withLevels(entry.genome, repertoire.geneLevels(), gene_levels));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(nothing + error.what() + " Choose other gene_levels.");
    }
    digest.add(toString(entry.genome));
  }
  start.name = std::to_string(start.genomes.size()) + " entries of " + repertoire.run_id + " (" +
               digest.text() + ")";
  return start;
}

WarmStart warmStart(const RobotDescription& robot, const std::string& file,
                    std::size_t gene_levels) {
  return warmStart(robot, loadRepertoire(file), file, gene_levels);
}

}  // namespace hexapod
