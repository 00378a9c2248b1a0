#include "tests/support/catch.h"

#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>

#include <glassbox/images/read.h>
#include <glassbox/images/stored_image.h>
#include <glassbox/images/write.h>

#include "tests/images/plain_builder.h"
#include "tests/images/stored_builder.h"
#include "tests/images/temporary_directory.h"
#include "tests/support/skip.h"

namespace {

using namespace glassbox;
using namespace std::string_literals;
using test::build_png;
using test::Bytes;
using test::random_stored;
using test::same_bits;
using test::stored;
using U8 = std::vector<std::uint8_t>;
using U16 = std::vector<std::uint16_t>;

StoredImage decode(const Bytes& bytes) {
  auto image = decode_stored(std::as_bytes(std::span(bytes)));
  if (!image) FAIL(image.error().message());
  return std::move(*image);
}
StoredImage decode(const std::string& text) {
  return decode(Bytes(text.begin(), text.end()));
}
StoredImage decode(const std::vector<std::byte>& bytes) {
  auto image = decode_stored(bytes);
  if (!image) FAIL(image.error().message());
  return std::move(*image);
}

StoredImage row8(int channels, U8 samples) {
  const int width = int(samples.size()) / channels;
  return stored(width, 1, channels, std::move(samples));
}
StoredImage row16(int channels, U16 samples) {
  const int width = int(samples.size()) / channels;
  return stored(width, 1, channels, std::move(samples));
}

Rgba8 rgba_of(const StoredImage& image, std::size_t pixel) {
  const auto sample = [&](int channel) {
    const std::size_t i = pixel * std::size_t(image.channels) + std::size_t(channel);
    if (const auto* wide = std::get_if<U16>(&image.samples)) {
      return std::uint8_t(std::lround((*wide)[i] * 255.0 / 65535.0));
    }
    return std::get<U8>(image.samples)[i];
  };
  const bool colour = image.channels >= 3, alpha = image.channels % 2 == 0;
  return {sample(0), sample(colour ? 1 : 0), sample(colour ? 2 : 0),
          alpha ? sample(image.channels - 1) : std::uint8_t(255)};
}

std::string corpus(const std::string& name) {
  return GLASSBOX_SOURCE_DIR "/tests/fuzz/corpus/stored/" + name;
}

}  // namespace

TEST_CASE("every colour type and depth of PNG decodes to the samples that it stores") {
  const auto grey = [](std::uint8_t depth, std::uint32_t width, Bytes row,
                       Bytes transparency = {}) {
    row.insert(row.begin(), 0);
    return decode(build_png({.width = width,
                             .bit_depth = depth,
                             .colour_type = 0,
                             .transparency = transparency,
                             .rows = row}));
  };
  CHECK(grey(1, 4, {0b10100000}) == row8(1, {255, 0, 255, 0}));
  CHECK(grey(2, 4, {0b00011011}) == row8(1, {0, 85, 170, 255}));
  CHECK(grey(4, 3, {0x07, 0xf0}) == row8(1, {0, 119, 255}));
  CHECK(grey(8, 3, {0, 77, 255}) == row8(1, {0, 77, 255}));
  CHECK(grey(16, 2, {0x12, 0x34, 0xff, 0xfe}) == row16(1, {0x1234, 0xfffe}));
  // tRNS names the one grey value that is transparent, at the file's depth.
  CHECK(grey(2, 4, {0b00011011}, {0, 2}) == row8(2, {0, 255, 85, 255, 170, 0, 255, 255}));
  CHECK(grey(8, 2, {7, 8}, {0, 8}) == row8(2, {7, 255, 8, 0}));
  CHECK(grey(16, 2, {1, 2, 1, 3}, {1, 2}) == row16(2, {0x102, 0, 0x103, 65535}));

  CHECK(decode(build_png({.colour_type = 4, .rows = {0, 77, 5}})) == row8(2, {77, 5}));
  CHECK(decode(build_png({.bit_depth = 16, .colour_type = 4, .rows = {0, 1, 2, 3, 4}})) ==
        row16(2, {0x102, 0x304}));
  CHECK(decode(build_png({.colour_type = 2, .rows = {0, 1, 2, 3}})) == row8(3, {1, 2, 3}));
  CHECK(decode(build_png({.bit_depth = 16, .colour_type = 2, .rows = {0, 1, 2, 3, 4, 5, 6}})) ==
        row16(3, {0x102, 0x304, 0x506}));
  CHECK(decode(build_png(
            {.colour_type = 2, .transparency = {0, 1, 0, 2, 0, 3}, .rows = {0, 1, 2, 3}})) ==
        row8(4, {1, 2, 3, 0}));
  CHECK(decode(build_png({.bit_depth = 16,
                          .colour_type = 2,
                          .transparency = {1, 2, 3, 4, 5, 7},
                          .rows = {0, 1, 2, 3, 4, 5, 6}})) ==
        row16(4, {0x102, 0x304, 0x506, 65535}));
  CHECK(decode(build_png({.colour_type = 6, .rows = {0, 1, 2, 3, 4}})) == row8(4, {1, 2, 3, 4}));
  CHECK(
      decode(build_png({.bit_depth = 16, .colour_type = 6, .rows = {0, 1, 2, 3, 4, 5, 6, 7, 8}})) ==
      row16(4, {0x102, 0x304, 0x506, 0x708}));
}

