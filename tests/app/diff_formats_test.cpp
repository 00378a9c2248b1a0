// Pictures whose files differ in kind: another sample format is a difference, another kind of file
// is not.
#include "tests/support/catch.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/app/picture_file_kinds.h"

namespace glassbox::test {
namespace {

StoredImage picture(int channels, Format format) {
  return sample_picture({"", "", channels, format, {}});
}

Outcome diff(const std::string& reference, const std::string& test,
             const std::string& options = "") {
  const WorkingDirectory here;
  here.write("a", reference);
  here.write("b", test);
  return here.run("diff a b " + options);
}

// Checks the words for the difference of two formats, which is a difference under any tolerance.
void check_shapes(const std::string& a, const std::string& b, const std::string& words) {
  for (const char* options : {"", "--fuzzy 0-65535;0-1000000", "--metric absmax<=1"}) {
    const Outcome outcome = diff(a, b, options);
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.out, words));
  }
}

TEST_CASE("another number of channels or of bits is a difference") {
  const std::string grey = png_of(picture(1, Format::kBytes));
  const std::string rgb = png_of(picture(3, Format::kBytes));
  const std::string rgba = png_of(picture(4, Format::kBytes));
  const std::string wide = png_of(picture(3, Format::kShorts));
  const std::string floats = pfm_of(picture(3, Format::kFloats));
  check_shapes(grey, rgb, "the reference is grey, the test RGB");
  check_shapes(rgb, rgba, "the reference is RGB, the test RGBA");
  check_shapes(rgba, rgb, "the reference is RGBA, the test RGB");
  check_shapes(rgb, wide, "the reference has 8 bits per sample, the test 16 bits");
  check_shapes(wide, floats, "the reference has 16 bits per sample, the test 32-bit floats");
}

TEST_CASE("an opaque alpha channel is no difference unless it is to be one, and is named") {
  StoredImage rgba = picture(4, Format::kBytes);
  StoredImage rgb = blank(rgba.width, rgba.height, 3, Format::kBytes);
  for (int y = 0; y < rgb.height; ++y) {
    for (int x = 0; x < rgb.width; ++x) {
      set_sample(rgba, x, y, 3, 255);
      for (int c = 0; c < 3; ++c) set_sample(rgb, x, y, c, sample_at(rgba, x, y, c));
    }
  }
  const Outcome same = diff(png_of(rgb), png_of(rgba));
  CHECK(same.exit_code == 0);
  CHECK(contains(same.out, "b: same\nnote: the test has an alpha channel that is opaque"));
  const Outcome strict = diff(png_of(rgb), png_of(rgba), "--alpha strict");
  CHECK(strict.exit_code == 1);
  CHECK(contains(strict.out, "the alpha channel is opaque everywhere"));
}

TEST_CASE("the same samples in another container are the same picture") {
  const StoredImage rgb = picture(3, Format::kBytes), grey = picture(1, Format::kBytes);
  const StoredImage wide = picture(3, Format::kShorts);
  CHECK(diff(png_of(rgb), pnm_of(rgb)).exit_code == 0);
  CHECK(diff(png_of(rgb), palette_png_of(rgb)).exit_code == 0);
  CHECK(diff(png_of(grey), pnm_of(grey)).exit_code == 0);
  CHECK(diff(png_of(wide), pnm_of(wide)).exit_code == 0);
}

TEST_CASE("the lowest of 16 bits counts") {
  const StoredImage reference = picture(4, Format::kShorts);
  for (int c = 0; c < 4; ++c) {
    StoredImage test = reference;
    set_sample(test, 23, 17, c, sample_at(test, 23, 17, c) + 1);
    const Outcome outcome = diff(png_of(reference), png_of(test));
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.out, "1 of 432 pixels differ, by up to 1/65535"));
    CHECK(contains(outcome.out, "first (23, 17)"));
  }
}

TEST_CASE("colours under an alpha of zero count") {
  StoredImage reference = picture(4, Format::kBytes);
  set_sample(reference, 3, 3, 3, 0);
  StoredImage test = reference;
  set_sample(test, 3, 3, 1, sample_at(test, 3, 3, 1) + 1);
  CHECK(diff(png_of(reference), png_of(test)).exit_code == 1);
}

TEST_CASE("NaN is different from NaN unless asked otherwise") {
  for (const int channels : {1, 3}) {
    StoredImage reference = picture(channels, Format::kFloats);
    set_sample(reference, 5, 6, 0, std::nan(""));
    const std::string pfm = pfm_of(reference);
    const Outcome strict = diff(pfm, pfm);
    INFO(strict.out);
    CHECK(strict.exit_code == 1);
    CHECK(contains(strict.out, "1 of 432 pixels differ, some by an infinite difference"));
    CHECK(contains(strict.out, "first (5, 6)"));
    CHECK(contains(strict.out, "nan"));
    CHECK(diff(pfm, pfm, "--nan-equal").exit_code == 0);
    // No tolerance allows it.
    CHECK(diff(pfm, pfm, "--max-ulp 4294967294").exit_code == 1);
    const Outcome fuzzy = diff(pfm, pfm, "--fuzzy 0-18446744073709551615;0-18446744073709551615");
    CHECK(fuzzy.exit_code == 1);
    CHECK(contains(fuzzy.out, "an infinite difference is not within"));
    CHECK(!contains(fuzzy.out, "4294967295"));
    CHECK(contains(diff(pfm, pfm, "--suggest-fuzzy").out, "fuzzy: no --fuzzy allows NaN"));

    StoredImage number = reference;
    set_sample(number, 5, 6, 0, 1);
    CHECK(diff(pfm, pfm_of(number)).exit_code == 1);
    CHECK(diff(pfm, pfm_of(number), "--nan-equal").exit_code == 1);
    CHECK(diff(pfm, pfm_of(number), "--nan-equal --ignore 5,6,1x1").exit_code == 0);
  }
}

TEST_CASE("an infinity is the same as itself and at no distance from anything else") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  StoredImage reference = picture(1, Format::kFloats);
  set_sample(reference, 2, 2, 0, kInfinity);
  StoredImage negative = reference, largest = reference;
  set_sample(negative, 2, 2, 0, -kInfinity);
  set_sample(largest, 2, 2, 0, double(std::numeric_limits<float>::max()));
  const std::string pfm = pfm_of(reference);
  CHECK(diff(pfm, pfm).exit_code == 0);
  for (const StoredImage& other : {negative, largest}) {
    CHECK(diff(pfm, pfm_of(other)).exit_code == 1);
    CHECK(diff(pfm, pfm_of(other), "--max-ulp 4294967294").exit_code == 1);
  }
}

TEST_CASE("the zeros differ by one ulp") {
  StoredImage reference = picture(1, Format::kFloats);
  set_sample(reference, 2, 2, 0, 0.0);
  StoredImage test = reference;
  set_sample(test, 2, 2, 0, -0.0);
  const Outcome outcome = diff(pfm_of(reference), pfm_of(test));
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.out, "1 ulp"));
  CHECK(diff(pfm_of(reference), pfm_of(test), "--max-ulp 1").exit_code == 0);
}

}  // namespace
}  // namespace glassbox::test
