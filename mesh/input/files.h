// The bytes that a file refers to: data URIs, and files inside its own directory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/out_of_memory.h>
#include <glassbox/mesh/limits.h>

namespace glassbox {

// Returns the Result of `load`, with the file named in its error. Running out of memory is also
// returned as an error.
template <class Load>
auto naming_file(const std::string& path, Load load) -> decltype(load()) {
  auto made = unless_out_of_memory(load, "there is not enough memory for it",
                                   "close other programs, or use a smaller scene");
  if (!made) made.error().file = path;
  return made;
}

}  // namespace glassbox

namespace glassbox::gltf {

using Bytes = std::vector<std::byte>;

// Reads a whole regular file. Directories, pipes and devices are refused, and so are files of more
// than `max_bytes`.
Result<Bytes> read_whole_file(const std::string& path, std::uint64_t max_bytes);

// Decodes "QUJD" to "ABC", strictly: only the alphabet of RFC 4648, padded to groups of four, with
// nothing in between.
Result<Bytes> decode_base64(std::string_view text);

class Resources {
public:
  // A `directory` of "" forbids every external file.
  Resources(std::string directory, const LoadLimits& limits)
      : directory_(std::move(directory)), limits_(limits) {}

  // Returns the bytes that `uri` refers to. URIs with a scheme must be data URIs (base64 or per
  // cent codes, RFC 2397). Everything else is a path relative to the directory, which it must not
  // leave, not even through a symbolic link. A file that is named twice is read once.
  Result<std::shared_ptr<const Bytes>> read(std::string_view uri);

  // The number of bytes read so far.
  std::uint64_t total_bytes() const { return total_bytes_; }

private:
  Result<std::shared_ptr<const Bytes>> read_inside_directory(const std::string& relative);

  std::string directory_;
  LoadLimits limits_;
  std::map<std::string, std::shared_ptr<const Bytes>> files_;  // by canonical path
  std::uint64_t total_bytes_ = 0;
};

}  // namespace glassbox::gltf
