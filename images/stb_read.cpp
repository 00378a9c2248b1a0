#include <glassbox/images/stb_read.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include <glassbox/images/image_size.h>

// A copy of stb_image of our own, of the readers that are used and with memory that starts as zeros: what a broken JPEG
// leaves out would otherwise be whatever was there before, and differ from run to run.
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

bool starts_with(Bytes bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

std::uint64_t number_at(Bytes bytes, std::size_t offset, std::size_t size) {  // little-endian
  std::uint64_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = value << 8 | std::uint64_t(bytes[offset + i]);
  return value;
}

tl::unexpected<Error> cut_off(const char* format) {
  return fail("", std::string("the ") + format + " file is cut off", "save the image again");
}

// JPEG: stb fills what is missing with grey; a file without its last marker is refused instead. Inside coded data the
// bytes FF DA and FF D9 occur only as the markers "start of scan" and "end of image".
Result<void> check_jpeg(Bytes bytes) {
  constexpr int kMaxScans =
      500;  // an encoder writes about ten; each one costs a pass over the image
  int scans = 0;
  bool ended = false;
  for (std::size_t i = 0; i + 1 < bytes.size(); ++i) {
    if (bytes[i] != std::byte{0xff}) continue;
    if (bytes[i + 1] == std::byte{0xda}) {
      ++scans;
      ended = false;
    }
    if (bytes[i + 1] == std::byte{0xd9}) ended = true;
  }
  if (!ended) return cut_off("JPEG");
  if (scans > kMaxScans) {
    return fail("", "JPEG with " + std::to_string(scans) + " scans", "save the image again");
  }
  return {};
}

// Rows of 1, 4 or 8 bits that choose one of so many colours.
bool chooses_at_most(Bytes rows, std::uint64_t row_bytes, std::uint64_t width, unsigned bits,
                     std::int64_t colours) {
  if (colours >= std::int64_t(1) << bits) return true;
  for (; rows.size() >= row_bytes; rows = rows.subspan(row_bytes)) {
    for (std::uint64_t x = 0; x < width; ++x) {
      const unsigned byte = unsigned(rows[x * bits / 8]);
      const unsigned index = byte >> (8 - bits - x * bits % 8) & ((1u << bits) - 1);
      if (std::int64_t(index) >= colours) return false;
    }
  }
  return true;
}

// BMP: rows without compression (stb reads no other), padded to 4 bytes. stb takes colours behind the end of the palette
// from memory that nobody has written.
Result<void> check_bmp(Bytes bytes, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kFileHeaderBytes = 14;
  if (bytes.size() < 30) return cut_off("BMP");
  const std::uint64_t info_bytes = number_at(bytes, 14, 4);
  const bool os2 = info_bytes == 12;
  const std::uint64_t bits = number_at(bytes, os2 ? 24 : 28, 2);
  const std::uint64_t row_bytes = (width * bits + 31) / 32 * 4;
  const std::uint64_t pixels_at = number_at(bytes, 10, 4);
  if (pixels_at + row_bytes * height > bytes.size()) return cut_off("BMP");
  if (bits == 1 || bits == 4 || bits == 8) {
    // As stb counts; of a palette of OS/2 it loses the last four.
    const std::int64_t palette_bytes =
        std::int64_t(pixels_at) - std::int64_t(kFileHeaderBytes + (os2 ? 24 : info_bytes));
    const Bytes rows = bytes.subspan(pixels_at, row_bytes * height);
    if (!chooses_at_most(rows, row_bytes, width, unsigned(bits), palette_bytes / (os2 ? 3 : 4))) {
      return fail("", "BMP with a pixel behind the end of its palette", "convert it to PNG");
    }
  }
  return {};
}

// The bytes of run-length packets that hold so many pixels: a count and one pixel, or a count and as many pixels.
std::uint64_t packed_bytes(Bytes packets, std::uint64_t pixels, std::uint64_t pixel_bytes) {
  std::uint64_t at = 0;
  while (pixels > 0 && at < packets.size()) {
    const std::uint64_t head = std::uint64_t(packets[at]);
    const std::uint64_t run = std::min(head % 128 + 1, pixels);
    at += 1 + (head >= 128 ? 1 : run) * pixel_bytes;
    pixels -= run;
  }
  return pixels == 0 ? at : packets.size() + 1;
}

// TGA: a header of 18 bytes, an identifier, a palette, and pixels. stb fills what is missing with zeros.
Result<void> check_tga(Bytes bytes, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kHeaderBytes = 18;
  if (bytes.size() < kHeaderBytes) return cut_off("TGA");
  const bool has_palette = number_at(bytes, 1, 1) != 0;
  const bool packed = number_at(bytes, 2, 1) >= 9;
  const std::uint64_t pixel_bytes = (number_at(bytes, 16, 1) + 7) / 8;
  const std::uint64_t palette_bytes =
      has_palette ? number_at(bytes, 5, 2) * ((number_at(bytes, 7, 1) + 7) / 8) : 0;
  // stb takes the number of the palette's first entry for bytes to skip, and every row to run from left to right.
  const bool shifted = has_palette && number_at(bytes, 3, 2) != 0;
  const bool other_order = (number_at(bytes, 17, 1) & 0xd0) != 0;
  if (shifted || other_order) {
    return fail("", shifted ? "TGA with a palette that does not start at 0" : "TGA in an odd order",
                "convert it to PNG");
  }
  const std::uint64_t pixels_at = kHeaderBytes + number_at(bytes, 0, 1) + palette_bytes;
  if (pixels_at > bytes.size()) return cut_off("TGA");
  const Bytes samples = bytes.subspan(pixels_at);
  const std::uint64_t pixels = width * height;
  const std::uint64_t needed =
      packed ? packed_bytes(samples, pixels, pixel_bytes) : pixels * pixel_bytes;
  if (needed > samples.size()) return cut_off("TGA");
  return {};
}

struct FreeStb {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

struct Pixels {
  int width = 0, height = 0, channels = 0;
  std::unique_ptr<stbi_uc, FreeStb> samples;
};

Pixels read_size(Bytes bytes) {
  Pixels pixels;
  if (bytes.size() > std::size_t(std::numeric_limits<int>::max())) return {};
  const bool known =
      stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), int(bytes.size()),
                            &pixels.width, &pixels.height, &pixels.channels) != 0;
  if (!known || pixels.width < 0 || pixels.height == std::numeric_limits<int>::min()) return {};
  pixels.height = std::abs(pixels.height);  // BMP: below zero where the top row comes first
  return pixels;
}

