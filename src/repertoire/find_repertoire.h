#pragma once

#include <string>

namespace hexapod {

/// The absolute path of the repertoire file to use: `named`, or when that is empty the newest of
/// the files hexapod_repertoire*.db in `folder`, where learning puts them.
///
/// Throws std::invalid_argument when there is no such file; the text names those there are, the
/// newest first, or says how to make one.
std::string findRepertoire(const std::string& named, const std::string& folder);

}  // namespace hexapod
