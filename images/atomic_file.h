// Files that are either written completely or not at all.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <glassbox/base/error.h>

namespace glassbox {

// Writes `bytes` to the file `path`. They go to a temporary file in the same directory, which
// replaces the file only when every write and the close have succeeded: a reader sees the old file
// or the new one, and a failure leaves neither half a file nor the temporary file. An existing file
// keeps its permissions, a new file gets those of the umask, and a symbolic link stays a link. A
// path that is not a regular file (a pipe, a terminal, /dev/stdout) is written directly.
Result<void> write_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace glassbox
