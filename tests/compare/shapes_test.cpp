// Tests the explanations of why two pictures cannot be compared at all.
#include "tests/support/catch.h"

#include <string>
#include <vector>

#include "tests/compare/pictures.h"

#include <glassbox/compare/pixels/explanation.h>

namespace glassbox::test {
namespace {

using Words = std::vector<std::string>;

TEST_CASE("pictures of one size, format and number of channels can be compared") {
  for (const Format format : kFormats) {
    for (int channels = 1; channels <= 4; ++channels) {
      CHECK(explain_format_mismatch(blank(4, 3, channels, format), blank(4, 3, channels, format))
                .empty());
    }
  }
}

TEST_CASE("sizes that differ are named, and turned pictures known") {
  const StoredImage image = blank(4, 3, 3, Format::kBytes);
  CHECK(explain_format_mismatch(image, blank(5, 3, 3, Format::kBytes)) ==
        Words{"the reference has 4 x 3 pixels, the test 5 x 3"});
  CHECK(explain_format_mismatch(image, blank(4, 2, 3, Format::kBytes)) ==
        Words{"the reference has 4 x 3 pixels, the test 4 x 2"});
  CHECK(explain_format_mismatch(image, blank(3, 4, 3, Format::kBytes)) ==
        Words{"the reference has 4 x 3 pixels, the test 3 x 4", "width and height are swapped"});
  // The same number of pixels does not mean the same size.
  CHECK(explain_format_mismatch(image, blank(6, 2, 3, Format::kBytes)).size() == 1);
}

TEST_CASE("channels that differ are named, and an alpha that says nothing known") {
  const auto opaque = [](int channels, Format format, double full) {
    StoredImage image = blank(2, 2, channels, format);
    for (int i = 0; i < 4; ++i) set_sample(image, i % 2, i / 2, channels - 1, full);
    return image;
  };
  const StoredImage rgb = blank(2, 2, 3, Format::kBytes);
  CHECK(explain_format_mismatch(rgb, blank(2, 2, 1, Format::kBytes)) ==
        Words{"the reference is RGB, the test grey"});
  CHECK(explain_format_mismatch(rgb, blank(2, 2, 4, Format::kBytes)) ==
        Words{"the reference is RGB, the test RGBA"});
  const Words words{"the reference is RGB, the test RGBA",
                    "the alpha channel is opaque everywhere"};
  CHECK(explain_format_mismatch(rgb, opaque(4, Format::kBytes, 255)) == words);
  CHECK(explain_format_mismatch(blank(2, 2, 3, Format::kShorts),
                                opaque(4, Format::kShorts, 65535)) == words);
  CHECK(explain_format_mismatch(blank(2, 2, 3, Format::kShorts), opaque(4, Format::kShorts, 65534))
            .size() == 1);
  CHECK(explain_format_mismatch(opaque(2, Format::kBytes, 255), blank(2, 2, 1, Format::kBytes)) ==
        Words{"the reference is grey and alpha, the test grey",
              "the alpha channel is opaque everywhere"});
  // Grey with alpha and RGB differ in more than the alpha channel.
  CHECK(explain_format_mismatch(opaque(2, Format::kBytes, 255), rgb) ==
        Words{"the reference is grey and alpha, the test RGB"});
}

TEST_CASE("formats that differ are named") {
  CHECK(explain_format_mismatch(blank(2, 2, 3, Format::kBytes), blank(2, 2, 3, Format::kShorts)) ==
        Words{"the reference has 8 bits per sample, the test 16 bits"});
  CHECK(explain_format_mismatch(blank(2, 2, 3, Format::kFloats), blank(2, 2, 3, Format::kBytes)) ==
        Words{"the reference has 32-bit floats per sample, the test 8 bits"});
}

TEST_CASE("all that differs is said, the size first") {
  CHECK(explain_format_mismatch(blank(2, 3, 3, Format::kBytes), blank(3, 2, 4, Format::kShorts)) ==
        Words{"the reference has 2 x 3 pixels, the test 3 x 2", "width and height are swapped",
              "the reference is RGB, the test RGBA",
              "the reference has 8 bits per sample, the test 16 bits"});
}

}  // namespace
}  // namespace glassbox::test
