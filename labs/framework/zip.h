// Files packed into one, by libzip.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs {

struct ZipEntry {
  std::string path;  // relative, with "/"
  std::string text;
  bool executable = false;
};

// The bytes of a zip archive with the entries in their order. The same entries give the same bytes: every file has the date of
// the format's beginning, 1980.
Result<std::vector<std::byte>> make_zip(const std::vector<ZipEntry>& entries);

// The entries of an archive.
Result<std::vector<ZipEntry>> read_zip(const std::vector<std::byte>& bytes);

}  // namespace glassbox::labs
