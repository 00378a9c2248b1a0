#include <glassbox/compare/report/page_blob.h>

#include <bit>
#include <cstddef>
#include <vector>

#include <glassbox/base/little_endian.h>
#include <glassbox/html/blob.h>

namespace glassbox {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::span<const std::byte> bytes_of(const StoredImage& image) {
  return std::visit([](const auto& samples) { return std::as_bytes(std::span(samples)); },
                    image.samples);
}

void append_row_differences(Bytes& out, const StoredImage& image, const PixelBox& box) {
  const std::span<const std::byte> bytes = bytes_of(image);
  const std::size_t pixel = std::size_t(image.channels) * sample_bytes(image);
  const std::size_t row = std::size_t(image.width) * pixel;
  for (int y = 0; y < box.height; ++y) {
    const std::size_t first = std::size_t(box.y + y) * row + std::size_t(box.x) * pixel;
    for (std::size_t i = first; i < first + std::size_t(box.width) * pixel; ++i) {
      const auto above = y == 0 ? std::uint8_t(0) : std::uint8_t(bytes[i - row]);
      out.push_back(std::uint8_t(std::uint8_t(bytes[i]) - above));
    }
  }
}

}  // namespace

std::size_t sample_bytes(const StoredImage& image) {
  return std::visit([](const auto& samples) { return sizeof(samples[0]); }, image.samples);
}

Result<std::string> encode_blob(const StoredImage& image, std::span<const PixelBox> boxes) {
  std::size_t pixels = 0;
  for (const PixelBox& box : boxes) pixels += std::size_t(box.width) * std::size_t(box.height);
  Bytes bytes;
  bytes.reserve(pixels * std::size_t(image.channels) * sample_bytes(image));
  for (const PixelBox& box : boxes) append_row_differences(bytes, image, box);
  return compressed_base64(bytes);
}

}  // namespace glassbox