TEST_CASE("palettes of every depth become their colours, and tRNS their alpha") {
  const Bytes palette{1, 2, 3, 4, 5, 6, 7, 8, 9};
  const U8 rgb{4, 5, 6, 1, 2, 3, 7, 8, 9}, rgba{4, 5, 6, 128, 1, 2, 3, 0, 7, 8, 9, 255};
  struct Case {
    std::uint8_t depth;
    Bytes row;  // the colours 1, 0 and, if the depth allows it, 2
  };
  for (const auto& [depth, row] : {Case{1, {0, 0b10000000}}, Case{2, {0, 0b01001000}},
                                   Case{4, {0, 0x10, 0x20}}, Case{8, {0, 1, 0, 2}}}) {
    CAPTURE(int(depth));
    const std::uint32_t width = depth == 1 ? 2 : 3;
    const test::PngParts opaque{
        .width = width,
        .bit_depth = depth,
        .colour_type = 3,
        .palette = depth == 1 ? Bytes(palette.begin(), palette.begin() + 6) : palette,
        .rows = row};
    CHECK(decode(build_png(opaque)) == row8(3, U8(rgb.begin(), rgb.begin() + width * 3)));
    test::PngParts transparent = opaque;
    transparent.transparency = {0, 128};  // shorter than the palette: the other colours are opaque
    CHECK(decode(build_png(transparent)) == row8(4, U8(rgba.begin(), rgba.begin() + width * 4)));
  }
}

TEST_CASE("all 65536 values of 16 bits survive") {
  U16 values(65536);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::uint16_t(i);
  const StoredImage image = stored(256, 256, 1, values);
  CHECK(decode(encode_png(image).value()) == image);
}

TEST_CASE("gamma, primaries, profiles and significant bits change no sample") {
  test::PngParts parts{.colour_type = 2, .rows = {0, 1, 2, 3}};
  const auto chunk = [&](const char* type, const Bytes& data) {
    test::put_chunk(parts.extra, type, data);
  };
  chunk("gAMA", {0, 0, 0xb1, 0x8f});
  chunk("cHRM", Bytes(32, 1));
  chunk("sBIT", {5, 6, 5});
  chunk("sRGB", {0});
  chunk("iCCP", {'p', 0, 0, 'n', 'o', ' ', 'z', 'l', 'i', 'b'});
  chunk("bKGD", {0, 9, 0, 9, 0, 9});
  chunk("pHYs", Bytes(9, 1));
  chunk("tIME", {7, 233, 1, 1, 0, 0, 0});
  CHECK(decode(build_png(parts)) == row8(3, {1, 2, 3}));
}

