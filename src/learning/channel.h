#pragma once

#include <atomic>
#include <optional>
#include <string>

namespace hexapod {

/// A line to another process that works for this one, or for which this one works. Messages arrive
/// whole and in order. Used by one thread.
class Channel {
 public:
  virtual ~Channel() = default;

  virtual void send(const std::string& message) = 0;

  /// Waits for the next message. Nothing when the other side did not answer within `patience_s` (0:
  /// no limit), or `cancelled` is true and it still did not soon after: it is taken for lost then,
  /// and the channel is of no use any more.
  virtual std::optional<std::string> receive(const std::atomic<bool>& cancelled,
                                             double patience_s) = 0;
};

}  // namespace hexapod
