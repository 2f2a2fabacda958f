#include "study/run_files.h"

#include <fstream>
#include <stdexcept>

#include "common/text.h"
#include "evolution/k_means.h"
#include "repertoire/metrics.h"
#include "study/methods.h"

namespace hexapod {
namespace {

/// Facts are single lines of text; only what follows the first comma is quoted, if it has to be.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

std::string unquoted(const std::string& cell) {
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
  std::string text;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    if (cell[i] == '"') ++i;
    text += cell[i];
  }
  return text;
}

void close(std::ofstream& out, const std::string& file) {
  out.close();
  if (!out) throw std::runtime_error("The file " + file + " cannot be written: is the disk full?");
}

}  // namespace

RunFacts factsOf(StudyOptions options) {
  RunFacts facts;
  for (const Option& option : declareOptions(options)) {
    facts["option." + option.name] = option.text();
  }
  return facts;
}

void writeRunFacts(const std::string& file, const RunFacts& facts) {
  std::ofstream out(file);
  out << "key,value\n";
  for (const auto& [key, value] : facts) out << key << ',' << quoted(value) << '\n';
  close(out, file);
}

RunFacts readRunFacts(const std::string& file) {
  std::ifstream in(file);
  RunFacts facts;
  std::string line;
  std::getline(in, line);
  if (!in || line != "key,value") {
    throw std::runtime_error("The file " + file + " begins with '" + line +
                             "': expected 'key,value', as a run of the "
                             "study writes it. Remove its folder to do the run again.");
  }
  while (std::getline(in, line)) {
    const std::size_t comma = line.find(',');
    if (comma != std::string::npos) facts[line.substr(0, comma)] = unquoted(line.substr(comma + 1));
  }
  return facts;
}

void writeTargets(const std::string& file, const std::vector<Target>& targets) {
  std::ofstream out(file);
  out << "x_m,y_m\n";
  for (const Target& target : targets) {
    out << exactText(target.x_m) << ',' << exactText(target.y_m) << '\n';
  }
  close(out, file);
}

void writeTheoreticalSparseness(const std::string& file, const StudyOptions& options) {
  const std::vector<Pose2> grid = RegionOfInterest().grid();
  std::ofstream out(file);
  out << "targets,sparseness_m\n";
  for (std::int64_t count = 50; count <= 400; count += 50) {
    StudyOptions other = options;
    other.targets = count;
    out << std::to_string(count) << ',' << exactText(sparsenessOf(grid, controlTargets(other)))
        << '\n';
  }
  close(out, file);
}

}  // namespace hexapod
