#include "robot/problems.h"

#include <algorithm>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace hexapod {

void Problems::add(const std::string& source, const std::string& sentence) {
  const std::string whole = source + ": " + sentence;
  if (std::find(sentences_.begin(), sentences_.end(), whole) == sentences_.end()) {
    sentences_.push_back(whole);
  }
}

void Problems::throwIfAny() const {
  if (none()) return;
  std::string all;
  for (const std::string& sentence : sentences_) all += (all.empty() ? "" : "\n") + sentence;
  throw std::runtime_error(all);
}

std::string numberText(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

}  // namespace hexapod
