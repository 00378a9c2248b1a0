// OpenEXR files that are built byte by byte.
#include "tests/support/catch.h"

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/images/decode.h>
#include <glassbox/images/stored_file.h>

#include "tests/images/exr_builder.h"
#include "tests/images/stored_builder.h"

namespace {

using namespace glassbox;
using test::build_exr;
using test::Bytes;
using test::ExrParts;

// Reads the file. Its picture is the one that is read without the further channels.
Result<StoredFile> read(const Bytes& bytes) {
  const auto file = decode_stored_file(std::as_bytes(std::span(bytes)));
  const auto image = decode_stored(std::as_bytes(std::span(bytes)));
  REQUIRE(file.has_value() == image.has_value());
  if (file) REQUIRE(test::same_bits(file->image, *image));
  return file;
}

// The value of a half by its definition (IEEE 754, binary16).
float value_of_half(unsigned half) {
  const int exponent = int(half >> 10 & 31), fraction = int(half & 1023);
  const float size = exponent == 0 ? std::ldexp(float(fraction), -24)
                                   : std::ldexp(float(1024 + fraction), exponent - 25);
  return half & 0x8000u ? -size : size;
}

}  // namespace

TEST_CASE("every half is the float of its value, and NaNs keep their payloads") {
  ExrParts parts{.data = {0, 0, 255, 255}, .display = {0, 0, 255, 255}, .rows = {}};
  for (unsigned y = 0; y < 256; ++y) {
    Bytes& row = parts.rows.emplace_back();
    for (unsigned x = 0; x < 256; ++x) test::put_number(row, y << 8 | x, 2);
  }
  const auto file = read(build_exr(parts)).value();
  const auto& samples = std::get<std::vector<float>>(file.image.samples);
  REQUIRE(samples.size() == 65536);
  int wrong = 0;
  for (unsigned half = 0; half < 65536; ++half) {
    const auto bits = std::bit_cast<std::uint32_t>(samples[half]);
    const bool is_special = (half >> 10 & 31) == 31;
    const std::uint32_t special = (half & 0x8000u) << 16 | 0x7f800000u | (half & 0x3ffu) << 13;
    const auto expected = is_special ? special : std::bit_cast<std::uint32_t>(value_of_half(half));
    wrong += bits != expected ? 1 : 0;
  }
  CHECK(wrong == 0);
}

TEST_CASE("floats keep all their bits") {
  const std::uint64_t seed = 401;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 100; ++round) {
    const int width = int(random.integer(1, 40)), height = int(random.integer(1, 40));
    const StoredImage image = test::random_stored<float>(width, height, 3, random);
    const auto& samples = std::get<std::vector<float>>(image.samples);
    const auto right = std::uint32_t(width - 1), bottom = std::uint32_t(height - 1);
    // The samples are in the order of the names, whatever the order in the header.
    ExrParts parts{.channels = {{"R", 2}, {"G", 2}, {"B", 2}},
                   .data = {0, 0, right, bottom},
                   .display = {0, 0, right, bottom},
                   .rows = {}};
    for (std::size_t y = 0; y < std::size_t(height); ++y) {
      Bytes& row = parts.rows.emplace_back();
      for (const std::size_t channel : {2u, 1u, 0u}) {
        for (std::size_t x = 0; x < std::size_t(width); ++x) {
          const float sample = samples[3 * (y * std::size_t(width) + x) + channel];
          test::put_number(row, std::bit_cast<std::uint32_t>(sample), 4);
        }
      }
    }
    const Bytes file = build_exr(parts);
    const auto decoded = read(file).value();
    CHECK(test::same_bits(decoded.image, image));
    CHECK(decoded.rest.empty());
    const auto header = stored_header(std::as_bytes(std::span(file))).value();
    CHECK(header.width == width);
    CHECK(header.height == height);
    CHECK(header.channels == 3);
  }
}

