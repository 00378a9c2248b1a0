// Tests decode_plain_png against libpng: on generated files, and on files with faults.
#include "tests/support/catch.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <glassbox/base/random.h>
#include <glassbox/images/png_plain.h>
#include <glassbox/images/png_read.h>
#include <glassbox/images/read.h>

#include "tests/images/png_builder.h"

namespace {

using namespace glassbox;
using test::Bytes;

std::span<const std::byte> as_file(const Bytes& bytes) {
  return std::as_bytes(std::span(bytes));
}

// Returns the data as a zlib stream whose distances are at most 2^window_bits, 9 to 15.
Bytes deflated(Bytes data, int level, int window_bits = 15) {
  z_stream zlib{};
  REQUIRE(deflateInit2(&zlib, level, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  Bytes stream(deflateBound(&zlib, uLong(data.size())));
  zlib.next_in = data.data();
  zlib.avail_in = uInt(data.size());
  zlib.next_out = stream.data();
  zlib.avail_out = uInt(stream.size());
  REQUIRE(deflate(&zlib, Z_FINISH) == Z_STREAM_END);
  stream.resize(zlib.total_out);
  REQUIRE(deflateEnd(&zlib) == Z_OK);
  return stream;
}

// Makes the header of a zlib stream state a window of 2^window_bits bytes, 8 to 15. The header's
// two bytes are a multiple of 31 (RFC 1950).
void state_window(Bytes& stream, int window_bits) {
  stream[0] = std::uint8_t((window_bits - 8) << 4 | 8);
  stream[1] = std::uint8_t(stream[1] & 0xe0);
  stream[1] = std::uint8_t(stream[1] + 31 - (256 * stream[0] + stream[1]) % 31);
}

struct PlainFile {
  Bytes bytes;
  bool is_plain = false;  // by its kind
};

// The number of channels by IHDR's type of colour.
std::size_t channels_of(std::uint8_t type) {
  return type == 2 ? 3 : type == 4 ? 2 : type == 6 ? 4 : 1;
}

// Rows with any filters and any filtered bytes: all of them mean something.
Bytes random_rows(std::size_t width, std::size_t height, std::size_t bits, Random& random) {
  Bytes rows;
  for (std::size_t y = 0; y < height; ++y) {
    rows.push_back(std::uint8_t(random.integer(0, 4)));
    const bool is_flat = random.integer(0, 3) == 0;
    for (std::size_t i = 0; i < (width * bits + 7) / 8; ++i) {
      rows.push_back(is_flat ? 0 : std::uint8_t(random.bits()));
    }
  }
  return rows;
}

// A file of any kind, with chunks that may be skipped in all places, and data in several chunks.
PlainFile random_file(Random& random) {
  constexpr std::uint8_t kTypes[] = {0, 2, 3, 4, 6};
  constexpr std::uint8_t kDepths[] = {1, 2, 4, 8, 16};
  const std::uint8_t type = kTypes[random.integer(0, 4)];
  std::uint8_t depth = kDepths[random.integer(0, 4)];
  if (type == 3 && depth == 16) depth = 8;
  if (type != 0 && type != 3 && depth < 8) depth = 16;
  const bool has_transparency = type != 3 && type < 4 && random.integer(0, 5) == 0;
  const auto width = std::uint32_t(random.integer(1, 40));
  const auto height = std::uint32_t(random.integer(1, 30));
  Bytes png = test::png_signature(), header;
  test::put32(header, width);
  test::put32(header, height);
  for (const std::uint8_t byte : {depth, type, std::uint8_t(0), std::uint8_t(0), std::uint8_t(0)}) {
    header.push_back(byte);
  }
  test::put_chunk(png, "IHDR", header);
  const auto maybe_skipped = [&] {
    if (random.integer(0, 2) == 0) test::put_chunk(png, "prVt", Bytes(3, 7));
  };
  maybe_skipped();
  if (type == 3) test::put_chunk(png, "PLTE", Bytes(3 * 256 >> (8 - std::min<int>(depth, 8)), 9));
  Bytes transparent;  // the colour with the value 1 in each channel
  for (std::size_t i = 0; i < channels_of(type); ++i) {
    transparent.push_back(0);
    transparent.push_back(1);
  }
  if (has_transparency) test::put_chunk(png, "tRNS", transparent);
  maybe_skipped();
  const Bytes rows = random_rows(width, height, depth * channels_of(type), random);
  const Bytes data = deflated(rows, int(random.integer(0, 9)));
  const auto parts = std::size_t(random.integer(1, 4));
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t first = data.size() * part / parts, last = data.size() * (part + 1) / parts;
    test::put_chunk(
        png, "IDAT",
        Bytes(data.begin() + std::ptrdiff_t(first), data.begin() + std::ptrdiff_t(last)));
  }
  maybe_skipped();
  test::put_chunk(png, "IEND", {});
  if (random.integer(0, 4) == 0) png.push_back(1);  // behind the picture
  return {png, type != 3 && depth >= 8 && !has_transparency};
}

TEST_CASE("plain files are decoded as libpng decodes them, and other kinds are left to it") {
  Random random(71);
  int plain = 0;
  for (int round = 0; round < 1500; ++round) {
    INFO("seed 71, round " << round);
    const PlainFile file = random_file(random);
    const auto image = decode_plain_png(as_file(file.bytes), kCompareLimits);
    REQUIRE(image.has_value() == file.is_plain);
    const auto expected = decode_with_libpng(as_file(file.bytes), kCompareLimits);
    if (!expected) FAIL(expected.error().message());
    if (image) REQUIRE(*image == *expected);
    plain += image ? 1 : 0;
  }
  CHECK(plain > 500);
}

TEST_CASE("what is decoded of a file with faults, libpng decodes in the same way") {
  Random random(72);
  int decoded = 0, refused = 0;
  for (int round = 0; round < 6000; ++round) {
    INFO("seed 72, round " << round);
    PlainFile file = random_file(random);
    const auto place = std::size_t(random.integer(8, std::int64_t(file.bytes.size()) - 1));
    switch (random.integer(0, 3)) {
      case 0:
        file.bytes[place] ^= std::uint8_t(1 << random.integer(0, 7));
        break;
      case 1:
        file.bytes[place] = std::uint8_t(random.bits());
        break;
      case 2:
        file.bytes.resize(place);
        break;
      default:
        file.bytes.erase(file.bytes.begin() + std::ptrdiff_t(place));
        break;
    }
    const auto image = decode_plain_png(as_file(file.bytes), kCompareLimits);
    if (!image) {
      ++refused;
      continue;
    }
    ++decoded;
    const auto expected = decode_with_libpng(as_file(file.bytes), kCompareLimits);
    if (!expected) FAIL(expected.error().message());
    REQUIRE(*image == *expected);
  }
  // Faults in chunks that are skipped, or behind the picture, do no harm.
  CHECK(decoded > 20);
  CHECK(refused > 3000);
}

// Rows without a filter, of noise that is repeated from distances up to 32768 bytes.
Bytes repeating_rows(std::size_t width, std::size_t height, Random& random) {
  Bytes rows;
  while (rows.size() < (width + 1) * height) {
    const auto length = std::size_t(random.integer(4, 200));
    const std::int64_t longest = std::int64_t(1) << random.integer(1, 15);
    const auto distance = std::size_t(random.integer(1, longest));
    const bool repeats = distance <= rows.size() && random.integer(0, 3) > 0;
    for (std::size_t i = 0; i < length; ++i) {
      rows.push_back(repeats ? rows[rows.size() - distance] : std::uint8_t(random.bits()));
    }
  }
  rows.resize((width + 1) * height);
  for (std::size_t y = 0; y < height; ++y) rows[y * (width + 1)] = 0;
  return rows;
}

TEST_CASE("a window that zlib's header states too small is left to libpng to judge") {
  Random random(73);
  int plain = 0, small_and_plain = 0, refused = 0;
  for (int round = 0; round < 1500; ++round) {
    INFO("seed 73, round " << round);
    const auto width = std::uint32_t(random.integer(1, 300));
    const auto height = std::uint32_t(random.integer(1, 200));
    const Bytes rows = repeating_rows(width, height, random);
    const int level = int(random.integer(0, 9));
    Bytes data = deflated(rows, level, int(random.integer(9, 15)));
    const int stated = int(random.integer(8, 15));
    if (random.integer(0, 3) > 0) state_window(data, stated);
    const std::size_t window = std::size_t(256) << (data[0] >> 4);
    const Bytes file =
        test::build_png_of({.width = width, .height = height, .colour_type = 0}, data);
    const auto image = decode_plain_png(as_file(file), kCompareLimits);
    const auto expected = decode_with_libpng(as_file(file), kCompareLimits);
    REQUIRE(image.has_value() == (window >= std::min<std::size_t>(rows.size(), 32768)));
    if (image) {
      if (!expected) FAIL(expected.error().message());
      REQUIRE(*image == *expected);
    }
    plain += image ? 1 : 0;
    small_and_plain += image && window < 32768 ? 1 : 0;
    refused += expected ? 0 : 1;
  }
  CHECK(plain > 300);
  CHECK(small_and_plain > 100);
  CHECK(refused > 100);
}

TEST_CASE("a file whose window is too small for its data is refused, as libpng refuses it") {
  const auto file =
      read_file(GLASSBOX_SOURCE_DIR "/tests/fuzz/corpus/stored/found-small-window.png");
  REQUIRE(file);
  CHECK(!decode_plain_png(*file, kCompareLimits));
  CHECK(!decode_with_libpng(*file, kCompareLimits));
  CHECK(!decode_png_stored(*file, kCompareLimits));
}

TEST_CASE("limits and sizes that the file cannot have are left to libpng to refuse") {
  const Bytes one =
      test::build_png({.width = 3, .height = 1, .colour_type = 0, .rows = {0, 1, 2, 3}});
  CHECK(decode_plain_png(as_file(one), kCompareLimits));
  CHECK(!decode_plain_png(as_file(one), {.max_pixels = 2}));
  CHECK(!decode_plain_png(as_file(one), {.max_side = 2}));
  for (const std::uint32_t side : {0u, 1u << 13, 0x7fffffffu, 0xffffffffu}) {
    const Bytes file =
        test::build_png({.width = side, .height = side, .colour_type = 6, .rows = {0, 1, 2, 3}});
    CHECK(!decode_plain_png(as_file(file), kCompareLimits));
    CHECK(!decode_png_stored(as_file(file), kCompareLimits));
  }
}

}  // namespace
