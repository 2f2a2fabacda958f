#include "repertoire/import_repertoire.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "common/text.h"
#include "geometry/pose2.h"
#include "repertoire/repertoire_file.h"

namespace hexapod {
namespace {

[[noreturn]] void refuse(const std::string& name, std::size_t line, const std::string& expected,
                         const std::string& found) {
  throw std::runtime_error(name + ", line " + std::to_string(line) + ": expected " + expected +
                           ", found '" + found + "'.");
}

std::string bare(const std::string& text) {
  const char* blanks = " \t\r\n\"";
  const auto from = text.find_first_not_of(blanks);
  if (from == std::string::npos) return "";
  return text.substr(from, text.find_last_not_of(blanks) - from + 1);
}

/// A finite number; nothing when the text is anything else.
std::optional<double> numberOf(const std::string& text) {
  const std::optional<double> number = doubleFromText(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::vector<std::string> fieldsOf(const std::string& line, char separator) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, separator);) fields.push_back(bare(field));
  return fields;
}

std::vector<double> numbersOf(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& field : fieldsOf(text, ' ')) {
    if (field.empty()) continue;
    const auto number = numberOf(field);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

void add(const Pose2& end, Repertoire& repertoire) {
  Entry entry;
  entry.id = static_cast<std::int64_t>(repertoire.entries.size()) + 1;
  entry.end_pose = {end.x_m, end.y_m, wrapAngle(end.yaw_rad)};
  entry.evaluation = entry.id;
  repertoire.entries.push_back(entry);
}

Repertoire emptyFrom(const std::string& name) {
  Repertoire repertoire;
  repertoire.robot_id = kImported;
  repertoire.run_id = "imported " + name.substr(name.find_last_of('/') + 1);
  repertoire.facts["imported_from"] = name;
  return repertoire;
}

Repertoire finished(Repertoire repertoire, const std::string& name) {
  const std::size_t count = repertoire.entries.size();
  if (count == 0) throw std::runtime_error(name + " holds no entries.");
  if (count > static_cast<std::size_t>(kMaxEntries)) {
    throw std::runtime_error(name + " holds " + std::to_string(count) + " entries, more than " +
                             std::to_string(kMaxEntries) + ".");
  }
  repertoire.evaluations = static_cast<std::int64_t>(count);
  return repertoire;
}

/// Where the three columns stand; the first three unless the fields name them.
std::optional<std::vector<std::size_t>> namedColumns(const std::vector<std::string>& fields) {
  std::vector<std::size_t> columns;
  for (const char* wanted : {"dx", "dy", "dyaw"}) {
    const auto found = std::find(fields.begin(), fields.end(), wanted);
    if (found == fields.end()) return std::nullopt;
    columns.push_back(static_cast<std::size_t>(found - fields.begin()));
  }
  return columns;
}

bool isHeader(const std::vector<std::string>& fields) {
  return std::any_of(fields.begin(), fields.end(), [](const std::string& field) {
    return !field.empty() && (std::isalpha(static_cast<unsigned char>(field[0])) != 0) &&
           !numberOf(field);
  });
}

Pose2 poseIn(const std::vector<std::string>& fields, const std::vector<std::size_t>& columns,
             const std::string& name, std::size_t line) {
  double values[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string field = columns[i] < fields.size() ? fields[columns[i]] : "";
    const auto number = numberOf(field);
    if (!number) {
      refuse(name, line, "a finite number in column " + std::to_string(columns[i] + 1), field);
    }
    values[i] = *number;
  }
  return {values[0], values[1], values[2]};
}

/// One primitive while its lines are read.
struct Primitive {
  std::optional<double> start_angle;
  std::optional<Pose2> end;
};

}  // namespace

const char* const kImported = "imported";

bool isImported(const Repertoire& repertoire) { return repertoire.robot_id == kImported; }

std::vector<Option> declareOptions(ImportOptions& options) {
  return {
      option("length_unit", options.length_unit, "Unit of lengths in a CSV file.",
             {"m", "cm", "mm"}),
      option("angle_unit", options.angle_unit, "Unit of angles in a CSV file.", {"rad", "deg"})};
}

Repertoire importCsv(std::istream& text, const std::string& name, const ImportOptions& options) {
  const std::map<std::string, double> metres = {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}};
  const double unit_m = metres.at(options.length_unit);
  const double unit_rad = options.angle_unit == "deg" ? kDegree : 1.0;
  Repertoire repertoire = emptyFrom(name);
  std::vector<std::size_t> columns = {0, 1, 2};
  std::size_t number = 0;
  bool first = true;
  for (std::string line; std::getline(text, line);) {
    ++number;
    const std::vector<std::string> fields = fieldsOf(line, ',');
    if (bare(line).empty() || bare(line)[0] == '#') continue;
    if (first && isHeader(fields)) {
      const auto named = namedColumns(fields);
      if (!named) refuse(name, number, "the columns dx, dy and dyaw", bare(line));
      columns = *named;
    } else {
      const Pose2 end = poseIn(fields, columns, name, number);
      add({unit_m * end.x_m, unit_m * end.y_m, unit_rad * end.yaw_rad}, repertoire);
    }
    first = false;
  }
  return finished(std::move(repertoire), name);
}

Repertoire importPrimitives(std::istream& text, const std::string& name) {
  Repertoire repertoire = emptyFrom(name);
  Primitive primitive;
  std::size_t poses_left = 0;
  std::size_t number = 0;
  const auto finish = [&] {
    if (primitive.end && primitive.start_angle == 0.0) add(*primitive.end, repertoire);
    primitive = {};
  };
  for (std::string line; std::getline(text, line);) {
    ++number;
    const std::string content = bare(line);
    if (content.empty()) continue;
    const auto colon = content.find(':');
    const std::vector<double> values =
        numbersOf(colon == std::string::npos ? content : content.substr(colon + 1));
    const std::string key = colon == std::string::npos ? "" : bare(content.substr(0, colon));
    if (poses_left > 0) {
      if (!key.empty() || values.size() != 3) refuse(name, number, "an intermediate pose", content);
      primitive.end = Pose2{values[0], values[1], values[2]};
      --poses_left;
    } else if (key == "primID") {
      finish();
    } else if (key == "startangle_c" && values.size() == 1) {
      primitive.start_angle = values[0];
    } else if (key == "intermediateposes" && values.size() == 1 && values[0] >= 1.0 &&
               values[0] <= 1e6) {
      if (!primitive.start_angle) refuse(name, number, "startangle_c before the poses", content);
      poses_left = static_cast<std::size_t>(values[0]);
    } else if (key != "resolution_m" && key != "numberofangles" &&
               key != "totalnumberofprimitives" && key != "endpose_c" &&
               key != "additionalactioncostmult") {
      refuse(name, number, "a key of an SBPL .mprim file with its value", content);
    }
  }
  if (poses_left > 0) refuse(name, number, "more intermediate poses", "the end of the file");
  finish();
  return finished(std::move(repertoire), name);
}

Repertoire importRepertoire(const std::string& file, const ImportOptions& options) {
  const auto endsWith = [&file](const std::string& end) {
    return file.size() >= end.size() &&
           file.compare(file.size() - end.size(), end.size(), end) == 0;
  };
  if (!endsWith(".csv") && !endsWith(".mprim")) {
    throw std::runtime_error("Expected a file .csv or .mprim to import, found '" + file + "'.");
  }
  std::ifstream text(file);
  if (!text) throw std::runtime_error("The file " + file + " cannot be read.");
  return endsWith(".csv") ? importCsv(text, file, options) : importPrimitives(text, file);
}

}  // namespace hexapod
