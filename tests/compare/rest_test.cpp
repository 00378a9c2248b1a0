// Files that show more than one picture pass only if all of it is the same.
#include "tests/support/catch.h"

#include <fstream>
#include <string>

#include "tests/images/exr_builder.h"
#include "tests/images/moving_png.h"
#include "tests/images/temporary_directory.h"

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox::test {
namespace {

Comparison compare(const std::string& reference, const std::string& test,
                   const CompareOptions& options = {}) {
  const TemporaryDirectory directory;
  const std::string a = directory.file("a"), b = directory.file("b");
  std::ofstream(a, std::ios::binary) << reference;
  std::ofstream(b, std::ios::binary) << test;
  return compare_files(a, b, options);
}

std::string text(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}
std::string moving(const std::vector<std::uint8_t>& frames) {
  return text(moving_png(frames));
}

bool has_note(const Comparison& comparison, const std::string& words) {
  for (const std::string& note : comparison.notes) {
    if (note.find(words) != std::string::npos) return true;
  }
  return false;
}

TEST_CASE("animations of the same frames are the same, and that is noted") {
  const Comparison same = compare(moving({1, 2, 3}), moving({1, 2, 3}));
  CHECK(same.verdict == Verdict::kSame);
  CHECK(has_note(same,
                 "the reference has 2 further frames, the test 2 further frames; these are "
                 "the same bytes"));
}

TEST_CASE("animations that differ after their first frame do not pass") {
  CompareOptions loose;
  loose.tolerance.fuzzy = Fuzzy{{0, 255}, {0, 100}};
  for (const auto& other : {moving({1, 2, 4}), moving({1, 2}), moving({1}), moving({1, 2, 3, 4})}) {
    const Comparison found = compare(moving({1, 2, 3}), other);
    CHECK(found.verdict == Verdict::kUncompared);
    REQUIRE(found.error);
    CHECK(found.error->cause.find("the reference has 2 further frames, the test") !=
          std::string::npos);
    CHECK(found.error->remedy == "save every picture as a file of its own, and compare these");
    CHECK(compare(other, moving({1, 2, 3})).verdict == Verdict::kUncompared);
    CHECK(compare(moving({1, 2, 3}), other, loose).verdict == Verdict::kUncompared);
  }
}

TEST_CASE("animations that differ in their first frame are different, and the rest is noted") {
  const Comparison found = compare(moving({1, 2}), moving({9, 2, 3}));
  CHECK(found.verdict == Verdict::kDifferent);
  CHECK(has_note(found, "only the first pictures are compared"));
}

TEST_CASE("several pictures in one PPM pass only if all of them are the same") {
  const std::string one = "P5 1 1 255\na", other = "P5 1 1 255\nb";
  CHECK(compare(one + one, one + one).verdict == Verdict::kSame);
  CHECK(compare(one + one, one + other).verdict == Verdict::kUncompared);
  CHECK(compare(one, one + other).verdict == Verdict::kUncompared);
  CHECK(compare(one, one).notes.empty());
}

TEST_CASE("a PPM that was written in text mode is named") {
  const std::string good = "P6\n2 1\n255\nabcdef", bad = "P6\r\n2 1\r\n255\r\nabcdef";
  const Comparison found = compare(good, bad);
  CHECK(found.verdict == Verdict::kDifferent);
  CHECK(has_note(found, "the test: the header ends in CR LF"));
  const Comparison same = compare(bad, bad);
  CHECK(same.verdict == Verdict::kSame);
  CHECK(has_note(same, "the reference: the header ends in CR LF"));
  // The last sample is behind the picture, so it must be the same, too.
  CHECK(compare(bad, "P6\r\n2 1\r\n255\r\nabcdeX").verdict == Verdict::kUncompared);
}

TEST_CASE("a further channel or another data window of an OpenEXR file does not pass unseen") {
  const auto exr = [](std::uint8_t depth, std::uint32_t right) {
    return text(build_exr({.channels = {{"Y"}, {"Z"}},
                           .display = {0, 0, right, 0},
                           .rows = {{0, 0x3c, depth, 0x3c}}}));
  };
  const Comparison same = compare(exr(1, 0), exr(1, 0));
  CHECK(same.verdict == Verdict::kSame);
  CHECK(has_note(same, "the reference has 1 further channel, the test 1 further channel"));
  for (const auto& other : {exr(2, 0), exr(1, 5), text(build_exr({}))}) {
    for (const Comparison& found : {compare(exr(1, 0), other), compare(other, exr(1, 0))}) {
      CHECK(found.verdict == Verdict::kUncompared);
      REQUIRE(found.error);
      CHECK(found.error->remedy ==
            "save both with one data window, and their further channels as files of their own");
    }
  }
}

TEST_CASE("OpenEXR with an alpha of 1 is the same as a PFM of its floats") {
  const std::string pfm("Pf 1 1 -1\n\0\0\0\x3f", 14);  // 0.5
  const auto exr = [](std::uint8_t alpha) {
    return text(build_exr({.channels = {{"A"}, {"Y"}}, .rows = {{0, alpha, 0, 0x38}}}));
  };
  CHECK(compare(pfm, exr(0x3c)).verdict == Verdict::kSame);
  CHECK(compare(pfm, exr(0x38)).verdict == Verdict::kDifferent);
}

TEST_CASE("a JPEG that its Exif data turn is compared upright, and the turning is noted") {
  const std::string folder = GLASSBOX_SOURCE_DIR "/tests/fuzz/corpus/stored/";
  const Comparison found = compare_files(folder + "rgb-subsampled.jpg", folder + "turned.jpg");
  CHECK(found.verdict == Verdict::kDifferent);
  CHECK(found.reference.width == found.test.height);
  CHECK(has_note(found, "the Exif orientation of the reference is 1, that of the test 6"));
  CHECK(compare_files(folder + "turned.jpg", folder + "turned.jpg").notes.empty());
}

TEST_CASE("a format that is not read is not compared, and named") {
  const Comparison found = compare(std::string("II*\0\1\2\3", 7), moving({1}));
  CHECK(found.verdict == Verdict::kUncompared);
  REQUIRE(found.error);
  CHECK(found.error->cause == "is a TIFF picture, which is not read");
}

}  // namespace
}  // namespace glassbox::test
