// Tests which pixels a comparison leaves out.
#include "tests/support/catch.h"

#include <limits>
#include <string>
#include <vector>

#include "tests/compare/pictures.h"
#include "tests/images/temporary_directory.h"

#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pixels/selection.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::test {
namespace {

constexpr int kMost = std::numeric_limits<int>::max();

TEST_CASE("a box is four whole numbers, the size above zero") {
  CHECK(parse_pixel_box("10,20,64x32") == PixelBox{10, 20, 64, 32});
  CHECK(parse_pixel_box("-3,-4,5x6") == PixelBox{-3, -4, 5, 6});
  CHECK(parse_pixel_box("0,0,2147483647x1") == PixelBox{0, 0, kMost, 1});
  for (const char* text : {"",
                           "1",
                           "1,2",
                           "1,2,3",
                           "1,2,3x",
                           "1,2,3x4x",
                           "1,2,3x4,5",
                           "1,2,0x4",
                           "1,2,3x0",
                           "1,2,-3x4",
                           "1,2,3x-4",
                           "a,2,3x4",
                           "1.5,2,3x4",
                           " 1,2,3x4",
                           "1,2,3x4 ",
                           "1 ,2,3x4",
                           "1,2,3X4",
                           "1;2;3x4",
                           "1,2,3,4",
                           "+1,2,3x4",
                           "2147483648,0,1x1",
                           "0,0,99999999999x1"}) {
    INFO(text);
    const auto box = parse_pixel_box(text);
    REQUIRE(!box);
    CHECK(box.error().cause.find("not a box of pixels") == 0);
  }
  const auto hostile = parse_pixel_box("1\n2\x1b" + std::string(10000, 'x'));
  REQUIRE(!hostile);
  CHECK(hostile.error().message().find_first_of("\n\x1b") == std::string::npos);
  CHECK(hostile.error().message().size() < 500);
}

TEST_CASE("a box survives being written") {
  const PixelBox box{-7, 12, 1, 16384};
  CHECK(to_string(box) == "-7,12,1x16384");
  CHECK(parse_pixel_box(to_string(box)) == box);
}

TEST_CASE("everything is compared until something is left out") {
  Selection selection(7, 5);
  CHECK(selection.includes_all());
  CHECK(selection.compared_pixels() == 35);
  REQUIRE(selection.exclude(PixelBox{2, 1, 3, 2}));
  CHECK(!selection.includes_all());
  CHECK(selection.compared_pixels() == 29);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 7; ++x) {
      CHECK(selection.compares(x, y) == !(x >= 2 && x < 5 && y >= 1 && y < 3));
    }
  }
}

TEST_CASE("boxes that overlap count a pixel once") {
  Selection selection(10, 10);
  REQUIRE(selection.exclude(PixelBox{0, 0, 5, 5}));
  REQUIRE(selection.exclude(PixelBox{3, 3, 5, 5}));
  REQUIRE(selection.exclude(PixelBox{0, 0, 5, 5}));
  CHECK(selection.compared_pixels() == 100 - 25 - 25 + 4);
}

TEST_CASE("a box may hang over the edge of the picture") {
  for (const PixelBox& box : {PixelBox{-4, -4, 6, 6}, PixelBox{-4, -4, kMost, 6},
                              PixelBox{std::numeric_limits<int>::min(), 0, kMost, 1}}) {
    Selection selection(10, 10);
    const bool touches = box.x + std::int64_t(box.width) > 0;
    CHECK(bool(selection.exclude(box)) == touches);
  }
  Selection selection(10, 10);
  REQUIRE(selection.exclude(PixelBox{8, 9, kMost, kMost}));
  CHECK(selection.compared_pixels() == 98);
  CHECK(!selection.compares(8, 9));
  CHECK(!selection.compares(9, 9));
  REQUIRE(selection.exclude(PixelBox{-4, -4, 6, 6}));
  CHECK(selection.compared_pixels() == 94);
}

