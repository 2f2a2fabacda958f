#pragma once

#include <set>
#include <string>
#include <vector>

namespace hexapod {

/// The words that a link's or joint's name is made of, in small letters, digits left out:
/// "LFThigh_joint" -> joint, lf, thigh; "frontLeft2" -> front, left.
std::set<std::string> wordsOf(const std::string& name);

/// Whether one of the words is among `of`.
bool hasAny(const std::set<std::string>& words, const std::vector<std::string>& of);

}  // namespace hexapod
