// Tests that an alpha channel which is opaque everywhere is no difference, unless it is to be one.
#include "tests/support/catch.h"

#include <string>

#include "tests/compare/pictures.h"
#include "tests/images/temporary_directory.h"

#include <glassbox/base/random.h>
#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pixels/alpha.h>
#include <glassbox/compare/report/heat_map_file.h>
#include <glassbox/compare/report/text.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::test {
namespace {

constexpr double full_alpha(Format format) {
  return format == Format::kBytes ? 255 : format == Format::kShorts ? 65535 : 1;
}

// The picture with an alpha channel that is opaque everywhere.
StoredImage with_opaque_alpha(const StoredImage& plain, Format format) {
  StoredImage image = blank(plain.width, plain.height, plain.channels + 1, format);
  for (int y = 0; y < plain.height; ++y) {
    for (int x = 0; x < plain.width; ++x) {
      for (int c = 0; c < plain.channels; ++c)
        set_sample(image, x, y, c, sample_at(plain, x, y, c));
      set_sample(image, x, y, plain.channels, full_alpha(format));
    }
  }
  return image;
}

TEST_CASE("a picture is opaque if every alpha is the largest one") {
  Random random(51);
  for (const Format format : kFormats) {
    for (const int channels : {1, 3}) {
      const StoredImage plain = random_picture(random, 5, 4, channels, format);
      CHECK(!is_opaque(plain));
      StoredImage image = with_opaque_alpha(plain, format);
      CHECK(is_opaque(image));
      CHECK(without_alpha(image) == plain);
      for (const auto& [x, y] : {std::pair(0, 0), std::pair(4, 3), std::pair(2, 1)}) {
        StoredImage hole = image;
        set_sample(hole, x, y, channels, format == Format::kFloats ? 0.5 : full_alpha(format) - 1);
        CHECK(!is_opaque(hole));
      }
    }
  }
}

class AlphaFiles {
public:
  AlphaFiles() {
    Random random(52);
    const StoredImage grey = random_picture(random, 6, 5, 1, Format::kBytes);
    const StoredImage rgb = random_picture(random, 6, 5, 3, Format::kShorts);
    write("grey.png", grey);
    write("rgb.png", rgb);
    write("grey-alpha.png", with_opaque_alpha(grey, Format::kBytes));
    StoredImage rgba = with_opaque_alpha(rgb, Format::kShorts);
    write("rgba.png", rgba);
    set_sample(rgba, 2, 3, 1, 65535 - sample_at(rgba, 2, 3, 1));
    write("other.png", rgba);
    set_sample(rgba, 5, 4, 3, 65534);
    write("hole.png", rgba);
  }
  Comparison compare(const std::string& reference, const std::string& test,
                     const CompareOptions& options = {}) const {
    return compare_files(directory_.file(reference), directory_.file(test), options);
  }

private:
  void write(const std::string& name, const StoredImage& image) const {
    REQUIRE(write_file(directory_.file(name), *encode_png(image)));
  }
  TemporaryDirectory directory_;
};

TEST_CASE("an opaque alpha channel is no difference, and this is said once") {
  const AlphaFiles files;
  const std::vector<Comparison> all{
      files.compare("rgb.png", "rgba.png"), files.compare("rgba.png", "rgb.png"),
      files.compare("grey.png", "grey-alpha.png"), files.compare("rgb.png", "rgb.png")};
  for (const Comparison& one : all) CHECK(one.verdict == Verdict::kSame);
  CHECK(all[0].opaque_alpha == OpaqueAlpha::kTest);
  CHECK(all[1].opaque_alpha == OpaqueAlpha::kReference);
  CHECK(opaque_alpha_text(all).find("in 3 pairs, one picture has an alpha channel") == 0);
  CHECK(opaque_alpha_text(std::span(all).first(1)).find("the test has an alpha channel") == 0);
  CHECK(opaque_alpha_text(std::span(all).last(1)).empty());
}

TEST_CASE("colours beside an opaque alpha channel are compared, and drawn") {
  const AlphaFiles files;
  const Comparison found = files.compare("rgb.png", "other.png");
  CHECK(found.verdict == Verdict::kDifferent);
  REQUIRE(found.differences);
  CHECK(found.differences->differing == 1);
  CHECK(found.differences->first == PixelPosition{2, 3});
  const auto levels = heat_levels(found);
  REQUIRE(levels);
  CHECK(levels->at(2, 3) > 0);
  CHECK(levels->at(5, 4) == 0);
}

TEST_CASE(
    "an alpha channel that is not opaque is a difference, and so is any with the strict rule") {
  const AlphaFiles files;
  for (const char* test : {"hole.png", "grey-alpha.png"}) {
    const Comparison found = files.compare("rgb.png", test);
    CHECK(found.verdict == Verdict::kDifferent);
    CHECK(!found.differences);
    CHECK(found.opaque_alpha == OpaqueAlpha::kNone);
  }
  CompareOptions strict;
  strict.alpha = AlphaRule::kStrict;
  const Comparison found = files.compare("rgb.png", "rgba.png", strict);
  CHECK(found.verdict == Verdict::kDifferent);
  CHECK(found.reasons == std::vector<std::string>{"the reference is RGB, the test RGBA",
                                                  "the alpha channel is opaque everywhere"});
}

}  // namespace
}  // namespace glassbox::test
