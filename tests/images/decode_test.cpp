#include "tests/support/catch.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <glassbox/images/decode.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>

#include <glassbox/base/random.h>
#include "tests/images/plain_builder.h"
#include "tests/images/png_builder.h"
#include "tests/support/skip.h"

namespace {

using namespace glassbox;
using test::build_png;
using test::Bytes;
using test::PngParts;

Result<Image<Rgba8>> decode(const Bytes& bytes, const DecodeLimits& limits = {}) {
  return decode_image(std::as_bytes(std::span(bytes)), limits);
}

Rgba8 only_pixel(const PngParts& parts) {
  const auto image = decode(build_png(parts));
  if (!image) FAIL(image.error().message());
  REQUIRE(image->pixels.size() == 1);
  return image->pixels[0];
}

// Returns a BMP of 24 bits per pixel in one colour.
Bytes plain_bmp(std::uint32_t width, std::uint32_t height) {
  return test::build_bmp(width, height, 24, test::one_colour(height, (width * 3 + 3) / 4 * 4));
}
Bytes plain_tga(std::uint16_t width, std::uint16_t height) {
  return test::build_tga(2, width, height, 24,
                         test::one_colour(1, std::size_t(width) * height * 3));
}

}  // namespace

TEST_CASE("every PNG colour type decodes to its pixels") {
  CHECK(only_pixel({.colour_type = 0, .rows = {0, 77}}) == Rgba8{77, 77, 77, 255});
  CHECK(only_pixel({.colour_type = 2, .rows = {0, 1, 2, 3}}) == Rgba8{1, 2, 3, 255});
  CHECK(only_pixel({.colour_type = 4, .rows = {0, 77, 5}}) == Rgba8{77, 77, 77, 5});
  CHECK(only_pixel({.colour_type = 6, .rows = {0, 1, 2, 3, 4}}) == Rgba8{1, 2, 3, 4});
  CHECK(only_pixel({.colour_type = 3, .palette = {9, 9, 9, 1, 2, 3}, .rows = {0, 1}}) ==
        Rgba8{1, 2, 3, 255});
  CHECK(only_pixel({.colour_type = 3,
                    .palette = {9, 9, 9, 1, 2, 3},
                    .transparency = {255, 8},
                    .rows = {0, 1}}) == Rgba8{1, 2, 3, 8});
  CHECK(only_pixel({.colour_type = 2, .transparency = {0, 1, 0, 2, 0, 3}, .rows = {0, 1, 2, 3}}) ==
        Rgba8{1, 2, 3, 0});
  for (const std::uint8_t depth :
       std::initializer_list<std::uint8_t>{1, 2, 4}) {  // all bits set means white
    CAPTURE(int(depth));
    CHECK(only_pixel({.bit_depth = depth, .colour_type = 0, .rows = {0, 0xff}}) ==
          Rgba8{255, 255, 255, 255});
  }
}

TEST_CASE("16 bits a channel become the nearest 8, for every value") {
  // The 65536 grey values are spread over 32 pictures, because a stored block holds less than 64
  // KiB.
  for (std::uint32_t part = 0; part < 32; ++part) {
    PngParts parts{.width = 2048, .height = 1, .bit_depth = 16, .colour_type = 0, .rows = {0}};
    for (std::uint32_t x = 0; x < 2048; ++x) {
      const std::uint32_t value = part * 2048 + x;
      parts.rows.push_back(std::uint8_t(value >> 8));
      parts.rows.push_back(std::uint8_t(value));
    }
    const auto image = decode(build_png(parts));
    REQUIRE(image);
    for (std::uint32_t x = 0; x < 2048; ++x) {
      const std::uint32_t value = part * 2048 + x;
      // value * 255 / 65535 = value / 257, rounded to the nearest; 257 is odd, so there are no
      // ties.
      const std::uint32_t nearest = (value + 128) / 257;
      if (image->pixels[x].r != nearest) {
        CAPTURE(value);
        REQUIRE(int(image->pixels[x].r) == int(nearest));
      }
    }
  }
}

TEST_CASE("BMP and TGA decode, and a file cut off anywhere is refused") {
  const Rgba8 colour{30, 20, 10, 255};
  for (const Bytes& whole : {plain_bmp(5, 3), plain_tga(5, 3)}) {
    const auto image = decode(whole);
    REQUIRE(image);
    CHECK(image->width == 5);
    CHECK(image->height == 3);
    for (const Rgba8& pixel : image->pixels) CHECK(pixel == colour);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      CAPTURE(size, whole.size());
      CHECK_FALSE(decode(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size))));
    }
  }
}

TEST_CASE("a JPEG decodes, and cut off at any length is refused") {
  const auto whole = read_file(GLASSBOX_SOURCE_DIR "/tests/fuzz/corpus/image/baseline.jpg").value();
  const auto image = decode_image(whole);
  REQUIRE(image);
  REQUIRE(image->width == 16);
  REQUIRE(image->height == 8);
  // The picture has one colour throughout, (200, 100, 50) before compression with quality 90. The
  // quantisation step of 3 moves a block's mean by at most 3/16, luma and chroma are rounded by at
  // most 1/2, and blue is luma + 1.772 chroma, rounded: 2.772 * 11/16 + 1/2 < 3.
  for (const Rgba8& pixel : image->pixels) {
    CHECK(std::abs(pixel.r - 200) <= 3);
    CHECK(std::abs(pixel.g - 100) <= 3);
    CHECK(std::abs(pixel.b - 50) <= 3);
    CHECK(int(pixel.a) == 255);
  }
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size, whole.size());
    CHECK_FALSE(decode_image(std::span(whole).first(size)));
  }
}

