// Compares the largest pictures that are accepted: 16384 x 16384.
#include "tests/support/catch.h"

#include <cstdint>
#include <string>
#include <vector>

#include <zlib.h>

#include "tests/app/working_directory.h"
#include "tests/images/png_builder.h"

namespace glassbox::test {
namespace {

constexpr std::uint32_t kSide = 16384;  // px

// Returns a grey PNG of 8 bits whose sample at (x, y) is 7 (x / 64 + y / 64), except the last one.
// It is compressed row by row with the filter that needs the fewest bytes.
std::string large_png(int last_sample) {
  Bytes header;
  put32(header, kSide);
  put32(header, kSide);
  header.insert(header.end(), {8, 0, 0, 0, 0});
  Bytes packed;
  Bytes block(1 << 16);
  z_stream stream{};
  REQUIRE(::deflateInit(&stream, 1) == Z_OK);
  Bytes above(kSide), filtered(1 + kSide);
  for (std::uint32_t y = 0; y < kSide; ++y) {
    filtered[0] = 2;  // the filter that stores the difference from the row above
    for (std::uint32_t x = 0; x < kSide; ++x) {
      auto sample = std::uint8_t(7 * (x / 64 + y / 64));
      if (x == kSide - 1 && y == kSide - 1) sample = std::uint8_t(last_sample);
      filtered[1 + x] = std::uint8_t(sample - above[x]);
      above[x] = sample;
    }
    stream.next_in = filtered.data();
    stream.avail_in = uInt(filtered.size());
    const int flush = y + 1 == kSide ? Z_FINISH : Z_NO_FLUSH;
    do {
      stream.next_out = block.data();
      stream.avail_out = uInt(block.size());
      REQUIRE(::deflate(&stream, flush) != Z_STREAM_ERROR);
      packed.insert(packed.end(), block.begin(), block.end() - stream.avail_out);
    } while (stream.avail_out == 0);
  }
  ::deflateEnd(&stream);
  Bytes png = png_signature();
  put_chunk(png, "IHDR", header);
  put_chunk(png, "IDAT", packed);
  put_chunk(png, "IEND", {});
  return {png.begin(), png.end()};
}

TEST_CASE("one wrong pixel in the last corner of 16384 x 16384 is found") {
  const WorkingDirectory here;
  here.write("a.png", large_png(100));
  here.write("b.png", large_png(100));
  here.write("c.png", large_png(101));
  const Outcome same = here.run("diff a.png b.png");
  CHECK(same.exit_code == 0);
  CHECK(same.out == "b.png: same\n");
  const Outcome wrong = here.run("diff a.png c.png");
  CHECK(wrong.exit_code == 1);
  CHECK(wrong.out ==
        "c.png: different: 1 of 268435456 pixels differ, by up to 1/255, in 1 region; first "
        "(16383, 16383): "
        "100 became 101\n");
}

}  // namespace
}  // namespace glassbox::test
