#pragma once

#include <string>
#include <vector>

namespace hexapod {

/// The sentences about everything that is wrong with a robot's files, so that all are told at once.
class Problems {
 public:
  /// One sentence; `source` is the file it is about. The same sentence is kept once.
  void add(const std::string& source, const std::string& sentence);

  bool none() const { return sentences_.empty(); }

  /// Throws std::runtime_error with one sentence per line unless there are none().
  void throwIfAny() const;

 private:
  std::vector<std::string> sentences_;
};

/// A number for a sentence: 6 significant digits, decimal point in every locale.
std::string numberText(double value);

}  // namespace hexapod
