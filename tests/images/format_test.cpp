// Formats are known by their first bytes, and what is not read is refused by its name.
#include "tests/support/catch.h"

#include <cmath>
#include <string>

#include <glassbox/base/random.h>
#include <glassbox/images/decode.h>
#include <glassbox/images/format.h>
#include <glassbox/images/stored_file.h>

#include "tests/images/exr_builder.h"
#include "tests/images/plain_builder.h"
#include "tests/images/stored_builder.h"

namespace {

using namespace glassbox;
using namespace std::string_literals;
using test::Bytes;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}
std::span<const std::byte> bytes_of(const Bytes& bytes) {
  return std::as_bytes(std::span(bytes));
}

std::string hdr_header(int width, int height) {
  return "#?RADIANCE\n# made by a test\nEXPOSURE=2\nFORMAT=32-bit_rle_rgbe\n\n-Y " +
         std::to_string(height) + " +X " + std::to_string(width) + "\n";
}

// A row as run lengths: of each of the four bytes, packets of equal bytes and of others.
std::string packed_row(const std::string& row, int width, Random& random) {
  std::string packed = {2, 2, char(width >> 8), char(width)};
  for (std::size_t part = 0; part < 4; ++part) {
    for (int x = 0; x < width;) {
      const auto at = [&](int i) { return row[std::size_t(i) * 4 + part]; };
      int run = 1;
      while (x + run < width && run < 127 && at(x + run) == at(x)) ++run;
      if (run > 1) {
        packed += {char(128 + run), at(x)};
      } else {
        run = int(random.integer(1, std::min(width - x, 128)));
        packed += char(run);
        for (int i = x; i < x + run; ++i) packed += at(i);
      }
      x += run;
    }
  }
  return packed;
}

}  // namespace

TEST_CASE(
    "a picture of a format that is not read is refused by its name, whatever its file's name") {
  const struct {
    std::string start;
    const char* name;
  } files[] = {{"GIF87a", "GIF"},
               {"GIF89a", "GIF"},
               {"II*\0\x08\0\0\0"s, "TIFF"},
               {"MM\0*\0\0\0\x08"s, "TIFF"},
               {"II+\0\x08\0"s, "BigTIFF"},
               {"RIFF\x24\0\0\0WEBPVP8 "s, "WebP"},
               {"\0\0\0\x0cjP  \r\n"s, "JPEG 2000"},
               {"\xff\x0a\xff", "JPEG XL"},
               {"\0\0\0\x20"
                "ftypavif"s,
                "AVIF"},
               {"\0\0\0\x18"
                "ftypheic"s,
                "HEIF"},
               {"8BPS\0\1"s, "Photoshop"},
               {"DDS \x7c\0\0\0"s, "DDS"},
               {"\xabKTX 11\xbb", "KTX"},
               {"qoif\0\0\0\1"s, "QOI"}};
  for (const auto& [start, name] : files) {
    const std::string file = start + std::string(100, '\1');
    CAPTURE(name);
    for (const Error& error :
         {decode_stored(bytes_of(file)).error(), stored_header(bytes_of(file)).error(),
          decode_image(bytes_of(file)).error()}) {
      CHECK(error.cause == "is a " + std::string(name) + " picture, which is not read");
      CHECK(error.remedy.starts_with("convert it to PNG"));
    }
    CHECK_FALSE(find_image_size(bytes_of(file)));
  }
}

TEST_CASE("floats are read for comparisons, and refused by name as a texture") {
  const Bytes exr = test::build_exr({});
  for (const std::string& file : {"PF 1 1 -1\nabcdabcdabcd"s, hdr_header(1, 1) + "abcd",
                                  std::string(exr.begin(), exr.end())}) {
    CHECK(decode_stored(bytes_of(file)));
    const auto refused = decode_image(bytes_of(file));
    REQUIRE_FALSE(refused);
    CHECK(refused.error().cause.find("whose floats cannot be used here") != std::string::npos);
  }
}

