#include "repertoire/exclusion.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/text.h"

namespace hexapod {
namespace {

constexpr char kFact[] = "do_not_use";

}  // namespace

std::set<std::int64_t> excludedIds(const Repertoire& repertoire) {
  std::set<std::int64_t> ids;
  const auto found = repertoire.facts.find(kFact);
  if (found == repertoire.facts.end()) return ids;
  for (const std::string& word : separated(found->second)) {
    if (const auto id = integerFromText(word)) ids.insert(*id);
  }
  return ids;
}

void setExcluded(Repertoire& repertoire, std::int64_t entry_id, bool exclude) {
  const auto& entries = repertoire.entries;
  if (std::none_of(entries.begin(), entries.end(),
                   [&](const Entry& entry) { return entry.id == entry_id; })) {
    throw std::invalid_argument("The repertoire has no entry " + std::to_string(entry_id) +
                                "; it has " + std::to_string(entries.size()) + " entries.");
  }
  std::set<std::int64_t> ids = excludedIds(repertoire);
  if (exclude) {
    ids.insert(entry_id);
  } else {
    ids.erase(entry_id);
  }
  std::string text;
  for (const std::int64_t id : ids) text += (text.empty() ? "" : ",") + std::to_string(id);
  if (text.empty()) {
    repertoire.facts.erase(kFact);
  } else {
    repertoire.facts[kFact] = text;
  }
}

Repertoire withoutExcluded(Repertoire repertoire) {
  const std::set<std::int64_t> ids = excludedIds(repertoire);
  auto& entries = repertoire.entries;
  entries.erase(std::remove_if(entries.begin(), entries.end(),
                               [&](const Entry& entry) { return ids.count(entry.id) > 0; }),
                entries.end());
  return repertoire;
}

}  // namespace hexapod
