#include "robot/check_source.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace hexapod {
namespace {

constexpr std::uintmax_t kMaxBytes = 4 << 20;
constexpr int kMaxDepth = 64;

// End of the markup that starts at `start`, one past its last character.
std::size_t markupEnd(const std::string& text, std::size_t start) {
  for (const auto& [open, close] : {std::pair("<!--", "-->"), std::pair("<![CDATA[", "]]>")}) {
    if (text.compare(start, std::strlen(open), open) != 0) continue;
    const std::size_t end = text.find(close, start);
    return end == std::string::npos ? text.size() : end + 3;
  }
  char quote = 0;
  for (std::size_t i = start; i < text.size(); ++i) {
    if (quote != 0) {
      if (text[i] == quote) quote = 0;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == '>') {
      return i + 1;
    }
  }
  return text.size();
}

// Greatest number of elements open at once, counted without parsing.
int xmlDepth(const std::string& text) {
  int depth = 0;
  int deepest = 0;
  std::size_t start = text.find('<');
  while (start != std::string::npos && start + 1 < text.size()) {
    const std::size_t end = markupEnd(text, start);
    const char first = text[start + 1];
    if (first == '/') {
      --depth;
    } else if (first != '!' && first != '?' && text[end - 2] != '/') {
      deepest = std::max(deepest, ++depth);
    }
    start = text.find('<', end);
  }
  return deepest;
}

// Greatest number of flow lists and mappings open at once; brackets in comments count too.
int yamlDepth(const std::string& text) {
  int depth = 0;
  int deepest = 0;
  for (char c : text) {
    if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
    if (c == ']' || c == '}') --depth;
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
  } else if ((kind == "URDF" ? xmlDepth(text) : yamlDepth(text)) > kMaxDepth) {
    problems.add(source, "nests more than " + std::to_string(kMaxDepth) + " levels; expected a " +
                             kind + " text.");
  } else {
    return true;
  }
  return false;
}

}  // namespace hexapod