TEST_CASE("a BMP with run lengths is refused as one") {
  for (const auto& [kind, name] : {std::pair(1u, "RLE8"), std::pair(2u, "RLE4")}) {
    Bytes bmp = test::build_bmp(2, 1, kind == 1 ? 8 : 4, {2, 0, 0, 1}, Bytes(16));
    test::put_little(bmp, 30, kind, 4);
    const auto refused = decode_stored(bytes_of(bmp));
    REQUIRE_FALSE(refused);
    CHECK(refused.error().cause ==
          "is a BMP with " + std::string(name) + " compression, which is not read");
  }
}

TEST_CASE("a Radiance HDR picture is the floats that its bytes encode, packed and not") {
  const std::uint64_t seed = 227;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 200; ++round) {
    const int width = int(random.integer(1, 300)), height = int(random.integer(1, 3));
    const bool packed = width >= 8 && random.integer(0, 1) == 0;
    CAPTURE(width, height, packed);
    std::vector<float> expected;
    std::string file = hdr_header(width, height);
    for (int y = 0; y < height; ++y) {
      std::string row;
      for (int x = 0; x < width; ++x) {
        // The first byte is never 1 or 2, so no pixel looks like a run. Few values make runs.
        unsigned pixel[4];
        for (unsigned& byte : pixel) byte = unsigned(random.integer(0, 3)) * 75 + 3;
        pixel[3] = random.integer(0, 7) == 0 ? 0 : unsigned(random.integer(1, 255));
        for (int c = 0; c < 3; ++c) {
          expected.push_back(
              pixel[3] == 0 ? 0.0f : float(std::ldexp(double(pixel[c]), int(pixel[3]) - 136)));
        }
        for (const unsigned byte : pixel) row += char(byte);
      }
      file += packed ? packed_row(row, width, random) : row;
    }
    const auto image = decode_stored(bytes_of(file));
    REQUIRE(image);
    REQUIRE(*image == test::stored(width, height, 3, expected));
    const std::size_t cut = std::size_t(random.integer(0, std::int64_t(file.size()) - 1));
    REQUIRE_FALSE(decode_stored(bytes_of(file.substr(0, cut))));
  }
}

TEST_CASE("HDR pictures that stb_image would misread, or never end to read, are refused") {
  const auto cause = [](const std::string& file) {
    const auto image = decode_stored(bytes_of(file));
    REQUIRE_FALSE(image);
    return image.error().cause;
  };
  // The second pixel repeats the first one twice.
  CHECK(cause(hdr_header(3, 1) + "abcd\1\1\1\2abcdabcd").find("older run lengths") !=
        std::string::npos);
  const std::string good =
      "\2\2\0\x08\x88"
      "a\x88"
      "b\x88"
      "c\x88"
      "d"s;
  CHECK(decode_stored(bytes_of(hdr_header(8, 2) + good + good)));
  // The second row is not packed.
  CHECK(cause(hdr_header(8, 2) + good + std::string(32, 'a')).find("run lengths of row 2") !=
        std::string::npos);
  // A packet of no bytes, without end.
  CHECK(cause(hdr_header(8, 1) + "\2\2\0\x08"s + std::string(9, '\0')).find("of row 1") !=
        std::string::npos);
  // A packet that is longer than the row.
  CHECK(cause(hdr_header(8, 1) + "\2\2\0\x08\x89"s + std::string(99, 'a')).find("of row 1") !=
        std::string::npos);
  CHECK(cause("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n+Y 1 +X 1\nabcd").find("Radiance HDR") !=
        std::string::npos);
  CHECK(cause("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd").find("Radiance HDR") !=
        std::string::npos);
  CHECK(cause("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y -1 +X 1\nabcd").find("Radiance HDR") !=
        std::string::npos);
  CHECK(cause(hdr_header(16384, 16384) + good).find("cannot fit") != std::string::npos);
}

TEST_CASE("an extension of a picture is known in either case") {
  for (const char* name : {".png", ".PNG", ".Jpg", ".pam", ".hdr", ".tif", ".webp", ".exr"}) {
    CHECK(is_picture_extension(name));
  }
  for (const char* name : {"", ".", "png", ".txt", ".pngx", ".fuzzy"}) {
    CHECK_FALSE(is_picture_extension(name));
  }
}
