// Prints the entries of a repertoire file as comma separated values.
#include "repertoire/repertoire_csv.h"

#include <exception>
#include <iostream>

#include "repertoire/repertoire_file.h"

int main(int argc, char** argv) {
  if (argc != 2 || argv[1][0] == '-') {
    std::cerr << "usage: repertoire_csv FILE.db > FILE.csv\n";
    return 2;
  }
  try {
    hexapod::exportCsv(hexapod::loadRepertoire(argv[1]), std::cout);
    std::cout.flush();
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  if (std::cout) return 0;
  std::cerr << "The output cannot be written.\n";
  return 1;
}