TEST_CASE("every format and channel count of PNG gives back what it was made of") {
  const std::uint64_t seed = 41;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 40; ++round) {
    const int width = int(random.integer(1, 40)), height = int(random.integer(1, 20));
    for (int channels = 1; channels <= 4; ++channels) {
      for (const StoredImage& image :
           {random_stored<std::uint8_t>(width, height, channels, random),
            random_stored<std::uint16_t>(width, height, channels, random)}) {
        CAPTURE(width, height, channels, format_name(image));
        const auto png = encode_png(image);
        REQUIRE(png);
        REQUIRE(decode(*png) == image);
        // Read as RGBA, it is the same picture: grey is repeated, a missing alpha is 255, and
        // samples are rounded to 8 bits.
        const auto rgba = decode_image(*png);
        REQUIRE(rgba);
        for (std::size_t i = 0; i < image.pixels(); ++i) {
          if (rgba->pixels[i] != rgba_of(image, i)) FAIL("pixel " << i);
        }
      }
    }
  }
}

TEST_CASE("a PNG decodes the same interlaced and not, without libpng's writer") {
  const std::uint64_t seed = 43;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 60; ++round) {
    const int width = int(random.integer(1, 19)), height = int(random.integer(1, 19));
    const int channels = int(random.integer(1, 4));
    for (const StoredImage& image :
         {random_stored<std::uint8_t>(width, height, channels, random),
          random_stored<std::uint16_t>(width, height, channels, random)}) {
      CAPTURE(width, height, channels, format_name(image));
      REQUIRE(decode(test::build_stored_png(image, false)) == image);
      REQUIRE(decode(test::build_stored_png(image, true)) == image);
    }
  }
}

TEST_CASE("the PNG suite's interlaced files are the same pictures as its others") {
  const std::filesystem::path root =
      std::filesystem::path(GLASSBOX_ASSETS_DIR) / "malformed/pngsuite";
  if (!std::filesystem::is_directory(root)) SKIP_TEST("no assets at " << root.string());
  int pairs = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("basi")) continue;
    const auto other = entry.path().parent_path() / ("basn" + name.substr(4));
    if (!std::filesystem::exists(other)) continue;
    CAPTURE(name);
    const auto image = read_stored(entry.path().string());
    REQUIRE(image);
    CHECK(read_stored(other.string()).value() == *image);
    ++pairs;
  }
  CHECK(pairs > 0);
}

TEST_CASE("PGM and PPM keep 8 and 16 bits, and bring other largest values to the nearest") {
  CHECK(decode("P5 3 1 255\n\x00\x07\xff"s) == row8(1, {0, 7, 255}));
  CHECK(decode("P6 1 1 255\n\x01\x02\x03"s) == row8(3, {1, 2, 3}));
  CHECK(decode("P5 2 1 65535\n\x12\x34\xff\xfe"s) == row16(1, {0x1234, 0xfffe}));
  CHECK(decode("P6 1 1 65535\n\x01\x02\x03\x04\x05\x06"s) == row16(3, {0x102, 0x304, 0x506}));
  CHECK(decode("P5 3 1 1\n\x00\x01\x02"s) == row8(1, {0, 255, 255}));  // above the largest value
  CHECK(decode("P5 1 1 100\n\x32"s) == row8(1, {128}));                // 127.5
  // Scaled from 1000 to 65535, 1 becomes 65.535, 500 becomes 32767.5 and 999 becomes 65469.465.
  CHECK(decode("P5 5 1 1000\n\x00\x00\x00\x01\x01\xf4\x03\xe7\x03\xe8"s) ==
        row16(1, {0, 66, 32768, 65469, 65535}));
  CHECK(decode("P5 2 1 256\n\x00\x80\xff\xff"s) == row16(1, {32768, 65535}));
}

TEST_CASE("a PFM keeps the bits of its floats, in both byte orders") {
  // The bits of quiet and signalling NaNs with payloads, infinities, -0, and the smallest and
  // largest numbers.
  const std::vector<std::uint32_t> bits{0x7fc12345, 0xffc00001, 0x7f812345, 0xff800001,
                                        0x7f800000, 0xff800000, 0x80000000, 0x00000001,
                                        0x7f7fffff, 0x3f800000, 0x00000000, 0x807fffff};
  for (const int channels : {1, 3}) {
    for (const bool little : {true, false}) {
      CAPTURE(channels, little);
      const int width = 2, height = int(bits.size()) / channels / width;
      std::vector<float> samples(bits.size());
      std::memcpy(samples.data(), bits.data(), bits.size() * sizeof(float));
      const StoredImage image = stored(width, height, channels, samples);

      std::string file = (channels == 1 ? "Pf\n" : "PF\n") + std::to_string(width) + " " +
                         std::to_string(height) + (little ? "\n-1.0\n" : "\n1.0\n");
      const std::size_t row = std::size_t(width * channels);
      for (std::size_t y = std::size_t(height); y-- > 0;) {  // the last row first
        for (std::size_t i = y * row; i < (y + 1) * row; ++i) {
          for (int k = 0; k < 4; ++k) file += char(bits[i] >> 8 * (little ? k : 3 - k));
        }
      }
      CHECK(same_bits(decode(file), image));
      CHECK(same_bits(decode(encode_pfm(image).value()), image));
    }
  }
}

