#include <glassbox/images/stb_read.h>

#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include <glassbox/images/image_size.h>
#include <glassbox/images/orientation.h>
#include <glassbox/images/stb_check.h>

// Our own copy of stb_image, with only the readers that are used and with memory that starts as
// zeros. Otherwise the parts that a broken JPEG leaves out would hold old memory, which differs
// from run to run. Broken JPEGs also fail stb's assertions, without harm, so these are switched
// off, and make sums overflow, so CMakeLists.txt sets -fwrapv.
#define STBI_ASSERT(condition)
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_BMP
#define STBI_ONLY_HDR
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(block, size) std::realloc(block, size)
#define STBI_FREE(block) std::free(block)
#include <stb_image.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

const char* name_of(StbFormat format) {
  constexpr const char* kNames[] = {"JPEG", "BMP", "TGA", "Radiance HDR"};
  return kNames[std::size_t(format)];
}

struct FreeStb {
  void operator()(void* samples) const { stbi_image_free(samples); }
};
template <class Sample>
using Samples = std::unique_ptr<Sample, FreeStb>;

tl::unexpected<Error> not_valid(StbFormat format, const std::string& why = "") {
  return fail("", std::string("not a valid ") + name_of(format) + " image" + why,
              "save the image again");
}

// stb takes the length as an int.
constexpr std::size_t kMaxBytes = std::size_t(std::numeric_limits<int>::max());

const stbi_uc* data_of(Bytes bytes) {
  return reinterpret_cast<const stbi_uc*>(bytes.data());
}

// Reads the size. Call check_jpeg first for a JPEG: stb reads the Huffman tables to find the size.
Result<StoredHeader> read_size(StbFormat format, Bytes bytes) {
  StoredHeader header;
  const bool known = bytes.size() <= kMaxBytes &&
                     stbi_info_from_memory(data_of(bytes), int(bytes.size()), &header.width,
                                           &header.height, &header.channels) != 0;
  // The height of a BMP is negative if its top row comes first.
  const bool may_be_negative =
      format == StbFormat::kBmp && header.height > std::numeric_limits<int>::min();
  if (!known || header.width < 0 || (header.height < 0 && !may_be_negative)) {
    return not_valid(format);
  }
  header.height = std::abs(header.height);
  return header;
}

// Reads the size and makes all checks that stb does not make itself.
Result<StoredHeader> check(StbFormat format, Bytes bytes, const DecodeLimits& limits) {
  Result<void> sound;
  if (format == StbFormat::kJpeg) sound = check_jpeg(bytes);
  if (format == StbFormat::kBmp) sound = check_bmp_compression(bytes);
  if (!sound) return tl::unexpected<Error>(sound.error());
  auto header = read_size(format, bytes);
  if (!header) return header;
  const auto width = std::uint64_t(header->width), height = std::uint64_t(header->height);
  // A JPEG spends at least one bit on each 8 x 8 block of each component. One component has the
  // image's full resolution along one axis and at least a quarter of it along the other. So a byte
  // encodes at most 8 * 64 * 4 = 2048 pixels. The others are checked exactly below (a packet of TGA
  // holds at most 128 pixels, and four packets of HDR 127).
  sound = check_image_size(width, height, bytes.size(), 2048, limits);
  if (sound && format == StbFormat::kBmp) sound = check_bmp(bytes, width, height);
  if (sound && format == StbFormat::kTga) sound = check_tga(bytes, width, height);
  if (sound && format == StbFormat::kHdr) sound = check_hdr(bytes, width, height);
  if (!sound) return tl::unexpected<Error>(sound.error());
  return header;
}

int orientation_of(StbFormat format, Bytes bytes) {
  return format == StbFormat::kJpeg ? exif_orientation(bytes) : 1;
}

ImageSize size_of(const StoredHeader& header) {
  return {std::uint32_t(header.width), std::uint32_t(header.height)};
}

// The header of the upright picture.
StoredHeader turned(StoredHeader header, int orientation) {
  if (is_sideways(orientation)) std::swap(header.width, header.height);
  return header;
}

// Decodes the bytes of a file that `check` has passed. `channels` is 0 for as many as the file has.
// Sets `header` to what was read.
Result<Samples<stbi_uc>> decode(StbFormat format, Bytes bytes, int channels, StoredHeader& header) {
  int in_file = 0;
  Samples<stbi_uc> samples(stbi_load_from_memory(data_of(bytes), int(bytes.size()), &header.width,
                                                 &header.height, &in_file, channels));
  if (!samples) return not_valid(format, std::string(": ") + stbi_failure_reason());
  header.channels = channels == 0 ? in_file : channels;
  return samples;
}

Result<StoredImage> decode_hdr(Bytes bytes, const StoredHeader& header) {
  constexpr int kRgb = 3;
  StoredImage image{header.width, header.height, kRgb, {}};
  int channels = 0;
  const Samples<float> samples(stbi_loadf_from_memory(
      data_of(bytes), int(bytes.size()), &image.width, &image.height, &channels, kRgb));
  if (!samples) return not_valid(StbFormat::kHdr, std::string(": ") + stbi_failure_reason());
  image.samples =
      std::vector<float>(samples.get(), samples.get() + image.pixels() * std::size_t(kRgb));
  return image;
}

}  // namespace

bool is_tga(Bytes bytes) {
  // stb would take a file that begins with FF FF D8 for a JPEG; no TGA begins so.
  return !bytes.empty() && bytes[0] != std::byte{0xff} && read_size(StbFormat::kTga, bytes);
}

Result<Image<Rgba8>> decode_with_stb(StbFormat format, Bytes bytes, const DecodeLimits& limits,
                                     Orientation orientation) {
  auto header = check(format, bytes, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  const auto samples = decode(format, bytes, int(sizeof(Rgba8)), *header);
  if (!samples) return tl::unexpected<Error>(samples.error());
  const int turn = orientation == Orientation::kUpright ? orientation_of(format, bytes) : 1;
  const ImageSize size = size_of(*header), upright = upright_size(turn, size);
  Image<Rgba8> image(int(upright.width), int(upright.height));
  turn_upright(turn, size, sizeof(Rgba8), samples->get(),
               reinterpret_cast<std::uint8_t*>(image.pixels.data()));
  return image;
}

Result<StoredImage> decode_stored_with_stb(StbFormat format, Bytes bytes,
                                           const DecodeLimits& limits) {
  auto header = check(format, bytes, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  if (format == StbFormat::kHdr) return decode_hdr(bytes, *header);
  const auto samples = decode(format, bytes, 0, *header);
  if (!samples) return tl::unexpected<Error>(samples.error());
  const int turn = orientation_of(format, bytes);
  const StoredHeader upright = turned(*header, turn);
  StoredImage image{upright.width, upright.height, upright.channels, {}};
  std::vector<std::uint8_t> pixels(image.pixels() * std::size_t(image.channels));
  turn_upright(turn, size_of(*header), std::size_t(image.channels), samples->get(), pixels.data());
  image.samples = std::move(pixels);
  return image;
}

Result<StoredHeader> stored_header_with_stb(StbFormat format, Bytes bytes,
                                            const DecodeLimits& limits) {
  return check(format, bytes, limits).map([&](const StoredHeader& header) {
    return turned(header, orientation_of(format, bytes));
  });
}

}  // namespace glassbox
