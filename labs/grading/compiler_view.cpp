// What a compiler finds of the file system where no sandbox hides files from it.
//
// This is a library of its own (LD_PRELOAD) for the compiler of a submission. It replaces the
// functions that open or look at a file: outside of the directories in GLASSBOX_COMPILER_SEES
// (separated by colons) no file exists. Otherwise __has_include would tell a submission which files
// are on the machine. The compiler's code is trusted, so that it does not get around this; the
// submission is only its input.
//
// The headers that declare the replaced functions are not included, because the types of C's files
// do not matter here.
#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

namespace {

constexpr int kWorkingDirectory = -100;  // AT_FDCWD

// The function that would be called without this library.
template <class Function>
Function* original(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool find_real_path(const char* path, char* real) {
  auto* const find = original<char*(const char*, char*)>("realpath");
  return find != nullptr && find(path, real) != nullptr;
}

bool is_inside(const char* path, const char* directory, size_t length) {
  return strncmp(path, directory, length) == 0 && (path[length] == '/' || path[length] == '\0');
}

// A directory above one that is seen is there, or the way to the other one would not be.
bool is_above(const char* path, const char* directory, size_t length) {
  const size_t own = strlen(path);
  return own < length && strncmp(path, directory, own) == 0 &&
         (directory[own] == '/' || (own == 1 && path[0] == '/'));
}

// Whether the compiler must not know whether the file exists. A file that does not exist is judged
// by its directory: a file is made in a directory that is seen.
bool is_hidden(const char* path) {
  const char* const seen = getenv("GLASSBOX_COMPILER_SEES");
  if (seen == nullptr || path == nullptr) return false;
  char real[PATH_MAX];
  if (!find_real_path(path, real)) {
    const char* const slash = strrchr(path, '/');
    const size_t length = slash == nullptr ? 0 : static_cast<size_t>(slash - path);
    if (length >= PATH_MAX) return true;
    char directory[PATH_MAX];
    memcpy(directory, path, length);
    directory[length] = '\0';
    if (!find_real_path(slash == nullptr ? "." : length == 0 ? "/" : directory, real)) return true;
  }
  for (const char* at = seen; *at != '\0';) {
    const size_t length = strcspn(at, ":");
    if (is_inside(real, at, length) || is_above(real, at, length)) return false;
    at += length + (at[length] == ':' ? 1 : 0);
  }
  return true;
}

bool is_hidden_at(int directory, const char* path) {
  const bool is_relative = path != nullptr && path[0] != '/';
  return !(is_relative && directory != kWorkingDirectory) && is_hidden(path);
}

int not_there() {
  errno = ENOENT;
  return -1;
}

}  // namespace

#define GLASSBOX_OPEN(name)                                                \
  extern "C" int name(const char* path, int flags, ...) {                  \
    if (is_hidden(path)) return not_there();                               \
    va_list more;                                                          \
    va_start(more, flags);                                                 \
    const unsigned mode = va_arg(more, unsigned);                          \
    va_end(more);                                                          \
    return original<int(const char*, int, ...)>(#name)(path, flags, mode); \
  }
#define GLASSBOX_OPEN_AT(name)                                                             \
  extern "C" int name(int directory, const char* path, int flags, ...) {                   \
    if (is_hidden_at(directory, path)) return not_there();                                 \
    va_list more;                                                                          \
    va_start(more, flags);                                                                 \
    const unsigned mode = va_arg(more, unsigned);                                          \
    va_end(more);                                                                          \
    return original<int(int, const char*, int, ...)>(#name)(directory, path, flags, mode); \
  }
#define GLASSBOX_OPEN_CHECKED(name)                             \
  extern "C" int name(const char* path, int flags) {            \
    if (is_hidden(path)) return not_there();                    \
    return original<int(const char*, int)>(#name)(path, flags); \
  }
#define GLASSBOX_FOPEN(name)                                             \
  extern "C" void* name(const char* path, const char* mode) {            \
    if (is_hidden(path)) {                                               \
      not_there();                                                       \
      return nullptr;                                                    \
    }                                                                    \
    return original<void*(const char*, const char*)>(#name)(path, mode); \
  }
#define GLASSBOX_STAT(name)                                        \
  extern "C" int name(const char* path, void* status) noexcept {   \
    if (is_hidden(path)) return not_there();                       \
    return original<int(const char*, void*)>(#name)(path, status); \
  }
#define GLASSBOX_STAT_VERSION(name)                                              \
  extern "C" int name(int version, const char* path, void* status) noexcept {    \
    if (is_hidden(path)) return not_there();                                     \
    return original<int(int, const char*, void*)>(#name)(version, path, status); \
  }
#define GLASSBOX_STAT_AT(name)                                                                 \
  extern "C" int name(int directory, const char* path, void* status, int flags) noexcept {     \
    if (is_hidden_at(directory, path)) return not_there();                                     \
    return original<int(int, const char*, void*, int)>(#name)(directory, path, status, flags); \
  }

GLASSBOX_OPEN(open)
GLASSBOX_OPEN(open64)
GLASSBOX_OPEN_AT(openat)
GLASSBOX_OPEN_AT(openat64)
GLASSBOX_OPEN_CHECKED(__open_2)
GLASSBOX_OPEN_CHECKED(__open64_2)
GLASSBOX_FOPEN(fopen)
GLASSBOX_FOPEN(fopen64)
GLASSBOX_STAT(stat)
GLASSBOX_STAT(stat64)
GLASSBOX_STAT(lstat)
GLASSBOX_STAT(lstat64)
GLASSBOX_STAT_VERSION(__xstat)
GLASSBOX_STAT_VERSION(__xstat64)
GLASSBOX_STAT_VERSION(__lxstat)
GLASSBOX_STAT_VERSION(__lxstat64)
GLASSBOX_STAT_AT(fstatat)
GLASSBOX_STAT_AT(fstatat64)

extern "C" int statx(int directory, const char* path, int flags, unsigned mask, void* status) {
  if (is_hidden_at(directory, path)) return not_there();
  return original<int(int, const char*, int, unsigned, void*)>("statx")(directory, path, flags,
                                                                        mask, status);
}

extern "C" int access(const char* path, int mode) {
  if (is_hidden(path)) return not_there();
  return original<int(const char*, int)>("access")(path, mode);
}

extern "C" int faccessat(int directory, const char* path, int mode, int flags) {
  if (is_hidden_at(directory, path)) return not_there();
  return original<int(int, const char*, int, int)>("faccessat")(directory, path, mode, flags);
}

extern "C" void* opendir(const char* path) {
  if (is_hidden(path)) {
    not_there();
    return nullptr;
  }
  return original<void*(const char*)>("opendir")(path);
}

extern "C" long readlink(const char* path, char* target, size_t size) {
  if (is_hidden(path)) return not_there();
  return original<long(const char*, char*, size_t)>("readlink")(path, target, size);
}

extern "C" char* realpath(const char* path, char* real) noexcept {
  if (is_hidden(path)) {
    not_there();
    return nullptr;
  }
  return original<char*(const char*, char*)>("realpath")(path, real);
}