// With `channels` a pixel, or as many as the file has where that is 0.
Result<Pixels> decode(Bytes bytes, int channels, const DecodeLimits& limits) {
  using namespace std::string_view_literals;
  Pixels pixels = read_size(bytes);
  const auto w = std::uint64_t(pixels.width), h = std::uint64_t(pixels.height);
  // A JPEG spends at least a bit on each 8 x 8 block of each component, of which one has at least a quarter of the
  // image's resolution along each axis: 512 * 4 pixels a byte. BMP and TGA are checked exactly below (a packet of TGA
  // holds at most 128 pixels).
  const auto fits = check_image_size(w, h, bytes.size(), 2048, limits);
  if (!fits) return tl::unexpected<Error>(fits.error());
  const Result<void> whole = starts_with(bytes, "\xff\xd8"sv) ? check_jpeg(bytes)
                             : starts_with(bytes, "BM"sv)     ? check_bmp(bytes, w, h)
                                                              : check_tga(bytes, w, h);
  if (!whole) return tl::unexpected<Error>(whole.error());

  int in_file = 0;
  pixels.samples.reset(stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                             int(bytes.size()), &pixels.width, &pixels.height,
                                             &in_file, channels));
  pixels.channels = channels == 0 ? in_file : channels;
  if (!pixels.samples) {
    return fail("", std::string("not a valid image: ") + stbi_failure_reason(),
                "save the image again");
  }
  return pixels;
}

}  // namespace

bool is_stb_format(Bytes bytes) {
  return read_size(bytes).channels > 0;
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

}  // namespace glassbox
