#include "repertoire/number_text.h"

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

std::string toText(double number) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(std::numeric_limits<double>::max_digits10);
  stream << number;
  return stream.str();
}

std::optional<double> doubleFromText(const std::string& text) {
  if (text == "inf") return std::numeric_limits<double>::infinity();
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

}  // namespace hexapod
