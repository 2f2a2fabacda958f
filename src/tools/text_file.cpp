#include "tools/text_file.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace hexapod {

std::string textOfFile(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(file + " cannot be read; check the path.");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void writeTextFile(const std::string& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error(file + " cannot be written; check the path.");
}

}  // namespace hexapod