TEST_CASE("a PNG cut off at any length is refused") {
  Random random(3);
  Image<Rgba8> image(31, 17);
  for (Rgba8& pixel : image.pixels) pixel = {std::uint8_t(random.bits()), 1, 2, 200};
  const auto whole = encode_png(image).value();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size, whole.size());
    const auto cut = decode_image(std::span(whole).first(size));
    REQUIRE_FALSE(cut);
    REQUIRE_FALSE(cut.error().cause.empty());
    REQUIRE_FALSE(cut.error().remedy.empty());
  }
}

TEST_CASE("a PNG with any one bit flipped decodes or is refused, never worse") {
  Image<Rgba8> image(6, 5, {40, 50, 60, 70});
  auto png = encode_png(image).value();
  std::size_t refused = 0;
  for (std::size_t bit = 0; bit < png.size() * 8; ++bit) {
    png[bit / 8] ^= std::byte(1 << bit % 8);
    const auto decoded = decode_image(png);
    // Only flips that leave IHDR as it is (its CRC is checked) can decode, and then to the same
    // size.
    if (decoded && (decoded->width != 6 || decoded->height != 5)) FAIL("bit " << bit);
    if (!decoded) ++refused;
    png[bit / 8] ^= std::byte(1 << bit % 8);
  }
  // At least every flip in the signature and the header (33 bytes) is refused.
  CHECK(refused >= 33 * 8);
}

TEST_CASE("images above the limits are refused with the limit and the remedy") {
  const PngParts wide{.width = 20, .height = 10, .colour_type = 0, .rows = Bytes(210)};
  const Bytes png = build_png(wide);
  CHECK(decode(png));
  CHECK(decode(png, {.max_pixels = 200, .max_side = 20}));
  CHECK(decode(png, {.max_side = 19}).error().message() ==
        "the image has 20 x 10 pixels, but a side may have at most 19; scale the image down");
  CHECK(decode(png, {.max_pixels = 199}).error().message() ==
        "the image has 20 x 10 pixels, but may have at most 199 in all; scale the image down");
  CHECK_FALSE(decode(plain_bmp(20, 10), {.max_pixels = 199}));
  CHECK_FALSE(decode(plain_tga(20, 10), {.max_side = 19}));
}

TEST_CASE("an image that claims more pixels than its bytes can hold is refused at once") {
  // At 1 bit per pixel a byte of the file holds at most 8 * 1032 pixels, so 8192 x 8192 pixels need
  // 8129 bytes; this file has about 160.
  const PngParts bomb{
      .width = 8192, .height = 8192, .bit_depth = 1, .colour_type = 0, .rows = Bytes(100)};
  const auto refused = decode(build_png(bomb));
  REQUIRE_FALSE(refused);
  CHECK(refused.error().cause.starts_with("an image of 8192 x 8192 pixels cannot fit into"));
  // 785 MB of RGBA exceed the default limits, no matter how many bytes the file has.
  const PngParts large{
      .width = 14008, .height = 14008, .bit_depth = 1, .colour_type = 0, .rows = Bytes(60000)};
  CHECK(decode(build_png(large)).error().cause.find("but may have at most") != std::string::npos);
  Bytes bmp = plain_bmp(4, 4);
  bmp[20] = 0x10;  // makes the width 2^20 + 4
  CHECK_FALSE(decode(bmp, {.max_side = 1u << 30}));
}

TEST_CASE("what is no image is refused") {
  Random random(17);
  CHECK_FALSE(decode({}));
  for (const char* text : {"GIF89a", "8BPS", "#?RADIANCE\n", "P6 1 1 255\nab", "hello", "<svg/>"}) {
    CAPTURE(text);
    CHECK_FALSE(decode(Bytes(text, text + std::strlen(text))));
  }
  for (int i = 0; i < 2000; ++i) {
    Bytes bytes(std::size_t(random.integer(0, 200)));
    for (std::uint8_t& byte : bytes) byte = std::uint8_t(random.bits());
    const auto image = decode(bytes);
    // Random bytes may form a TGA, which has no signature; its pixels are then within the limits.
    if (image) CHECK(image->pixels.size() <= 2048 * bytes.size());
  }
}

TEST_CASE("the PNG suite decodes, and no file of it with a byte changed where that must be seen") {
  const std::filesystem::path root =
      std::filesystem::path(GLASSBOX_ASSETS_DIR) / "malformed/pngsuite";
  if (!std::filesystem::is_directory(root)) SKIP_TEST("no assets at " << root.string());
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".png") continue;
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    ++files;
    if (name[0] == 'x') {  // one of the suite's broken files
      CHECK_FALSE(read_image(entry.path().string()));
      continue;
    }
    const auto whole = read_file(entry.path().string()).value();
    CHECK(decode_image(whole));
    // The defects of the suite's own broken files: a lost bit, a changed letter or a converted line
    // end in the signature, a wrong checksum of the header.
    for (const std::size_t at : {0u, 1u, 4u, 6u, 29u}) {
      auto broken = whole;
      broken[at] ^= std::byte{0x80};
      CAPTURE(at);
      CHECK_FALSE(decode_image(broken));
    }
  }
  CHECK(files > 0);
}

TEST_CASE("real photographs decode, and cut off at a half are refused") {
  const std::filesystem::path root = std::filesystem::path(GLASSBOX_ASSETS_DIR) / "meshes";
  if (!std::filesystem::is_directory(root)) SKIP_TEST("no assets at " << root.string());
  int photographs = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const auto extension = entry.path().extension();
    if (extension != ".jpg" && extension != ".jpeg") continue;
    CAPTURE(entry.path().string());
    const auto bytes = read_file(entry.path().string()).value();
    CHECK(decode_image(bytes));
    CHECK_FALSE(decode_image(std::span(bytes).first(bytes.size() / 2)));
    ++photographs;
  }
  CHECK(photographs > 0);
}
