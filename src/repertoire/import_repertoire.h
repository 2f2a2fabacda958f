#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "common/options.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// In which units foreign numbers are.
struct ImportOptions {
  std::string length_unit = "m";   ///< m, cm or mm
  std::string angle_unit = "rad";  ///< rad or deg
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(ImportOptions& options);

/// Entries from somewhere else: end poses without genomes. They can be planned with and shown, but
/// not executed; `robot_id` is kImported, which no robot has. Throw std::runtime_error with a
/// sentence naming `name`, the line, what was expected and what was found.

/// Comma separated values, a line per entry: displacement forward and to the left and turn to the
/// left. Columns dx, dy and dyaw of a header line in any order, or the first three without one.
Repertoire importCsv(std::istream& text, const std::string& name, const ImportOptions& options);

/// Motion primitives of SBPL (.mprim, always metres and radians): those of start angle 0, which is
/// along x, with the last of their intermediate poses for end.
Repertoire importPrimitives(std::istream& text, const std::string& name);

/// One of both by the end of the file's name: .csv or .mprim. Throws std::runtime_error also when
/// the file cannot be read.
Repertoire importRepertoire(const std::string& file, const ImportOptions& options);

/// Robot of imported repertoires.
extern const char* const kImported;

/// True of a repertoire whose entries have no genomes, so that no robot can play them.
bool isImported(const Repertoire& repertoire);

}  // namespace hexapod
