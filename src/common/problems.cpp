#include "common/problems.h"

#include <algorithm>
#include <stdexcept>

namespace hexapod {
namespace {

constexpr std::size_t kMostNames = 8;

}  // namespace

void Problems::add(const std::string& source, const std::string& sentence) {
  add(source, Subject{}, sentence);
}

void Problems::add(const std::string& source, const Subject& subject, const std::string& sentence) {
  const auto same = std::find_if(told_.begin(), told_.end(), [&](const Told& told) {
    return told.source == source && told.first.kind == subject.kind && told.sentence == sentence;
  });
  if (same == told_.end()) {
    told_.push_back({source, subject, sentence, {}});
  } else if (subject.name != same->first.name &&
             std::count(same->others.begin(), same->others.end(), subject.name) == 0) {
    same->others.push_back(subject.name);
  }
}

std::vector<std::string> Problems::sentences() const {
  std::vector<std::string> all;
  for (const Told& told : told_) {
    std::string text = told.source + ": ";
    if (!told.first.kind.empty()) text += told.first.kind + " " + told.first.name + " ";
    text += told.sentence;
    if (!told.others.empty()) {
      text += " The same is true of " + told.first.kind + (told.others.size() > 1 ? "s " : " ") +
              namesText(told.others) + ".";
    }
    all.push_back(text);
  }
  return all;
}

void Problems::throwIfAny() const {
  if (none()) return;
  std::string all;
  for (const std::string& sentence : sentences()) all += (all.empty() ? "" : "\n") + sentence;
  throw std::runtime_error(all);
}

std::string namesText(const std::vector<std::string>& names) {
  const std::size_t shown = names.size() > kMostNames ? kMostNames - 1 : names.size();
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == names.size();
    text += (i == 0 ? "" : last ? " and " : ", ") + names[i];
  }
  if (shown < names.size()) text += " and " + std::to_string(names.size() - shown) + " more";
  return text;
}

}  // namespace hexapod
