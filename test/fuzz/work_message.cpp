// Any bytes as a message between processes that learn together.
#include "learning/work_message.h"

#include <stdexcept>

#include "fuzz/input.h"

namespace {

template <typename Read>
void expectSentence(const Read& read, const std::string& message) {
  try {
    read(message);
  } catch (const std::runtime_error&) {
    // The sentence that it is there for.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string message = hexapod::textOf(data, size);
  expectSentence(hexapod::introductionFrom, message);
  expectSentence(hexapod::questionsFrom, message);
  expectSentence(hexapod::resultFrom, message);
  return 0;
}
