// Reads hostile image files with their samples as stored, the text in PNGs, and the recipe in that
// text.
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

#include <glassbox/base/utf8.h>
#include <glassbox/images/decode.h>
#include <glassbox/images/png_text.h>
#include <glassbox/images/pnm.h>
#include <glassbox/images/read.h>
#include <glassbox/images/recipe.h>
#include <glassbox/images/stored_file.h>
#include <glassbox/images/write.h>

#include "tests/fuzz/promises.h"

namespace {

using namespace glassbox;
using Bytes = std::span<const std::byte>;

constexpr DecodeLimits kLimits{.max_pixels = 1 << 16, .max_side = 4096};

using fuzz::require;

template <class T>
void require_explained(const Result<T>& result) {
  if (!result) fuzz::check_error(result.error());
}

std::uint8_t nearest_8(std::uint8_t sample) {
  return sample;
}
std::uint8_t nearest_8(std::uint16_t sample) {
  return std::uint8_t((sample + 128u) / 257u);  // rounds sample * 255 / 65535; there are no ties
}
std::uint8_t nearest_8(float) {
  return 0;  // decode_image and decode_pnm read no floats
}

// Returns the RGBA colour of the pixel whose samples start at `sample`.
template <class Sample>
Rgba8 rgba_of(const Sample* sample, int channels) {
  const bool colour = channels >= 3, alpha = channels % 2 == 0;
  return {nearest_8(sample[0]), nearest_8(sample[colour ? 1 : 0]),
          nearest_8(sample[colour ? 2 : 0]),
          alpha ? nearest_8(sample[channels - 1]) : std::uint8_t(255)};
}

void check(const StoredImage& image, Bytes bytes) {
  require(image.width >= 1 && image.height >= 1, "a size above zero");
  require(image.width <= 4096 && image.height <= 4096, "sides within the limit");
  require(image.pixels() <= kLimits.max_pixels, "pixels within the limit");
  require(image.channels >= 1 && image.channels <= 4, "one to four channels");
  const bool pnm = bytes[0] == std::byte{'P'};
  const auto same = pnm ? decode_pnm(bytes, kLimits) : decode_image(bytes, kLimits);
  std::visit(
      [&]<class Sample>(const std::vector<Sample>& samples) {
        const auto channels = std::size_t(image.channels);
        require(samples.size() == image.pixels() * channels, "as many samples as the size says");
        if (std::is_same_v<Sample, float>) return;
        // Here a picture that is shifted by a line feed is refused, as there can be no note.
        if (!same && same.error().cause == line_feed_text()) return;
        require(same.has_value(), "what decodes as stored decodes to RGBA");
        require(same->width == image.width && same->height == image.height, "the same size");
        // With a largest value other than 255 and 65535, rounding to 8 bits can differ from
        // rounding to 16 bits first and then to 8.
        if (pnm && sizeof(Sample) == 2) return;
        for (std::size_t i = 0; i < image.pixels(); ++i) {
          require(same->pixels[i] == rgba_of(samples.data() + i * channels, image.channels),
                  "the same pixels");
        }
      },
      image.samples);

  if (image.samples.index() == 2) {
    const bool has_alpha = image.channels % 2 == 0;
    require(encode_pfm(image).has_value() == !has_alpha, "floats without alpha can be written");
    require(!encode_png(image).has_value(), "floats are no PNG");
  } else {
    const auto png = encode_png(image);
    require(png && decode_stored(*png, kLimits) == image, "a PNG gives back what it was made of");
  }
}

void check_text(const std::vector<TextEntry>& entries) {
  require(entries.size() <= kMaxTextEntries, "not too many texts");
  for (const auto& [keyword, text] : entries) {
    require(!keyword.empty() && is_utf8(keyword) && is_utf8(text), "texts in UTF-8");
    require(text.size() <= 2 * kMaxTextBytes, "short texts");
    require(text.find('\0') == std::string::npos, "no zero bytes");
    if (const auto quoted = shell_quoted(text)) require(quoted->size() >= text.size(), "quoted");
  }
  if (const auto recipe = recipe_of(entries)) {
    require(recipe_of(to_text(*recipe)) == recipe, "a recipe comes back");
  }
}

}  // namespace

#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
// After most mutations the checksums of the chunks are set right: otherwise almost no input would
// get past their check.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  size = LLVMFuzzerMutate(data, size, max_size);
  if (size < 8 || data[0] != 0x89 || seed % 8 == 0) return size;
  const auto number_at = [&](std::size_t at) {
    return std::size_t(data[at]) << 24 | std::size_t(data[at + 1]) << 16 |
           std::size_t(data[at + 2]) << 8 | data[at + 3];
  };
  for (std::size_t at = 8; size - at >= 12;) {
    const std::size_t length = number_at(at);
    if (length > size - at - 12) break;
    const auto crc = ::crc32(0, data + at + 4, uInt(4 + length));
    for (std::size_t i = 0; i < 4; ++i)
      data[at + 8 + length + i] = std::uint8_t(crc >> (24 - 8 * i));
    at += 12 + length;
  }
  return size;
}
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes bytes = std::as_bytes(std::span(data, size));
  const auto image = decode_stored(bytes, kLimits);
  require_explained(image);
  if (image) check(*image, bytes);
  const auto file = decode_stored_file(bytes, kLimits);
  require(file.has_value() == image.has_value(), "a file is read where its picture is");
  if (file) require(file->rest.empty() == file->rest_name.empty(), "what else there is, is named");
  const auto entries = read_png_text(bytes);
  require_explained(entries);
  if (entries) check_text(*entries);

  // A mutated recipe in a PNG seldom passes the chunks' checksums, so the input is also used
  // directly as the options of a recipe.
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::vector<TextEntry> recipe{
      {"Software", "glassbox 1"}, {"glassbox scene", "scene"}, {"glassbox options", text}};
  check_text(is_utf8(text) && text.find('\0') == std::string::npos && size <= kMaxTextBytes
                 ? recipe
                 : std::vector<TextEntry>{});
  return 0;
}
