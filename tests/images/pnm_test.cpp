#include "tests/support/catch.h"

#include <cmath>
#include <limits>
#include <string_view>

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>

#include "tests/images/temporary_directory.h"

namespace {

using namespace glassbox;
using namespace std::string_view_literals;

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::string text_of(const std::vector<std::byte>& bytes) {
  return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

}  // namespace

TEST_CASE("a PPM is a header and the colours from the top row on") {
  Image<Rgba8> image(2, 2);
  image.pixels = {{'a', 'b', 'c', 255}, {'d', 'e', 'f', 0}, {'g', 'h', 'i', 1}, {'j', 'k', 'l', 2}};
  CHECK(text_of(encode_ppm(image)) == "P6\n2 2\n255\nabcdefghijkl");
}

TEST_CASE("PPM and PGM headers may have comments, and any largest value") {
  const auto first = [](std::string_view text) {
    return decode_pnm(bytes_of(text)).value().at(0, 0);
  };
  CHECK(first("P6 # a comment\n# another 9 9\n1\t1 255\n\x01\x02\x03"sv) == Rgba8{1, 2, 3, 255});
  CHECK(first("P5 1 1 255 \x20"sv) == Rgba8{32, 32, 32, 255});
  CHECK(first("P5 1 1 100\n\x32"sv) == Rgba8{128, 128, 128, 255});  // 50 * 255 / 100 = 127.5
  CHECK(first("P5 1 1 100\n\xff"sv) == Rgba8{255, 255, 255, 255});  // above the largest value
  CHECK(first("P5 1 1 65535\n\x80\x80"sv) == Rgba8{128, 128, 128, 255});
}

TEST_CASE("a PPM that is cut off or wrong is refused") {
  const std::string whole = text_of(encode_ppm(Image<Rgba8>(3, 2)));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size);
    CHECK_FALSE(decode_pnm(bytes_of(std::string_view(whole).substr(0, size))));
  }
  for (const auto text :
       {"P6 0 1 255\n", "P6 1 1 0\nabc", "P6 1 1 65536\nabcdef", "P6 -1 1 255\nabc",
        "P6 1 1 255x\nabc", "P8 1 1 255\n1 2 3", "P6 99999999999 1 255\nabc",
        "P6 4294967295 4294967295 255\nabc", "P6 16384 4096 255\nabc"}) {
    CAPTURE(text);
    CHECK_FALSE(decode_pnm(bytes_of(text)));
  }
}

TEST_CASE("a PFM has its rows bottom-up and its floats little-endian") {
  Image<float> image(1, 2);
  image.pixels = {1.0f, -2.0f};  // the top row first
  CHECK(text_of(encode_pfm(image)) == std::string("Pf\n1 2\n-1.0\n\0\0\0\xc0\0\0\x80\x3f", 20));
}

TEST_CASE("a PFM keeps every float, infinities and NaN included") {
  Image<float> image(3, 2);
  image.pixels = {0.0f, -0.0f, std::numeric_limits<float>::infinity(), 1e-45f, 0.1f, -3e38f};
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("depth.pfm");
  REQUIRE(write_file(path, encode_pfm(image)));
  const auto back = read_pfm(path);
  REQUIRE(back);
  CHECK(*back == image);
  CHECK(std::signbit(back->pixels[1]));
  image.pixels[0] = std::numeric_limits<float>::quiet_NaN();
  CHECK(std::isnan(decode_pfm(encode_pfm(image)).value().pixels[0]));

  Image<Rgb32f> colours(2, 3);
  for (std::size_t i = 0; i < 6; ++i) colours.pixels[i] = {float(i), float(i) / 3, -float(i)};
  CHECK(decode_pfm_rgb(encode_pfm(colours)).value() == colours);
  CHECK_FALSE(decode_pfm(encode_pfm(colours)));
  CHECK_FALSE(decode_pfm_rgb(encode_pfm(image)));
}

TEST_CASE("a big-endian PFM is read too") {
  CHECK(decode_pfm(bytes_of("Pf 1 1 1.0\n\x3f\x80\0\0"sv)).value().pixels[0] == 1.0f);
}

TEST_CASE("a PFM that is cut off or wrong is refused") {
  const std::string whole = text_of(encode_pfm(Image<float>(3, 2)));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size);
    CHECK_FALSE(decode_pfm(bytes_of(std::string_view(whole).substr(0, size))));
  }
  for (const auto text : {"Pf 1 1 0\nabcd", "Pf 1 1 nan\nabcd", "Pf 1 1 x\nabcd",
                          "P6 1 1 -1.0\nabcd", "Pf 16384 16384 -1\nabcd"}) {
    CAPTURE(text);
    CHECK_FALSE(decode_pfm(bytes_of(text)));
  }
}
