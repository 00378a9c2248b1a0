// The files that an OBJ or PLY file may name: those in its own directory and below.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::obj {

class Directory {
public:
  // Holds no file at all.
  Directory() = default;
  // The directory of `file`, which messages call "the OBJ file" if `kind` is "OBJ". `max_bytes` bounds all files together.
  Directory(const std::filesystem::path& file, const char* kind, std::uint64_t max_bytes);

  // The canonical path of an existing file. A name is relative to the directory, with slashes or
  // backslashes, and must not leave it, not even through a symbolic link; nothing outside is
  // touched in order to find out.
  Result<std::filesystem::path> find(std::string_view name) const;

  Result<std::vector<std::byte>> read(const std::filesystem::path& found);

private:
  std::filesystem::path root_;      // canonical; empty where there are no files
  std::string owner_ = "the file";  // "the OBJ file"
  std::uint64_t bytes_left_ = 0;
};

}  // namespace glassbox::obj
