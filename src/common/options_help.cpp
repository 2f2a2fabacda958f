#include "common/options_help.h"

#include <algorithm>
#include <sstream>

#include "common/text.h"

namespace hexapod {
namespace {

constexpr std::size_t kColumns = 80;
const std::string kIndent = "      ";

/// The words of a text in lines; Markdown's marks of code are no use here.
std::string wrapped(std::string text, const std::string& indent) {
  text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
  std::string lines;
  for (const std::string& line : inLines(text, kColumns - indent.size())) {
    lines += indent + line + "\n";
  }
  return lines;
}

std::string wrappedParagraphs(const std::string& introduction) {
  std::istringstream lines(introduction);
  std::string text;
  std::string paragraph;
  const auto endParagraph = [&] {
    if (!paragraph.empty()) text += wrapped(paragraph, "");
    paragraph.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == ' ' || line.rfind("usage:", 0) == 0) {
      endParagraph();
      text += line + "\n";
    } else {
      paragraph += line + " ";
    }
  }
  endParagraph();
  return text;
}

}  // namespace

std::string helpOn(const std::string& introduction, const std::vector<Option>& options) {
  std::string text = wrappedParagraphs(introduction) + "\n";
  for (const Option& option : options) {
    const std::string value = option.text();
    text += "  --" + option.name;
    if (option.name != "help") {
      text += "  [" + (value.empty() ? "none" : value) + "]";
      if (option.range() != "text") text += "  " + option.range();
    }
    text += "\n" + wrapped(option.meaning, kIndent);
  }
  return text;
}

}  // namespace hexapod
