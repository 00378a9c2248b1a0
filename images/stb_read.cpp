#include <glassbox/images/stb_read.h>

#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include <glassbox/images/image_size.h>
#include <glassbox/images/stb_check.h>

// Our own copy of stb_image, with only the readers that are used and with memory that starts as
// zeros. Otherwise the parts that a broken JPEG leaves out would hold old memory, which differs
// from run to run. Broken JPEGs also fail stb's assertions, without harm, so these are switched
// off, and make sums overflow, so CMakeLists.txt sets -fwrapv.
#define STBI_ASSERT(condition)
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_BMP
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_NO_LINEAR
#define STBI_NO_STDIO
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(block, size) std::realloc(block, size)
#define STBI_FREE(block) std::free(block)
#include <stb_image.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

enum class Kind { kJpeg, kBmp, kTga };

// stb would also take a file that begins with FF FF D8 for a JPEG; no TGA begins so either.
std::optional<Kind> kind_of(Bytes bytes) {
  if (bytes.size() < 2 || bytes.size() > std::size_t(std::numeric_limits<int>::max())) return {};
  const auto first = unsigned(bytes[0]), second = unsigned(bytes[1]);
  if (first == 0xff) return second == 0xd8 ? std::optional(Kind::kJpeg) : std::nullopt;
  return first == 'B' && second == 'M' ? Kind::kBmp : Kind::kTga;
}

struct FreeStb {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

struct Pixels {
  int width = 0, height = 0, channels = 0;
  std::unique_ptr<stbi_uc, FreeStb> samples;
};

tl::unexpected<Error> not_valid(const std::string& why) {
  return fail("", "not a valid JPEG, BMP or TGA image" + why, "save the image again");
}

// Reads the size. Call check_jpeg first for a JPEG: stb reads the Huffman tables to find the size.
Result<Pixels> read_size(Bytes bytes) {
  Pixels pixels;
  const bool known =
      stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), int(bytes.size()),
                            &pixels.width, &pixels.height, &pixels.channels) != 0;
  if (!known || pixels.width < 0 || pixels.height == std::numeric_limits<int>::min()) {
    return not_valid("");
  }
  // The height of a BMP is negative if its top row comes first.
  pixels.height = std::abs(pixels.height);
  return pixels;
}

// Reads the size and makes all checks that stb does not make itself.
Result<Pixels> check(Kind kind, Bytes bytes, const DecodeLimits& limits) {
  if (kind == Kind::kJpeg) {
    const auto sound = check_jpeg(bytes);
    if (!sound) return tl::unexpected<Error>(sound.error());
  }
  auto pixels = read_size(bytes);
  if (!pixels) return pixels;
  const auto width = std::uint64_t(pixels->width), height = std::uint64_t(pixels->height);
  // A JPEG spends at least one bit on each 8 x 8 block of each component. One component has the
  // image's full resolution along one axis and at least a quarter of it along the other. So a byte
  // encodes at most 8 * 64 * 4 = 2048 pixels. BMP and TGA are checked exactly below (a packet of
  // TGA holds at most 128 pixels).
  Result<void> sound = check_image_size(width, height, bytes.size(), 2048, limits);
  if (sound && kind == Kind::kBmp) sound = check_bmp(bytes, width, height);
  if (sound && kind == Kind::kTga) sound = check_tga(bytes, width, height);
  if (!sound) return tl::unexpected<Error>(sound.error());
  return pixels;
}

// Decodes with `channels` channels a pixel; if `channels` is 0, with as many as the file has.
Result<Pixels> decode(Bytes bytes, int channels, const DecodeLimits& limits) {
  const auto kind = kind_of(bytes);
  if (!kind) return not_valid("");
  auto pixels = check(*kind, bytes, limits);
  if (!pixels) return pixels;
  int in_file = 0;
  pixels->samples.reset(stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                              int(bytes.size()), &pixels->width, &pixels->height,
                                              &in_file, channels));
  pixels->channels = channels == 0 ? in_file : channels;
  if (!pixels->samples) return not_valid(std::string(": ") + stbi_failure_reason());
  return pixels;
}

}  // namespace

std::optional<ImageSize> find_size_with_stb(Bytes bytes) {
  constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();
  const auto kind = kind_of(bytes);
  if (!kind) return std::nullopt;
  const auto pixels = check(*kind, bytes, {kAll, std::numeric_limits<std::uint32_t>::max()});
  if (!pixels) return std::nullopt;
  return ImageSize{std::uint32_t(pixels->width), std::uint32_t(pixels->height)};
}

bool is_stb_format(Bytes bytes) {
  const auto kind = kind_of(bytes);
  return kind && (*kind != Kind::kTga || read_size(bytes));
}

Result<Image<Rgba8>> decode_with_stb(Bytes bytes, const DecodeLimits& limits) {
  const auto pixels = decode(bytes, 4, limits);
  if (!pixels) return tl::unexpected<Error>(pixels.error());
  Image<Rgba8> image(pixels->width, pixels->height);
  std::memcpy(image.pixels.data(), pixels->samples.get(), image.pixels.size() * sizeof(Rgba8));
  return image;
}

Result<StoredImage> decode_stored_with_stb(Bytes bytes, const DecodeLimits& limits) {
  const auto pixels = decode(bytes, 0, limits);
  if (!pixels) return tl::unexpected<Error>(pixels.error());
  StoredImage image{pixels->width, pixels->height, pixels->channels, {}};
  const std::uint8_t* samples = pixels->samples.get();
  image.samples =
      std::vector<std::uint8_t>(samples, samples + image.pixels() * std::size_t(image.channels));
  return image;
}

Result<StoredHeader> stored_header_with_stb(Bytes bytes, const DecodeLimits& limits) {
  const auto kind = kind_of(bytes);
  if (!kind) return not_valid("");
  return check(*kind, bytes, limits).map([](const Pixels& pixels) {
    return StoredHeader{pixels.width, pixels.height, pixels.channels};
  });
}

}  // namespace glassbox
