#include "calibration/trial_file.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "common/text.h"

namespace hexapod {
namespace {

constexpr const char* kPlanNames = "use,genome";
constexpr const char* kPoseNames =
    ",before_x_m,before_y_m,before_yaw_rad,after_x_m,after_y_m,after_yaw_rad";
constexpr std::size_t kColumns = 8;

void writeLines(const std::string& heading, const std::vector<std::string>& lines,
                const std::string& file) {
  std::ofstream stream(file);
  stream << heading << "\n";
  for (const std::string& line : lines) stream << line << "\n";
  stream.close();
  if (!stream) throw std::runtime_error(file + " cannot be written; check the path.");
}

std::string planOf(const Trial& trial) {
  return (trial.is_check ? "check," : "fit,") + toString(trial.seen.genome);
}

std::string textOf(const Pose2& pose) {
  return "," + exactText(pose.x_m) + "," + exactText(pose.y_m) + "," + exactText(pose.yaw_rad);
}

std::vector<std::string> cellsOf(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

double numberIn(const std::string& cell) {
  const std::optional<double> number = doubleFromText(cell);
  if (number && std::isfinite(*number)) return *number;
  throw std::invalid_argument("expected a number, found '" + cell + "'.");
}

Pose2 poseIn(const std::vector<std::string>& cells, std::size_t first) {
  return {numberIn(cells[first]), numberIn(cells[first + 1]), numberIn(cells[first + 2])};
}

Trial trialIn(const std::vector<std::string>& cells, std::size_t gene_count) {
  if (cells.size() != kColumns) {
    throw std::invalid_argument("expected " + std::to_string(kColumns) + " values, found " +
                                std::to_string(cells.size()) + ".");
  }
  if (cells[0] != "fit" && cells[0] != "check") {
    throw std::invalid_argument("expected fit or check, found '" + cells[0] + "'.");
  }
  Trial trial;
  trial.is_check = cells[0] == "check";
  trial.seen.genome = genomeFromString(cells[1]);
  if (trial.seen.genome.size() != gene_count) {
    throw std::invalid_argument("expected a genome of " + std::to_string(gene_count) +
                                " genes, found '" + cells[1] + "'.");
  }
  trial.seen.world_from_before = poseIn(cells, 2);
  trial.seen.world_from_after = poseIn(cells, 5);
  return trial;
}

}  // namespace

void writePlan(const std::vector<Trial>& trials, const std::string& file) {
  std::vector<std::string> lines;
  for (const Trial& trial : trials) lines.push_back(planOf(trial));
  writeLines(kPlanNames, lines, file);
}

void writeTrials(const std::vector<Trial>& trials, const std::string& file) {
  std::vector<std::string> lines;
  for (const Trial& trial : trials) {
    lines.push_back(planOf(trial) + textOf(trial.seen.world_from_before) +
                    textOf(trial.seen.world_from_after));
  }
  writeLines(std::string(kPlanNames) + kPoseNames, lines, file);
}

std::vector<Trial> readTrials(const std::string& file, std::size_t gene_count) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file + " cannot be read; check the path.");
  std::vector<Trial> trials;
  std::string line;
  std::getline(stream, line);
  for (int number = 2; std::getline(stream, line); ++number) {
    if (cellsOf(line).empty()) continue;
    try {
      trials.push_back(trialIn(cellsOf(line), gene_count));
      if (trials.size() > 1 && trials[trials.size() - 2].is_check && !trials.back().is_check) {
        throw std::invalid_argument("a trial to fit comes after one to check.");
      }
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(file + ", line " + std::to_string(number) + ": " + error.what());
    }
  }
  return trials;
}

}  // namespace hexapod
