#include "robot/check_source.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace hexapod_repertoire {
namespace {

constexpr std::uintmax_t kMaxBytes = 4 << 20;
constexpr int kMaxXmlDepth = 64;

// Depth of open elements, counted without parsing; comments and declarations do not open one.
int xmlDepth(const std::string& text) {
  int depth = 0;
  int deepest = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text.compare(i, 4, "<!--") == 0) {
      const std::size_t end = text.find("-->", i);
      if (end == std::string::npos) break;
      i = end;
    } else if (text[i] == '<' && text[i + 1] == '/') {
      --depth;
    } else if (text[i] == '<' && text[i + 1] != '!' && text[i + 1] != '?') {
      deepest = std::max(deepest, ++depth);
    } else if (text[i] == '/' && text[i + 1] == '>') {
      --depth;
    }
  }
  return deepest;
}

bool isBinary(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 && c != '\n' && c != '\r' && c != '\t';
  });
}

}  // namespace

std::string readSource(const std::string& file, Problems& problems) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    problems.add(file, "there is no such file; check the path.");
    return "";
  }
  if (!std::filesystem::is_regular_file(status)) {
    problems.add(file, "expected a file, found a folder or device.");
    return "";
  }
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (!error && bytes > kMaxBytes) {
    problems.add(file, "has " + std::to_string(bytes) +
                           " bytes; expected a robot description of at most " +
                           std::to_string(kMaxBytes) + ".");
    return "";
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    problems.add(file, "cannot be read; check its permissions.");
    return "";
  }
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

bool isReadable(const std::string& text, const std::string& source, const std::string& kind,
                Problems& problems) {
  const auto isBlank = [](unsigned char c) { return std::isspace(c) != 0; };
  if (std::all_of(text.begin(), text.end(), isBlank)) {
    problems.add(source, "is empty; expected a " + kind + " text.");
  } else if (isBinary(text)) {
    problems.add(source, "holds binary data; expected a " + kind + " text.");
  } else if (kind == "URDF" && xmlDepth(text) > kMaxXmlDepth) {
    problems.add(source, "nests more than " + std::to_string(kMaxXmlDepth) +
                             " XML elements; expected a URDF text.");
  } else {
    return true;
  }
  return false;
}

}  // namespace hexapod_repertoire
