// To be preloaded into a node: its wall clock is set at any moment by writing an offset [ns, int64]
// into the file that SETTABLE_CLOCK names. As on a machine whose clock is set, waits until a wall
// time end earlier or later then; steady time goes on.
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>

namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kSlice_ns = 10'000'000;
// Deadlines below are of the steady clock, which counts from the start of the machine.
constexpr std::int64_t kFirstWallTime_s = 1'000'000'000;

const volatile std::int64_t* mapOffset() {
  const char* path = std::getenv("SETTABLE_CLOCK");
  const int file = path ? open(path, O_RDONLY | O_CLOEXEC) : -1;
  if (file < 0) std::abort();
  void* memory = mmap(nullptr, sizeof(std::int64_t), PROT_READ, MAP_SHARED, file, 0);
  if (memory == MAP_FAILED) std::abort();
  close(file);
  return static_cast<const volatile std::int64_t*>(memory);
}

std::int64_t offset_ns() {
  static const volatile std::int64_t* const offset = mapOffset();
  return *offset;
}

std::int64_t kernelNow_ns(clockid_t clock) {
  timespec now{};
  syscall(SYS_clock_gettime, clock, &now);
  return now.tv_sec * kSecond_ns + now.tv_nsec;
}

std::int64_t wallNow_ns() { return kernelNow_ns(CLOCK_REALTIME) + offset_ns(); }

timespec toTimespec(std::int64_t ns) {
  timespec time{};
  time.tv_sec = static_cast<time_t>(ns / kSecond_ns);
  time.tv_nsec = static_cast<long>(ns % kSecond_ns);
  return time;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  *now = toTimespec(clock == CLOCK_REALTIME ? wallNow_ns() : kernelNow_ns(clock));
  return 0;
}

int gettimeofday(timeval* now, void*) noexcept {
  const std::int64_t ns = wallNow_ns();
  now->tv_sec = static_cast<time_t>(ns / kSecond_ns);
  now->tv_usec = static_cast<suseconds_t>(ns % kSecond_ns / 1000);
  return 0;
}

time_t time(time_t* now) noexcept {
  const time_t seconds = static_cast<time_t>(wallNow_ns() / kSecond_ns);
  if (now != nullptr) *now = seconds;
  return seconds;
}

// A steady deadline is waited for as it is, a wall time in slices of steady time.
int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                           const timespec* deadline) {
  if (deadline->tv_sec < kFirstWallTime_s) {
    return pthread_cond_clockwait(condition, mutex, CLOCK_MONOTONIC, deadline);
  }
  const std::int64_t deadline_ns = deadline->tv_sec * kSecond_ns + deadline->tv_nsec;
  while (wallNow_ns() < deadline_ns) {
    const timespec slice = toTimespec(kernelNow_ns(CLOCK_MONOTONIC) + kSlice_ns);
    const int result = pthread_cond_clockwait(condition, mutex, CLOCK_MONOTONIC, &slice);
    if (result != ETIMEDOUT) return result;
  }
  return ETIMEDOUT;
}

}  // extern "C"