TEST_CASE("random floats of any bits survive a PFM") {
  const std::uint64_t seed = 47;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 100; ++round) {
    const int width = int(random.integer(1, 20)), height = int(random.integer(1, 20));
    for (const int channels : {1, 3}) {
      const StoredImage image = random_stored<float>(width, height, channels, random);
      REQUIRE(same_bits(decode(encode_pfm(image).value()), image));
    }
  }
}

TEST_CASE("a JPEG has the channels of its file: grey stays grey") {
  const struct {
    const char* name;
    int channels;
  } files[] = {{"grey.jpg", 1}, {"rgb-subsampled.jpg", 3}, {"progressive.jpg", 3}, {"cmyk.jpg", 3}};
  for (const auto& [name, channels] : files) {
    CAPTURE(name);
    const auto image = read_stored(corpus(name));
    REQUIRE(image);
    CHECK(image->width == 9);
    CHECK(image->height == 7);
    CHECK(image->channels == channels);
    const auto rgba = read_image(corpus(name)).value();
    for (std::size_t i = 0; i < image->pixels(); ++i) CHECK(rgba.pixels[i] == rgba_of(*image, i));
  }
}

TEST_CASE("BMP decodes with rows from either end, palettes, and alpha where it has any") {
  // Bytes in the order blue, green, red; rows padded to four bytes, the lowest row first.
  const Bytes rows{3, 2, 1, 6, 5, 4, 0, 0, 9, 8, 7, 12, 11, 10, 0, 0};
  CHECK(decode(test::build_bmp(2, 2, 24, rows)) ==
        stored<std::uint8_t>(2, 2, 3, {7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6}));
  CHECK(decode(test::build_bmp(2, std::uint32_t(-2), 24, rows)) ==
        stored<std::uint8_t>(2, 2, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  CHECK(decode(test::build_bmp(1, 1, 32, {3, 2, 1, 4})) == row8(4, {1, 2, 3, 4}));
  const Bytes palette{3, 2, 1, 0, 6, 5, 4, 0};
  CHECK(decode(test::build_bmp(3, 1, 1, {0b01000000, 0, 0, 0}, palette)) ==
        row8(3, {1, 2, 3, 4, 5, 6, 1, 2, 3}));
  CHECK(decode(test::build_bmp(3, 1, 4, {0x10, 0x10, 0, 0}, palette)) ==
        row8(3, {4, 5, 6, 1, 2, 3, 4, 5, 6}));
  CHECK(decode(test::build_bmp(3, 1, 8, {1, 1, 0, 0}, palette)) ==
        row8(3, {4, 5, 6, 4, 5, 6, 1, 2, 3}));
}

TEST_CASE("TGA decodes grey, colour, palettes and alpha, packed and not") {
  CHECK(decode(test::build_tga(3, 2, 1, 8, {7, 9})) == row8(1, {7, 9}));
  CHECK(decode(test::build_tga(2, 1, 2, 24, {3, 2, 1, 6, 5, 4})) ==  // the lowest row first
        stored<std::uint8_t>(1, 2, 3, {4, 5, 6, 1, 2, 3}));
  CHECK(decode(test::build_tga(2, 1, 1, 32, {3, 2, 1, 4})) == row8(4, {1, 2, 3, 4}));
  CHECK(decode(test::build_tga(1, 2, 1, 8, {1, 0}, {3, 2, 1, 6, 5, 4})) ==
        row8(3, {4, 5, 6, 1, 2, 3}));
  CHECK(decode(test::build_tga(10, 5, 1, 24, {0x82, 3, 2, 1, 0x01, 6, 5, 4, 9, 8, 7})) ==
        row8(3, {1, 2, 3, 1, 2, 3, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  CHECK(decode(test::build_tga(11, 3, 1, 8, {0x81, 7, 0x00, 9})) == row8(1, {7, 7, 9}));
}

TEST_CASE("an image in memory as stored is what its file decodes to") {
  const std::uint64_t seed = 53;
  CAPTURE(seed);
  Random random(seed);
  Image<Rgba8> image(7, 5);
  for (Rgba8& pixel : image.pixels) pixel = {std::uint8_t(random.bits()), 2, 3, 255};
  CHECK(as_stored(image).channels == 3);
  CHECK(decode(encode_png(image).value()) == as_stored(image));
  CHECK(encode_png(image).value() == encode_png(as_stored(image)).value());
  image.at(6, 4).a = 254;
  CHECK(as_stored(image).channels == 4);
  CHECK(decode(encode_png(image).value()) == as_stored(image));
  CHECK(encode_png(image).value() == encode_png(as_stored(image)).value());

  const float nan = std::bit_cast<float>(0x7fc0beefu);
  Image<float> depth(3, 2, -0.0f);
  depth.at(1, 1) = nan;
  CHECK(as_stored(depth).channels == 1);
  CHECK(same_bits(decode(encode_pfm(depth)), as_stored(depth)));
  Image<Rgb32f> light(2, 3, {1, nan, -0.0f});
  light.at(1, 2).g = std::numeric_limits<float>::infinity();
  CHECK(as_stored(light).channels == 3);
  CHECK(same_bits(decode(encode_pfm(light)), as_stored(light)));
}

TEST_CASE("formats and channels have names") {
  const StoredImage grey = row8(1, {0}), two = row16(2, {0, 0});
  CHECK(format_name(grey) == "8 bits");
  CHECK(format_name(two) == "16 bits");
  CHECK(format_name(stored<float>(1, 1, 3, {0, 0, 0})) == "32-bit floats");
  CHECK(channel_names(grey) == "grey");
  CHECK(channel_names(two) == "grey and alpha");
  CHECK(channel_names(row8(3, {0, 0, 0})) == "RGB");
  CHECK(channel_names(row8(4, {0, 0, 0, 0})) == "RGBA");
}

TEST_CASE("what a PNG or a PFM cannot hold is refused with what can") {
  const StoredImage floats = stored<float>(1, 1, 1, {0});
  CHECK(encode_png(floats).error().message() ==
        "an image of floats cannot be a PNG; write a PFM (in the library: encode_pfm)");
  CHECK(encode_pfm(row8(3, {0, 0, 0})).error().message() ==
        "RGB of 8 bits cannot be a PFM, which has 1 or 3 channels of floats; write a PNG instead");
  CHECK_FALSE(encode_pfm(stored<float>(1, 1, 2, {0, 0})));
  CHECK_FALSE(encode_pfm(stored<float>(2, 1, 1, {0})));
  CHECK_FALSE(encode_png(stored<std::uint8_t>(2, 1, 1, {0})));  // a sample is missing
  CHECK_FALSE(encode_png(stored<std::uint8_t>(1, 1, 5, U8(5))));
  CHECK_FALSE(encode_png(stored<std::uint8_t>(1, 1, 0, {})));
  CHECK_FALSE(encode_png(stored<std::uint8_t>(0, 0, 1, {})));
  CHECK_FALSE(encode_png(stored<std::uint8_t>(-1, -1, 1, {0})));
}

TEST_CASE("reading an image as stored names the file that it refuses") {
  const test::TemporaryDirectory directory;
  const std::string missing = directory.file("missing.png");
  CHECK(read_stored(missing).error().file == missing);
  CHECK(read_stored(directory.path().string()).error().cause == "is a directory");
  const auto limited = read_stored(corpus("grey.tga"), {.max_pixels = 5});
  REQUIRE_FALSE(limited);
  CHECK(limited.error().file == corpus("grey.tga"));
  CHECK(limited.error().cause == "the image has 3 x 2 pixels, but may have at most 5 in all");
  CHECK(read_stored(corpus("options.txt")).error().cause ==
        "not a PNG, JPEG, BMP, TGA, PBM, PGM, PPM, PAM, PFM, Radiance HDR or OpenEXR image");
}
