// Any bytes as a repertoire file. What the digests would refuse is read as well in this build.
#include "repertoire/repertoire_file.h"

#include <unistd.h>

#include <stdexcept>

#include "fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string file = "/dev/shm/fuzz_repertoire_" + std::to_string(::getpid());
  std::ofstream(file, std::ios::binary) << hexapod::textOf(data, size);
  try {
    hexapod::loadStoredRepertoire(file);
  } catch (const std::runtime_error&) {
    // The sentence that it is there for.
  }
  ::unlink(file.c_str());
  return 0;
}
