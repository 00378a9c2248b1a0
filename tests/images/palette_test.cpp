// Tests PNG files with a palette: they mean the colours of their indices.
#include "tests/support/catch.h"

#include <filesystem>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/images/palette.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>

#include "tests/images/temporary_directory.h"

namespace {

using namespace glassbox;

std::vector<Rgba8> random_palette(std::size_t size, Random& random) {
  std::vector<Rgba8> palette(size);
  for (Rgba8& colour : palette) {
    const std::uint64_t bits = random.bits();
    colour = {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16), 255};
  }
  return palette;
}

TEST_CASE("a picture of indices is written as the colours that they mean, as PNG and PPM") {
  const test::TemporaryDirectory here;
  Random random(81);
  for (int round = 0; round < 40; ++round) {
    INFO("seed 81, round " << round);
    const auto palette = random_palette(std::size_t(random.integer(1, 256)), random);
    const int width = int(random.integer(1, 50));
    Image<std::uint8_t> indices(width, int(random.integer(1, 50)));
    for (auto& index : indices.pixels) {
      index = std::uint8_t(random.integer(0, std::int64_t(palette.size()) - 1));
    }
    for (const char* name : {"a.png", "a.ppm"}) {
      REQUIRE(write_image(here.file(name), indices, palette));
      const auto read = read_image(here.file(name));
      REQUIRE(read);
      CHECK(*read == coloured(indices, palette));
    }
    const auto png = read_file(here.file("a.png"));
    REQUIRE(png);
    constexpr std::size_t kColourType = 25;  // behind the signature, in IHDR
    CHECK((*png)[kColourType] == std::byte{3});
  }
}

TEST_CASE("a palette of more than 256 colours is an error, and nothing is written") {
  const test::TemporaryDirectory here;
  const Image<std::uint8_t> indices(2, 2, 255);
  for (const std::size_t size : {256u, 257u, 300u}) {
    for (const char* name : {"a.png", "a.ppm"}) {
      CAPTURE(name, size);
      const auto written = write_image(here.file(name), indices, std::vector<Rgba8>(size));
      CHECK(written.has_value() == (size == 256));
      CHECK(read_file(here.file(name)).has_value() == (size == 256));
      if (written) {
        std::filesystem::remove(here.file(name));
      } else {
        CHECK(written.error().file == here.file(name));
      }
    }
  }
}

TEST_CASE("an index without a colour is an error, and nothing is written") {
  const test::TemporaryDirectory here;
  const std::vector<Rgba8> palette(3);
  const Image<std::uint8_t> indices(2, 2, 3);
  for (const char* name : {"a.png", "a.ppm"}) {
    const auto written = write_image(here.file(name), indices, palette);
    REQUIRE(!written);
    CHECK(written.error().file == here.file(name));
    CHECK(!read_file(here.file(name)));
  }
}

}  // namespace