TEST_CASE("a box beside the picture is a slip and refused") {
  for (const PixelBox& box : {PixelBox{10, 0, 1, 1}, PixelBox{0, 5, 1, 1}, PixelBox{-3, 0, 3, 3},
                              PixelBox{0, -3, 3, 3}, PixelBox{kMost, kMost, kMost, kMost}}) {
    Selection selection(10, 5);
    const auto done = selection.exclude(box);
    INFO(to_string(box));
    REQUIRE(!done);
    CHECK(done.error().message().find(to_string(box)) != std::string::npos);
    CHECK(done.error().message().find("10 x 5") != std::string::npos);
    CHECK(selection.includes_all());
    CHECK(selection.compared_pixels() == 50);
  }
}

TEST_CASE(
    "the black pixels of a mask are left out, whatever its format, and alpha is not looked at") {
  for (const Format format : kFormats) {
    for (int channels = 1; channels <= 4; ++channels) {
      const bool has_alpha = channels % 2 == 0;
      StoredImage mask = blank(4, 3, channels, format);
      for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
          // A different alpha alone makes a pixel neither white nor black.
          if (has_alpha) set_sample(mask, x, y, channels - 1, (x + y) % 2);
        }
      }
      const int last_colour = channels - (has_alpha ? 2 : 1);
      set_sample(mask, 1, 2, last_colour, 1);
      set_sample(mask, 3, 0, 0, 1);
      Selection selection(4, 3);
      REQUIRE(selection.exclude_black(mask));
      INFO(channels << " channels of " << name_of(format));
      CHECK(selection.compared_pixels() == 2);
      CHECK(selection.compares(1, 2));
      CHECK(selection.compares(3, 0));
    }
  }
}

TEST_CASE("a mask without black leaves out nothing") {
  StoredImage mask = blank(2, 2, 1, Format::kBytes);
  for (int i = 0; i < 4; ++i) set_sample(mask, i % 2, i / 2, 0, 1);
  Selection selection(2, 2);
  REQUIRE(selection.exclude_black(mask));
  CHECK(selection.includes_all());
}

TEST_CASE("a mask of another size is refused, naming both sizes") {
  Selection selection(4, 3);
  for (const auto& [width, height] : {std::pair(3, 4), std::pair(4, 4), std::pair(8, 3)}) {
    const auto done = selection.exclude_black(blank(width, height, 1, Format::kBytes));
    REQUIRE(!done);
    CHECK(done.error().cause.find("4 x 3") != std::string::npos);
    CHECK(done.error().cause.find(std::to_string(width) + " x " + std::to_string(height)) !=
          std::string::npos);
  }
  CHECK(selection.includes_all());
}

TEST_CASE("where nothing is left to compare there is no verdict") {
  const StoredImage reference = blank(6, 4, 3, Format::kBytes);
  const auto all = selection_of(reference, {{0, 0, 3, 4}, {3, 0, 3, 4}}, "");
  REQUIRE(!all);
  CHECK(all.error().cause.find("there is nothing to compare") != std::string::npos);
  CHECK(selection_of(reference, {{0, 0, 3, 4}, {3, 0, 2, 4}}, ""));
}

TEST_CASE("a selection is made of the boxes and the mask together") {
  const TemporaryDirectory here;
  StoredImage mask = blank(6, 4, 1, Format::kBytes);
  for (int x = 0; x < 6; ++x) set_sample(mask, x, 0, 0, 255);
  REQUIRE(write_file(here.file("mask.png"), *encode_png(mask)));
  const StoredImage reference = blank(6, 4, 3, Format::kBytes);
  const auto selection = selection_of(reference, {{0, 0, 2, 1}}, here.file("mask.png"));
  REQUIRE(selection);
  CHECK(selection->compared_pixels() == 4);
  CHECK(selection->compares(2, 0));
  CHECK(!selection->compares(1, 0));
  CHECK(!selection->compares(2, 1));

  const auto missing = selection_of(reference, {}, here.file("nothing.png"));
  REQUIRE(!missing);
  CHECK(missing.error().file == here.file("nothing.png"));
  const auto other = selection_of(blank(4, 6, 3, Format::kBytes), {}, here.file("mask.png"));
  REQUIRE(!other);
  CHECK(other.error().file == here.file("mask.png"));
}

}  // namespace
}  // namespace glassbox::test
