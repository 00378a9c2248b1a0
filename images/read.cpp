#include <glassbox/images/read.h>

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <glassbox/images/image_size.h>
#include <glassbox/images/out_of_memory.h>
#include <glassbox/images/stored_file.h>

namespace glassbox {
namespace {

tl::unexpected<Error> file_error(const std::string& path, std::string cause, std::string remedy) {
  return tl::unexpected<Error>(Error{path, {}, std::move(cause), std::move(remedy)});
}

// Reads and decodes a file; an error names the file.
template <class Picture>
Result<Picture> read_as(const std::string& path, const DecodeLimits& limits, auto decode,
                        std::uint64_t max_bytes = std::uint64_t(1) << 30) {
  auto picture = unless_out_of_memory([&]() -> Result<Picture> {
    const auto bytes = read_file(path, max_bytes);
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    return decode(*bytes, limits);
  });
  if (!picture) picture.error().file = path;
  return picture;
}

// The length of the longest file that is read. The widest pixel is four floats, and the channels of
// an OpenEXR file together have no more bytes; a sixteenth more and one MiB leave room for headers,
// filter bytes, some text, and the bytes by which deflate makes noise longer. A picture within the
// limits can have a longer file, which is refused: with much text or metadata, or as a P3 file of
// 16 bits, which writes a pixel in up to 18 bytes.
std::uint64_t longest_file(const DecodeLimits& limits) {
  constexpr std::uint64_t kMaxPixels = std::uint64_t(1) << 32;  // keeps the product small
  const std::uint64_t samples = std::min(limits.max_pixels, kMaxPixels) * kWidestPixelBytes;
  return samples + samples / 16 + (std::uint64_t(1) << 20);
}

}  // namespace

Result<std::vector<std::byte>> read_file(const std::string& path, std::uint64_t max_bytes) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) {
    return file_error(path, "is a directory", "name a file in it");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) {
    return file_error(path, std::string("cannot be opened: ") + std::strerror(errno),
                      "check the name and the permissions");
  }
  const auto too_long = [&] {
    return file_error(
        path, "has more than " + std::to_string(max_bytes) + " bytes, the most that is read",
        "use a smaller file");
  };
  if (S_ISREG(status.st_mode) && std::uint64_t(status.st_size) > max_bytes) return too_long();
  // The file is read in growing parts, because a pipe has no size and a reported size may be wrong.
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
    if (bytes.size() > max_bytes) return too_long();
    if (!full) return bytes;
    piece = std::max<std::size_t>(bytes.size(), 65536);
  }
}

Result<Image<Rgba8>> read_image(const std::string& path, const DecodeLimits& limits,
                                Orientation orientation) {
  return read_as<Image<Rgba8>>(path, limits, [&](auto bytes, const DecodeLimits& all) {
    return decode_image(bytes, all, orientation);
  });
}
Result<Image<float>> read_pfm(const std::string& path, const DecodeLimits& limits) {
  return read_as<Image<float>>(path, limits, &decode_pfm);
}
Result<Image<Rgb32f>> read_pfm_rgb(const std::string& path, const DecodeLimits& limits) {
  return read_as<Image<Rgb32f>>(path, limits, &decode_pfm_rgb);
}
Result<StoredImage> read_stored(const std::string& path, const DecodeLimits& limits) {
  return read_as<StoredImage>(path, limits, &decode_stored, longest_file(limits));
}
Result<StoredFile> read_stored_file(const std::string& path, const DecodeLimits& limits) {
  return read_as<StoredFile>(path, limits, &decode_stored_file, longest_file(limits));
}

}  // namespace glassbox
