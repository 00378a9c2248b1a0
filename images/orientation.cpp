#include <glassbox/images/orientation.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

// Reads the numbers of a TIFF structure, which are in one of two byte orders. What lies behind the
// end is none.
struct Tiff {
  Bytes bytes;
  bool big_endian = false;

  std::optional<std::size_t> number(std::size_t at, std::size_t size) const {
    if (at > bytes.size() || bytes.size() - at < size) return std::nullopt;
    std::size_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value = value << 8 | std::size_t(bytes[at + (big_endian ? i : size - 1 - i)]);
    }
    return value;
  }
};

// The orientation in the first directory of a TIFF structure, 1 where there is none. A directory is
// a number of entries and then these, of 12 bytes: tag, type, count and value.
int orientation_in(Bytes bytes) {
  constexpr std::size_t kOrientation = 0x0112, kShort = 3;
  if (bytes.empty()) return 1;
  const Tiff tiff{bytes, bytes[0] == std::byte{'M'}};
  const auto directory = tiff.number(4, 4);
  const auto count = directory ? tiff.number(*directory, 2) : std::nullopt;
  for (std::size_t i = 0; i < count.value_or(0); ++i) {
    const std::size_t at = *directory + 2 + 12 * i;
    if (tiff.number(at, 2) != kOrientation || tiff.number(at + 2, 2) != kShort) continue;
    const std::size_t value = tiff.number(at + 8, 2).value_or(1);
    return value >= 1 && value <= 8 ? int(value) : 1;
  }
  return 1;
}

// The place in the stored picture of the pixel (x, y) of the upright one.
std::array<std::uint32_t, 2> stored_place(int orientation, ImageSize stored, std::uint32_t x,
                                          std::uint32_t y) {
  if (is_sideways(orientation)) std::swap(x, y);
  const std::uint32_t right = stored.width - 1 - x, bottom = stored.height - 1 - y;
  const bool mirrors_x =
      orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool mirrors_y =
      orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  return {mirrors_x ? right : x, mirrors_y ? bottom : y};
}

}  // namespace

int exif_orientation(Bytes jpeg) {
  using namespace std::string_view_literals;
  constexpr unsigned kScan = 0xda, kExifSegment = 0xe1;
  constexpr std::string_view kName = "Exif\0\0"sv;
  Bytes rest = jpeg.subspan(std::min<std::size_t>(jpeg.size(), 2));  // start of image
  // A segment is FF, its kind, and its length, which counts itself.
  while (rest.size() >= 4) {
    const auto kind = unsigned(rest[1]);
    const std::size_t length = std::size_t(rest[2]) << 8 | std::size_t(rest[3]);
    if (rest[0] != std::byte{0xff} || kind == kScan || length < 2 || rest.size() < 2 + length)
      break;
    const Bytes data = rest.subspan(4, length - 2);
    const std::string_view text(reinterpret_cast<const char*>(data.data()), data.size());
    if (kind == kExifSegment && text.starts_with(kName)) {
      return orientation_in(data.subspan(kName.size()));
    }
    rest = rest.subspan(2 + length);
  }
  return 1;
}

void turn_upright(int orientation, ImageSize size, std::size_t channels, const std::uint8_t* stored,
                  std::uint8_t* upright) {
  if (orientation == 1) {
    std::copy_n(stored, std::size_t(size.width) * size.height * channels, upright);
    return;
  }
  const ImageSize turned = upright_size(orientation, size);
  for (std::uint32_t y = 0; y < turned.height; ++y) {
    for (std::uint32_t x = 0; x < turned.width; ++x) {
      const auto [from_x, from_y] = stored_place(orientation, size, x, y);
      const std::size_t from = std::size_t(from_y) * size.width + from_x;
      upright = std::copy_n(stored + from * channels, channels, upright);
    }
  }
}

}  // namespace glassbox
