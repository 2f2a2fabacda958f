#pragma once

#include <cstdint>
#include <string>

#include "geometry/pose2.h"

namespace hexapod {

/// FNV-1a over 64 bits: tells accidental damage, not tampering. Same values, same digest on every
/// machine.
class Digest {
 public:
  void add(std::int64_t value);
  void add(double value);  ///< -0 counts as 0
  void add(const std::string& value);
  void add(const Pose2& pose);

  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  void addByte(unsigned char byte);

  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace hexapod
