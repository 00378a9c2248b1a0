#include <glassbox/images/stb_read.h>

#include <stb_image.h>

#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include <glassbox/images/image_size.h>

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

// BMP: rows without compression (stb reads no other), padded to 4 bytes.
Result<void> check_bmp(Bytes bytes, std::uint64_t width, std::uint64_t height) {
  if (bytes.size() < 30) return cut_off("BMP");
  const bool os2 = number_at(bytes, 14, 4) == 12;
  const std::uint64_t bits = number_at(bytes, os2 ? 24 : 28, 2);
  const std::uint64_t row_bytes = (width * bits + 31) / 32 * 4;
  const std::uint64_t pixels_at = number_at(bytes, 10, 4);
  if (pixels_at + row_bytes * height > bytes.size()) return cut_off("BMP");
  return {};
}

// TGA: a header of 18 bytes, an identifier, a palette, and pixels, of which a run-length packet holds at most 128.
Result<void> check_tga(Bytes bytes, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kHeaderBytes = 18, kMaxRun = 128;
  if (bytes.size() < kHeaderBytes) return cut_off("TGA");
  const bool has_palette = number_at(bytes, 1, 1) != 0;
  const bool packed = number_at(bytes, 2, 1) >= 9;
  const std::uint64_t pixel_bytes = (number_at(bytes, 16, 1) + 7) / 8;
  const std::uint64_t palette_start = number_at(bytes, 3, 2);
  const std::uint64_t palette_bytes =
      has_palette ? (palette_start + number_at(bytes, 5, 2)) * ((number_at(bytes, 7, 1) + 7) / 8)
                  : 0;
  const std::uint64_t pixels = width * height;
  const std::uint64_t needed =
      packed ? (pixels + kMaxRun - 1) / kMaxRun * (1 + pixel_bytes) : pixels * pixel_bytes;
  if (kHeaderBytes + number_at(bytes, 0, 1) + palette_bytes + needed > bytes.size()) {
    return cut_off("TGA");
  }
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
  if (!known || pixels.width < 0 || pixels.height < 0) return {};
  return pixels;
}

// With `channels` a pixel, or as many as the file has where that is 0.
Result<Pixels> decode(Bytes bytes, int channels, const DecodeLimits& limits) {
  using namespace std::string_view_literals;
  Pixels pixels = read_size(bytes);
  const auto w = std::uint64_t(pixels.width), h = std::uint64_t(pixels.height);
  // A JPEG spends at least a bit on each 8 x 8 block of each component, of which one has at least a quarter of the
  // image's resolution along each axis: 512 * 4 pixels a byte. BMP and TGA are checked exactly below.
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
  // stb knows other formats, but its readers of them are not fit for hostile files.
  using namespace std::string_view_literals;
  for (const auto magic : {"GIF8"sv, "8BPS"sv, "\x53\x80\xf6\x34"sv, "#?"sv, "P5"sv, "P6"sv}) {
    if (starts_with(bytes, magic)) return false;
  }
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
