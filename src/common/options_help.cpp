#include "common/options_help.h"

#include <algorithm>
#include <sstream>

namespace hexapod {
namespace {

constexpr std::size_t kColumns = 80;
const std::string kIndent = "      ";

/// The words of a text in lines; Markdown's marks of code are no use here.
std::string wrapped(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
  std::istringstream words(text);
  std::string lines;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && kIndent.size() + line.size() + 1 + word.size() > kColumns) {
      lines += kIndent + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return lines + kIndent + line + "\n";
}

}  // namespace

std::string helpOn(const std::vector<Option>& options) {
  std::string text;
  for (const Option& option : options) {
    const std::string value = option.text();
    text += "  --" + option.name;
    if (option.name != "help") {
      text += "  [" + (value.empty() ? "none" : value) + "]";
      if (option.range() != "text") text += "  " + option.range();
    }
    text += "\n" + wrapped(option.meaning);
  }
  return text;
}

}  // namespace hexapod
