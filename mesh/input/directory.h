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
  // A directory without any files.
  Directory() = default;
  // The directory of `file`; messages call it "the OBJ file" if `kind` is "OBJ". `max_bytes` limits
  // the sum of all files.
  Directory(const std::filesystem::path& file, const char* kind, std::uint64_t max_bytes);

  // Returns the canonical path of an existing file. A name is relative to the directory, with
  // slashes or backslashes, and must not leave it, not even through a symbolic link; nothing
  // outside is accessed to find this out.
  Result<std::filesystem::path> find(std::string_view name) const;

  Result<std::vector<std::byte>> read(const std::filesystem::path& found);

private:
  std::filesystem::path root_;      // canonical; empty where there are no files
  std::string owner_ = "the file";  // "the OBJ file"
  std::uint64_t bytes_left_ = 0;
};

}  // namespace glassbox::obj
