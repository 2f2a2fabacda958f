// Makes a repertoire file of somebody else's table of displacements, to plan with and to look at.
#include "repertoire/import_repertoire.h"

#include <exception>
#include <iostream>
#include <stdexcept>

#include "common/options_help.h"
#include "repertoire/repertoire_writer.h"
#include "tools/command_line.h"

namespace hexapod {
namespace {

struct Options {
  bool help = false;
  std::string from;
  std::string file;
  ImportOptions import;
};

std::vector<Option> declareOptions(Options& options) {
  std::vector<Option> all = {
      option("help", options.help, "Print this text."),
      option("from", options.from,
             "File to read: .csv with columns dx, dy, dyaw, or SBPL's .mprim, of which the "
             "primitives of start angle 0 are taken."),
      option("file", options.file, "Repertoire file to write.")};
  const std::vector<Option> import = declareOptions(options.import);
  all.insert(all.end(), import.begin(), import.end());
  return all;
}

std::string usage(Options& options) {
  return helpOn(
      "usage: import_repertoire --from FILE.csv|FILE.mprim --file FILE.db\n"
      "                         [--name value ...]\n"
      "\n"
      "  import_repertoire --from steps.csv --file steps.db --length_unit cm\n",
      declareOptions(options));
}

int import(const std::vector<std::string>& arguments) {
  Options options;
  applyOptions(declareOptions(options), valuesFromCommandLine(arguments, declareOptions(options)),
               kCommandLine);
  if (options.help) {
    std::cout << usage(options);
    return 0;
  }
  if (options.from.empty() || options.file.empty()) {
    throw std::invalid_argument("import_repertoire needs --from and --file.");
  }
  const Repertoire repertoire = importRepertoire(options.from, options.import);
  RepertoireWriter writer(options.file);
  if (writer.holdsRepertoire()) {
    throw std::runtime_error("The file " + options.file +
                             " holds a repertoire already; name another one.");
  }
  writer.save(repertoire);
  std::cout << repertoire.entries.size() << " entries from " << options.from << " are in "
            << options.file
            << ". They can be planned with and shown, but not executed: they have no genomes.\n";
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  try {
    return hexapod::import({argv + 1, argv + argc});
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\nimport_repertoire --help lists the options.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
