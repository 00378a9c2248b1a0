// Packs files into one zip archive and reads such archives, by libzip.
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

// The bytes of a zip archive with the entries in their order. The same entries give the same bytes:
// every file gets the earliest date of the format, in 1980.
Result<std::vector<std::byte>> make_zip(const std::vector<ZipEntry>& entries);

// Reads the entries of an archive.
Result<std::vector<ZipEntry>> read_zip(const std::vector<std::byte>& bytes);

}  // namespace glassbox::labs
