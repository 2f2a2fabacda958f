#include "robot_import/name_words.h"

#include <algorithm>
#include <cctype>

namespace hexapod {

std::set<std::string> wordsOf(const std::string& name) {
  std::set<std::string> words;
  std::string word;
  const auto end = [&] {
    if (!word.empty()) words.insert(word);
    word.clear();
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const auto next = static_cast<unsigned char>(i + 1 < name.size() ? name[i + 1] : 0);
    if (std::isalpha(c) == 0) {
      end();
      continue;
    }
    if (std::isupper(c) != 0 && (std::islower(next) != 0) && word.size() != 1) end();
    word += static_cast<char>(std::tolower(c));
    if (std::islower(c) != 0 && std::isupper(next) != 0) end();
  }
  end();
  return words;
}

bool hasAny(const std::set<std::string>& words, const std::vector<std::string>& of) {
  return std::any_of(of.begin(), of.end(), [&](const auto& word) { return words.count(word) > 0; });
}

}  // namespace hexapod
