#include "common/text.h"

#include <limits>
#include <locale>
#include <sstream>

namespace hexapod {
namespace {

template <typename Number>
std::optional<Number> numberFromText(const std::string& text) {
  // operator>> would skip leading spaces.
  if (text.empty() || text.front() <= ' ') return std::nullopt;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  Number number{};
  stream >> number;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return number;
}

}  // namespace

std::string numberText(double number, int digits) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(digits);
  stream << number;
  return stream.str();
}

std::string fixedText(double number, int decimals) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(decimals);
  stream << std::fixed << number;
  return stream.str();
}

std::string exactText(double number) {
  // All that 15 digits hold reads back from them, and trailing zeros are not written.
  for (const int digits : {15, 16}) {
    std::string text = numberText(number, digits);
    if (doubleFromText(text) == number) return text;
  }
  return numberText(number, std::numeric_limits<double>::max_digits10);
}

std::optional<double> doubleFromText(const std::string& text) {
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  return numberFromText<double>(text);
}

std::optional<std::int64_t> integerFromText(const std::string& text) {
  return numberFromText<std::int64_t>(text);
}

std::optional<std::uint64_t> unsignedFromText(const std::string& text) {
  // operator>> would wrap a negative number around.
  if (text.find('-') != std::string::npos) return std::nullopt;
  return numberFromText<std::uint64_t>(text);
}

std::string trimmed(const std::string& text) {
  constexpr char kWhiteSpace[] = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kWhiteSpace);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(kWhiteSpace) - first + 1);
}

std::vector<std::string> separated(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) {
    word = trimmed(word);
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

std::string tableRow(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + cell + " |";
  return row + "\n";
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<std::string> inLines(const std::string& text, std::size_t columns) {
  std::istringstream words(text);
  std::vector<std::string> lines(1);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > columns) {
      lines.emplace_back();
    }
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

}  // namespace hexapod
