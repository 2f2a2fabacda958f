#pragma once

#include <string>
#include <vector>

namespace hexapod {

/// A part of a robot that a sentence is about: "link", "foot".
struct Subject {
  std::string kind;
  std::string name;
};

/// The sentences about everything that is wrong with a robot's files, or worth a remark, so that
/// all are told at once and the same thing about many parts in one sentence.
class Problems {
 public:
  /// One sentence; `source` is the file it is about. The same sentence is kept once.
  void add(const std::string& source, const std::string& sentence);

  /// "link foot " + sentence; the other parts that the same is said of are named in its end.
  void add(const std::string& source, const Subject& subject, const std::string& sentence);

  bool none() const { return told_.empty(); }

  /// In the order in which they were first told.
  std::vector<std::string> sentences() const;

  /// Throws std::runtime_error with one sentence per line unless there are none().
  void throwIfAny() const;

 private:
  struct Told {
    std::string source;
    Subject first;  // of kind "" when the sentence is whole
    std::string sentence;
    std::vector<std::string> others;  // names of the same kind
  };

  std::vector<Told> told_;
};

/// "a, b and c"; of more than eight the first seven and how many more there are.
std::string namesText(const std::vector<std::string>& names);

}  // namespace hexapod
