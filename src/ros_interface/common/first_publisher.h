#pragma once

#include <functional>
#include <string>
#include <vector>

namespace hexapod {

/// Of several nodes that publish a repertoire the first whose repertoire was taken stays in use,
/// for as long as it publishes. Used by one thread.
class FirstPublisher {
 public:
  /// `publishers`: the nodes that publish at present.
  explicit FirstPublisher(std::function<std::vector<std::string>()> publishers);

  /// A sentence that names both when another one is in use; empty: `publisher` is listened to.
  std::string whyRefused(const std::string& publisher) const;

  /// What `publisher` sent was taken.
  void use(const std::string& publisher) { in_use_ = publisher; }

 private:
  std::function<std::vector<std::string>()> publishers_;
  std::string in_use_;
};

}  // namespace hexapod
