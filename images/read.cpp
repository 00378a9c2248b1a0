#include <glassbox/images/read.h>

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace glassbox {
namespace {

tl::unexpected<Error> file_error(const std::string& path, std::string cause, std::string remedy) {
  return tl::unexpected<Error>(Error{path, {}, std::move(cause), std::move(remedy)});
}

// Reads a file, decodes it and names it in the error.
template <class Pixel>
Result<Image<Pixel>> read_as(const std::string& path, const DecodeLimits& limits,
                             Result<Image<Pixel>> (*decode)(std::span<const std::byte>,
                                                            const DecodeLimits&)) {
  const auto bytes = read_file(path);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  auto image = decode(*bytes, limits);
  if (!image) image.error().file = path;
  return image;
}

Result<Image<Rgba8>> decode_any(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  const bool pnm = bytes.size() >= 2 && bytes[0] == std::byte{'P'} &&
                   (bytes[1] == std::byte{'5'} || bytes[1] == std::byte{'6'});
  return pnm ? decode_pnm(bytes, limits) : decode_image(bytes, limits);
}

}  // namespace

Result<std::vector<std::byte>> read_file(const std::string& path, std::uint64_t max_bytes) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) {
    return file_error(path, "is a directory", "name a file in it");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) {
    return file_error(path, std::string("cannot be opened: ") + std::strerror(errno),
                      "check the name and the permissions");
  }
  // In growing pieces, because a pipe has no size and a size may lie.
  std::vector<std::byte> bytes;
  std::size_t piece = S_ISREG(status.st_mode) ? std::size_t(status.st_size) + 1 : 65536;
  for (;;) {
    const std::size_t before = bytes.size();
    const std::uint64_t room = max_bytes + 1 - before;
    bytes.resize(before + std::size_t(std::min<std::uint64_t>(piece, room)));
    const std::size_t got = std::fread(bytes.data() + before, 1, bytes.size() - before, file.get());
    const bool full = before + got == bytes.size();
    bytes.resize(before + got);
    if (std::ferror(file.get())) {
      return file_error(path, std::string("cannot be read: ") + std::strerror(errno),
                        "check the disk");
    }
    if (bytes.size() > max_bytes) {
      return file_error(path, "has more than " + std::to_string(max_bytes) + " bytes",
                        "use a smaller file or raise the limit");
    }
    if (!full) return bytes;
    piece = std::max<std::size_t>(bytes.size(), 65536);
  }
}

Result<Image<Rgba8>> read_image(const std::string& path, const DecodeLimits& limits) {
  return read_as<Rgba8>(path, limits, &decode_any);
}
Result<Image<float>> read_pfm(const std::string& path, const DecodeLimits& limits) {
  return read_as<float>(path, limits, &decode_pfm);
}
Result<Image<Rgb32f>> read_pfm_rgb(const std::string& path, const DecodeLimits& limits) {
  return read_as<Rgb32f>(path, limits, &decode_pfm_rgb);
}

}  // namespace glassbox
