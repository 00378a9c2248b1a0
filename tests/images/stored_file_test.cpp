// The frames of an animated PNG are known, and kept for the comparison.
#include "tests/support/catch.h"

#include <string>

#include <glassbox/images/stored_file.h>

#include "tests/images/moving_png.h"

namespace {

using namespace glassbox;
using test::Bytes;

StoredFile file_of(const Bytes& png) {
  return decode_stored_file(std::as_bytes(std::span(png))).value();
}

}  // namespace

TEST_CASE("an animated PNG is its first frame, and the bytes of the others are kept") {
  const StoredFile three = file_of(test::moving_png({10, 20, 30}));
  CHECK(three.image == StoredImage{1, 1, 1, std::vector<std::uint8_t>{10}});
  CHECK(three.rest_name == "2 further frames");
  CHECK(three.rest == file_of(test::moving_png({10, 20, 30})).rest);
  CHECK(three.rest == file_of(test::moving_png({11, 20, 30})).rest);
  CHECK(three.rest != file_of(test::moving_png({10, 20, 31})).rest);
  CHECK(three.rest != file_of(test::moving_png({10, 20})).rest);
  CHECK(file_of(test::moving_png({10, 20})).rest_name == "1 further frame");
}

TEST_CASE("a PNG of one frame has nothing besides its picture") {
  CHECK(file_of(test::moving_png({10})).rest.empty());
  CHECK(file_of(test::build_png({.colour_type = 0, .rows = {0, 7}})).rest.empty());
  // A control chunk of the wrong length is none.
  test::PngParts parts{.colour_type = 0, .rows = {0, 7}};
  test::put_chunk(parts.extra, "acTL", {0, 0, 0, 2});
  CHECK(file_of(test::build_png(parts)).rest.empty());
}