TEST_CASE("the picture is made of R, G, B and A, of Y and A, or of the only channel") {
  const auto channels_of = [](const std::vector<std::string>& names) {
    ExrParts parts{.channels = {}, .rows = {{}}};
    for (const std::string& name : names) {
      parts.channels.push_back({name});
      test::put_number(parts.rows[0], 0x3c00 + parts.channels.size(), 2);
    }
    const auto file = read(build_exr(parts));
    return file ? std::pair(file->image.channels, file->rest_name) : std::pair(0, std::string());
  };
  using Found = std::pair<int, std::string>;
  CHECK(channels_of({"B", "G", "R"}) == Found(3, ""));
  CHECK(channels_of({"A", "B", "G", "R"}) == Found(4, ""));
  CHECK(channels_of({"A", "B", "G", "R", "Z"}) == Found(4, "1 further channel"));
  CHECK(channels_of({"B", "G", "N.X", "N.Y", "R"}) == Found(3, "2 further channels"));
  CHECK(channels_of({"Y"}) == Found(1, ""));
  CHECK(channels_of({"A", "Y"}) == Found(2, ""));
  CHECK(channels_of({"Y", "Z"}) == Found(1, "1 further channel"));
  CHECK(channels_of({"depth"}) == Found(1, ""));
  CHECK(channels_of({"A"}) == Found(1, ""));
  CHECK(channels_of({"G", "R"}) == Found(0, ""));
  CHECK(channels_of({"A", "Z"}) == Found(0, ""));
  CHECK(channels_of({"L.B", "L.G", "L.R"}) == Found(0, ""));
  CHECK(channels_of({"Y", "Y"}) == Found(0, ""));
}

TEST_CASE(
    "a change of a further channel or of the window is kept, and leaves the picture as it is") {
  const ExrParts plain{.channels = {{"Y"}, {"Z", 2}}, .rows = {{0, 0x3c, 1, 2, 3, 4}}};
  const StoredFile file = read(build_exr(plain)).value();
  CHECK(std::get<std::vector<float>>(file.image.samples) == std::vector<float>{1});
  CHECK(file.rest == read(build_exr(plain)).value().rest);
  constexpr int kChanges = 6;
  const auto changed = [&](int change) {
    ExrParts parts = plain;
    if (change == 0) parts.rows[0][3] = 9;
    if (change == 1) parts.channels[1].name = "depth";
    if (change == 2) parts.channels[1].type = 0;
    if (change == 3) parts.display = {0, 0, 1, 0};
    if (change == 4) parts.data = {1, 0, 1, 0};
    if (change == 5) parts.data = {0, std::uint32_t(-7), 0, std::uint32_t(-7)};
    return read(build_exr(parts)).value();
  };
  for (int change = 0; change < kChanges; ++change) {
    CAPTURE(change);
    const StoredFile other = changed(change);
    CHECK(other.image == file.image);
    CHECK(other.rest != file.rest);
  }
  // Windows that were moved together show the same.
  ExrParts moved = plain;
  moved.data = moved.display = {5, 6, 5, 6};
  CHECK(read(build_exr(moved)).value().rest == file.rest);
  moved.display = {3, 2, 12, 11};
  CHECK(read(build_exr(moved)).value().rest_name ==
        "1 further channel and a data window at (2, 4) of a display window of 10 x 10 pixels");
}

TEST_CASE("a display window may reach as far as in OpenEXR's library") {
  CHECK(read(build_exr({.display = {0, 0, 0x3ffffffe, 0}})));
  CHECK(read(build_exr({.display = {0xc0000002, 0xc0000002, 0, 0}})));
}

