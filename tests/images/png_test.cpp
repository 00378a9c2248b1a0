#include "tests/support/catch.h"

#include <cstring>
#include <utility>

#include <oneapi/tbb/task_arena.h>

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/decode.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>

#include <glassbox/base/random.h>
#include "tests/images/temporary_directory.h"

namespace {

using namespace glassbox;
using test::TemporaryDirectory;

enum class Alpha { kOpaque, kVaried };

Image<Rgba8> random_image(int width, int height, Alpha alpha, Random& random) {
  Image<Rgba8> image(width, height);
  for (Rgba8& pixel : image.pixels) {
    const std::uint64_t bits = random.bits();
    pixel = {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16),
             alpha == Alpha::kOpaque ? std::uint8_t(255) : std::uint8_t(bits >> 24)};
  }
  return image;
}

// Returns the byte of IHDR that holds the colour type.
int colour_type(const std::vector<std::byte>& png) {
  return int(png.at(25));
}

bool contains(const std::vector<std::byte>& bytes, std::string_view text) {
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return all.find(text) != std::string_view::npos;
}

}  // namespace

TEST_CASE("a PNG gives back the pixels it was made of, at every size from 1 x 1") {
  const std::uint64_t seed = 7;
  CAPTURE(seed);
  Random random(seed);
  for (const int width : {1, 2, 3, 7, 64, 257}) {
    for (const int height : {1, 2, 5, 33}) {
      for (const Alpha alpha : {Alpha::kOpaque, Alpha::kVaried}) {
        CAPTURE(width, height, alpha == Alpha::kOpaque);
        const auto image = random_image(width, height, alpha, random);
        const auto png = encode_png(image);
        REQUIRE(png);
        const auto back = decode_image(*png);
        REQUIRE(back);
        REQUIRE(*back == image);
      }
    }
  }
}

TEST_CASE("rows are compressed in bands, which any number of threads makes the same") {
  Random random(8);
  // One picture has many rows in a band, the other a few; the last band is shorter.
  for (const auto& [width, height] : {std::pair{300, 1000}, std::pair{16384, 10}}) {
    const auto image = random_image(width, height, Alpha::kVaried, random);
    std::vector<std::vector<std::byte>> all;
    for (const int threads : {1, 4}) {
      tbb::task_arena arena(threads);
      const auto png = arena.execute([&] { return encode_png(image); });
      REQUIRE(png);
      all.push_back(*png);
    }
    CHECK(all[0] == all[1]);
    const auto back = decode_image(all[0]);
    REQUIRE(back);
    CHECK(*back == image);
  }
}

TEST_CASE("an opaque picture is stored as RGB, any other as RGBA") {
  Image<Rgba8> image(4, 4);
  CHECK(colour_type(encode_png(image).value()) == 2);
  image.at(3, 3).a = 254;
  CHECK(colour_type(encode_png(image).value()) == 6);
}

TEST_CASE("the same picture and text give the same PNG bytes") {
  Random random(11);
  const auto image = random_image(100, 40, Alpha::kVaried, random);
  const std::vector<TextEntry> text{{"Command", "glassbox render duck.glb"}};
  CHECK(encode_png(image, text).value() == encode_png(image, text).value());
}

TEST_CASE("ASCII text is kept as tEXt and other text as UTF-8 in iTXt") {
  const Image<Rgba8> image(2, 2);
  const std::vector<TextEntry> text{{"Command", "glassbox render\nduck.glb"},
                                    {"Title", "Teekanne f\xc3\xbcr zwei"}};
  const auto png = encode_png(image, text);
  REQUIRE(png);
  using namespace std::string_view_literals;
  CHECK(contains(*png, "tEXtCommand\0glassbox render\nduck.glb"sv));
  CHECK(contains(*png, "iTXtTitle\0\0\0\0\0Teekanne f\xc3\xbcr zwei"sv));
  CHECK(decode_image(*png).value() == image);
}

TEST_CASE("PNG text that the format cannot hold is refused") {
  const Image<Rgba8> image(2, 2);
  const std::vector<std::string> keywords{"",     " a",      "a ", "a  b", std::string(80, 'k'),
                                          "a\nb", "\xc3\xbc"};
  for (const std::string& keyword : keywords) {
    CAPTURE(keyword);
    const std::vector<TextEntry> text{{keyword, "text"}};
    CHECK_FALSE(encode_png(image, text));
  }
  const std::vector<TextEntry> zero{{"Key", std::string("a\0b", 3)}};
  CHECK_FALSE(encode_png(image, zero));
}

TEST_CASE("a picture without pixels is refused") {
  CHECK_FALSE(encode_png(Image<Rgba8>()));
  CHECK_FALSE(encode_png(Image<Rgba8>(0, 5)));
}

TEST_CASE("the extension chooses the format, and others are refused before anything is written") {
  Random random(13);
  const auto image = random_image(9, 5, Alpha::kOpaque, random);
  const TemporaryDirectory directory;
  for (const char* name : {"a.png", "b.PNG", "c.ppm", "d.b.PpM"}) {
    CAPTURE(name);
    REQUIRE(write_image(directory.file(name), image));
    const auto back = read_image(directory.file(name));
    REQUIRE(back);
    CHECK(*back == image);
  }
  for (const char* name : {"a.jpg", "png", "png.d/a", ".", "a."}) {
    CAPTURE(name);
    CHECK_FALSE(check_image_path(directory.file(name)));
    CHECK_FALSE(write_image(directory.file(name), image));
  }
  CHECK(write_image(directory.file("x.jpg"), image).error().message() ==
        directory.file("x.jpg") + ": unknown image format \".jpg\"; end the name in .png or .ppm");
  CHECK(directory.names().size() == 4);
}
