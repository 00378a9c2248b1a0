// Files that are either written completely or not at all.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <glassbox/base/error.h>

namespace glassbox {

// Writes `bytes` to the file `path`. They go to a temporary file beside it, which replaces it only
// when every write and the close have succeeded: a reader sees the old file or the new one, and a
// failure leaves neither half a file nor the temporary one. An existing file keeps its permissions,
// a new one gets those of the umask, and a symbolic link stays one. A path that is not a regular
// file (a pipe, a terminal, /dev/stdout) is written directly.
Result<void> write_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace glassbox
