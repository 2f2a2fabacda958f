/* To be preloaded: lets calls on files whose name has FAIL_NAME in it fail as FAIL_CALL, FAIL_FIRST,
   FAIL_COUNT and FAIL_ERROR say; error 0 kills the process instead. The file FAIL_MARK is made when
   one does. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

static int is_ours(const char *path) {
  const char *name = getenv("FAIL_NAME");
  return path != NULL && name != NULL && strstr(path, name) != NULL;
}

static int descriptor_is_ours(int descriptor) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = '\0';
  return is_ours(path);
}

/* True when this call, one on our files, has to fail; errno is set then. */
static int fails(const char *call) {
  static long calls = 0;
  const char *wanted = getenv("FAIL_CALL");
  if (wanted == NULL || strcmp(wanted, call) != 0) return 0;
  const long number = __sync_fetch_and_add(&calls, 1);
  const long first = atol(getenv("FAIL_FIRST"));
  if (number < first || number >= first + atol(getenv("FAIL_COUNT"))) return 0;
  const char *mark = getenv("FAIL_MARK");
  if (mark != NULL) syscall(SYS_close, syscall(SYS_openat, AT_FDCWD, mark, O_CREAT | O_WRONLY, 0600));
  const int error = atoi(getenv("FAIL_ERROR"));
  if (error == 0) raise(SIGKILL);
  errno = error;
  return 1;
}

#define REAL(type, name, ...)                                       \
  static type (*real)(__VA_ARGS__) = NULL;                          \
  if (real == NULL) real = (type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, name)

ssize_t pwrite64(int descriptor, const void *data, size_t size, off64_t at) {
  REAL(ssize_t, "pwrite64", int, const void *, size_t, off64_t);
  if (descriptor_is_ours(descriptor) && fails("pwrite64")) return -1;
  return real(descriptor, data, size, at);
}

int fdatasync(int descriptor) {
  REAL(int, "fdatasync", int);
  if (descriptor_is_ours(descriptor) && fails("fdatasync")) return -1;
  return real(descriptor);
}

ssize_t pread64(int descriptor, void *data, size_t size, off64_t at) {
  REAL(ssize_t, "pread64", int, void *, size_t, off64_t);
  if (descriptor_is_ours(descriptor) && fails("pread64")) return -1;
  return real(descriptor, data, size, at);
}

int unlink(const char *path) {
  REAL(int, "unlink", const char *);
  if (is_ours(path) && fails("unlink")) return -1;
  return real(path);
}

static int open_any(const char *name, const char *path, int flags, mode_t mode) {
  REAL(int, name, const char *, int, mode_t);
  if (is_ours(path) && fails("open")) return -1;
  return real(path, flags, mode);
}

static mode_t mode_of(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

int open(const char *path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_any("open", path, flags, mode);
}

int open64(const char *path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_any("open64", path, flags, mode);
}