TEST_CASE("what is not read is refused by its name") {
  const Bytes two_levels{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const struct {
    ExrParts parts;
    const char* cause;
  } files[] = {
      {{.version = 0x802}, "OpenEXR with deep pixels, which is not read"},
      {{.version = 0x1002}, "OpenEXR with several parts, which is not read"},
      {{.channels = {{"Y", 1, 0, 2, 1}}},
       "OpenEXR with channels of a lower resolution, which is not read"},
      {{.compression = 8}, "OpenEXR with DWA compression, which is not read"},
      {{.compression = 9}, "OpenEXR with DWA compression, which is not read"},
      {{.compression = 10}, "OpenEXR with an unknown compression, which is not read"},
      {{.channels = {{"Y", 1, 1}}, .compression = 6},
       "OpenEXR with B44 compression of logarithms, which is not read"},
      {{.version = 0x202, .tiles = two_levels},
       "OpenEXR with several levels of detail, which is not read"},
      {{.channels = {{"Y", 0}}}, "OpenEXR with a picture of 32-bit integers, which is not read"},
      {{.channels = {{"N.X"}, {"N.Y"}}}, "OpenEXR without channels named R, G and B, or Y"},
      {{.version = 3}, "not a valid OpenEXR image: its header is cut off or broken"},
      {{.version = 0x202}, "not a valid OpenEXR image: its header is cut off or broken"},
      {{.channels = {}}, "not a valid OpenEXR image: its header is cut off or broken"},
      {{.channels = {{"Y", 3}}}, "not a valid OpenEXR image: its header is cut off or broken"},
      {{.data = {1, 0, 0, 0}}, "the image has 0 x 1 pixels"},
      {{.data = {0x7fffffff, 0, 0x7fffffff, 0}},
       "not a valid OpenEXR image: its header is cut off or broken"},
      {{.display = {1, 0, 0, 0}}, "not a valid OpenEXR image: its header is cut off or broken"},
      {{.display = {0, 2, 0, 1}}, "not a valid OpenEXR image: its header is cut off or broken"},
      {{.display = {0, 0, 0x7fffffff, 0}},
       "not a valid OpenEXR image: its header is cut off or broken"},
      {{.display = {0x80000000, 0, 0, 0}},
       "not a valid OpenEXR image: its header is cut off or broken"},
      {{.display = {0, 0, 0x3fffffff, 0}},
       "not a valid OpenEXR image: its header is cut off or broken"},
      {{.display = {0, 0xc0000001, 0, 0}},
       "not a valid OpenEXR image: its header is cut off or broken"},
      {{.rows = {{0}}},
       "not a valid OpenEXR image: the samples from pixel (0, 0) on are cut off or broken"},
  };
  for (const auto& [parts, cause] : files) {
    const Bytes bytes = build_exr(parts);
    const auto file = read(bytes);
    CAPTURE(cause);
    REQUIRE_FALSE(file);
    CHECK(file.error().cause == cause);
    CHECK_FALSE(file.error().remedy.empty());
    CHECK_FALSE(decode_stored(std::as_bytes(std::span(bytes))));
    CHECK_FALSE(decode_image(std::as_bytes(std::span(bytes))));
  }
}

TEST_CASE("more samples than so short a file can hold are refused before they have memory") {
  // As many pixels would fit if they had one half each, and not if they have 40 channels.
  ExrParts parts{.channels = {}, .data = {0, 0, 999, 999}, .display = {0, 0, 999, 999}};
  for (int i = 0; i < 40; ++i) parts.channels.push_back({"c" + std::to_string(i), 2});
  parts.channels.push_back({"Y"});
  parts.rows = {Bytes(3000)};
  const auto file = read(build_exr(parts));
  REQUIRE_FALSE(file);
  CHECK(file.error().cause.find("1000 x 1000 pixels of 162 bytes cannot fit") != std::string::npos);
}

TEST_CASE("all samples together have at most sixteen bytes for each pixel that the limits allow") {
  const std::uint64_t seed = 402;
  CAPTURE(seed);
  Random random(seed);
  int refused = 0;
  for (int round = 0; round < 1000; ++round) {
    CAPTURE(round);
    const auto width = std::uint32_t(random.integer(1, 6));
    const auto height = std::uint32_t(random.integer(1, 6));
    const std::vector<std::uint32_t> window{0, 0, width - 1, height - 1};
    ExrParts parts{.channels = {{"Y"}}, .data = window, .display = window, .rows = {}};
    std::uint64_t pixel_bytes = 2;
    for (std::int64_t more = random.integer(0, 19); more > 0; --more) {
      const auto type = std::uint32_t(random.integer(0, 2));
      parts.channels.push_back({"c" + std::to_string(more), type});
      pixel_bytes += type == 1 ? 2 : 4;
    }
    for (std::uint32_t y = 0; y < height; ++y) parts.rows.emplace_back(width * pixel_bytes);
    const Bytes bytes = build_exr(parts);
    const std::uint64_t pixels = std::uint64_t(width) * height;
    const auto most = pixels + std::uint64_t(random.integer(0, std::int64_t(3 * pixels)));
    const auto file =
        decode_stored_file(std::as_bytes(std::span(bytes)), DecodeLimits{.max_pixels = most});
    REQUIRE(file.has_value() == (pixels * pixel_bytes <= 16 * most));
    if (file) continue;
    ++refused;
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    REQUIRE(file.error().cause == "the image has " + size + " of " + std::to_string(pixel_bytes) +
                                      " bytes in " + std::to_string(parts.channels.size()) +
                                      " channels, but all samples may have at most " +
                                      std::to_string(16 * most) + " bytes");
    REQUIRE_FALSE(file.error().remedy.empty());
  }
  CHECK(refused > 100);
  CHECK(refused < 900);
}
