#include "repertoire/digest.h"

#include <cstring>

namespace hexapod {

void Digest::add(std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  for (int shift = 0; shift < 64; shift += 8) addByte(static_cast<unsigned char>(bits >> shift));
}

void Digest::add(double value) {
  const double unsigned_zero = value == 0.0 ? 0.0 : value;
  std::int64_t bits = 0;
  std::memcpy(&bits, &unsigned_zero, sizeof bits);
  add(bits);
}

void Digest::add(const std::string& value) {
  // The length keeps two neighbouring texts apart.
  add(static_cast<std::int64_t>(value.size()));
  for (const char character : value) addByte(static_cast<unsigned char>(character));
}

void Digest::add(const Pose2& pose) {
  for (const double value : {pose.x_m, pose.y_m, pose.yaw_rad}) add(value);
}

std::string Digest::text() const {
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[(hash_ >> shift) & 15];
  return digits;
}

void Digest::addByte(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3; }

}  // namespace hexapod
