// The orientation in the Exif data of a JPEG is applied wherever its pixels are used.
#include "tests/support/catch.h"

#include <string>

#include <glassbox/base/random.h>
#include <glassbox/images/decode.h>
#include <glassbox/images/orientation.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stored_file.h>

#include "tests/images/png_builder.h"

namespace {

using namespace glassbox;
using namespace std::string_literals;
using test::Bytes;

// A JPEG of 9 x 7 pixels without Exif data.
Bytes plain_jpeg() {
  const auto bytes =
      read_file(GLASSBOX_SOURCE_DIR "/tests/fuzz/corpus/stored/rgb-subsampled.jpg").value();
  Bytes jpeg;
  for (const std::byte byte : bytes) jpeg.push_back(std::uint8_t(byte));
  return jpeg;
}

// The JPEG with a segment of this kind and these data behind its start.
Bytes with_segment(const Bytes& jpeg, std::uint8_t kind, const std::string& data) {
  Bytes whole{
      0xff, 0xd8, 0xff, kind, std::uint8_t((data.size() + 2) >> 8), std::uint8_t(data.size() + 2)};
  whole.insert(whole.end(), data.begin(), data.end());
  whole.insert(whole.end(), jpeg.begin() + 2, jpeg.end());
  return whole;
}

std::string number(std::uint32_t value, int size, bool big_endian) {
  std::string text;
  for (int i = 0; i < size; ++i) {
    text += char(value >> 8 * (big_endian ? size - 1 - i : i));
  }
  return text;
}

// Exif data with a description and an orientation.
std::string exif(std::uint32_t orientation, bool big_endian) {
  const auto two = [&](std::uint32_t value) { return number(value, 2, big_endian); };
  const auto four = [&](std::uint32_t value) { return number(value, 4, big_endian); };
  return "Exif\0\0"s + (big_endian ? "MM" : "II") + two(42) + four(8) + two(2) +  //
         two(0x010e) + two(2) + four(4) + "abc\0"s +                              //
         two(0x0112) + two(3) + four(1) + two(orientation) + two(0) + four(0);
}

std::span<const std::byte> as_bytes(const Bytes& bytes) {
  return std::as_bytes(std::span(bytes));
}

// The picture as Exif defines it: where the first stored row and the first stored column belong.
Image<Rgba8> upright(const Image<Rgba8>& stored, int orientation) {
  const bool rows_are_columns = orientation >= 5;
  // Whether the first row is at the end of its axis (the bottom or the right side), and the first
  // column.
  const bool row_last =
      orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  const bool column_last =
      orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const int w = stored.width, h = stored.height;
  Image<Rgba8> image(rows_are_columns ? h : w, rows_are_columns ? w : h);
  for (int row = 0; row < h; ++row) {
    for (int column = 0; column < w; ++column) {
      const int down = row_last ? h - 1 - row : row;
      const int across = column_last ? w - 1 - column : column;
      image.at(rows_are_columns ? down : across, rows_are_columns ? across : down) =
          stored.at(column, row);
    }
  }
  return image;
}

}  // namespace

TEST_CASE("a JPEG stands upright by every orientation, in either byte order") {
  const Bytes plain = plain_jpeg();
  const auto stored = decode_image(as_bytes(plain)).value();
  for (int orientation = 1; orientation <= 8; ++orientation) {
    for (const bool big_endian : {false, true}) {
      CAPTURE(orientation, big_endian);
      const Bytes jpeg = with_segment(plain, 0xe1, exif(std::uint32_t(orientation), big_endian));
      const Image<Rgba8> expected = upright(stored, orientation);
      CHECK(exif_orientation(as_bytes(jpeg)) == orientation);
      CHECK(decode_image(as_bytes(jpeg)).value() == expected);
      CHECK(decode_image(as_bytes(jpeg), {}, Orientation::kStored).value() == stored);
      const auto file = decode_stored_file(as_bytes(jpeg)).value();
      CHECK(file.image == as_stored(expected));
      CHECK(file.orientation == orientation);
      const auto size = find_image_size(as_bytes(jpeg)).value();
      CHECK(int(size.width) == expected.width);
      CHECK(int(size.height) == expected.height);
    }
  }
}

TEST_CASE("an orientation that is none, or of another segment, turns nothing") {
  const Bytes plain = plain_jpeg();
  const auto stored = decode_image(as_bytes(plain)).value();
  for (const std::uint32_t wrong : {0u, 9u, 255u, 65535u}) {
    const Bytes jpeg = with_segment(plain, 0xe1, exif(wrong, true));
    CHECK(decode_image(as_bytes(jpeg)).value() == stored);
  }
  CHECK(decode_image(as_bytes(with_segment(plain, 0xe2, exif(6, true)))).value() == stored);
  std::string other = exif(6, true);
  other[0] = 'e';
  CHECK(decode_image(as_bytes(with_segment(plain, 0xe1, other))).value() == stored);
}

TEST_CASE("broken Exif data turn a JPEG by a legal orientation or not at all") {
  const std::uint64_t seed = 229;
  CAPTURE(seed);
  Random random(seed);
  const std::string whole = exif(6, false);
  for (int round = 0; round < 3000; ++round) {
    std::string data = whole.substr(0, std::size_t(random.integer(0, std::int64_t(whole.size()))));
    for (int changes = int(random.integer(0, 3)); changes > 0 && data.size() > 6; --changes) {
      const auto at = std::size_t(random.integer(6, std::int64_t(data.size()) - 1));
      data[at] = char(random.bits());
    }
    const Bytes jpeg = with_segment(plain_jpeg(), 0xe1, data);
    const int orientation = exif_orientation(as_bytes(jpeg));
    REQUIRE((orientation >= 1 && orientation <= 8));
    REQUIRE(decode_image(as_bytes(jpeg)));
  }
}
