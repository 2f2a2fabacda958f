#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace hexapod {

/// Array of a size fixed at its making, all bytes zero. Of a large one that is never touched in
/// most places, only the pages that were take memory and time.
template <typename T>
class ZeroedArray {
 public:
  static_assert(std::is_trivial<T>::value, "is made of zero bytes, and freed as such");

  /// Throws std::bad_alloc.
  explicit ZeroedArray(std::size_t size = 0)
      : values_(static_cast<T*>(std::calloc(size > 0 ? size : 1, sizeof(T)))) {
    if (!values_) throw std::bad_alloc();
  }

  T& operator[](std::size_t at) { return values_.get()[at]; }
  const T& operator[](std::size_t at) const { return values_.get()[at]; }

 private:
  struct Free {
    void operator()(T* values) const { std::free(values); }
  };
  std::unique_ptr<T, Free> values_;
};

}  // namespace hexapod
