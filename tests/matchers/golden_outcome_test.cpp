// Tests check_golden with the program that compares: what passes, what a failure leaves, who may
// approve.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/compare/environment.h"
#include "tests/compare/pictures.h"
#include "tests/images/temporary_directory.h"
#include "tests/support/catch.h"

#include <glassbox/base/elapsed.h>
#include <glassbox/compare/testing/catch2.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>

namespace glassbox::test {
namespace {

namespace fs = std::filesystem;

// A folder of tests, in which source.cpp would be, and one for failures.
class Tests {
public:
  GoldenOutcome check(const auto& picture, const std::string& golden) const {
    return check_golden(picture, golden, path("source.cpp"));
  }
  // Makes the picture a golden image by approval.
  void approve(const auto& picture, const std::string& golden) const {
    const EnvironmentVariable wanted("GLASSBOX_APPROVE", "1");
    const GoldenOutcome outcome = check(picture, golden);
    INFO(outcome.message);
    REQUIRE(outcome.matches);
    CHECK(outcome.message.find("approved") != std::string::npos);
  }
  std::string path(const std::string& name) const { return directory_.file(name); }
  bool has(const std::string& name) const { return fs::exists(path(name)); }

private:
  TemporaryDirectory directory_;
  EnvironmentVariable failures_{"GLASSBOX_FAILURES", directory_.file("failures")};
  EnvironmentVariable no_server_{"CI", {}};
  EnvironmentVariable no_approval_{"GLASSBOX_APPROVE", {}};
  EnvironmentVariable no_program_{"GLASSBOX_PROGRAM", {}};
};

bool says(const GoldenOutcome& outcome, const std::string& text) {
  return outcome.message.find(text) != std::string::npos;
}

// A user's own picture.
struct Grey {
  int width, height;
  std::vector<std::uint16_t> samples;
};
PictureView picture_view(const Grey& picture) {
  return {picture.width, picture.height, 1, picture.samples.data()};
}

// The picture, of bytes, beside and below itself.
StoredImage four_times(const StoredImage& image) {
  StoredImage all = blank(2 * image.width, 2 * image.height, image.channels, Format::kBytes);
  for (int y = 0; y < all.height; ++y) {
    for (int x = 0; x < all.width; ++x) {
      for (int c = 0; c < all.channels; ++c) {
        set_sample(all, x, y, c, sample_at(image, x % image.width, y % image.height, c));
      }
    }
  }
  return all;
}

}  // namespace

TEST_CASE("pictures of every type are approved into folders that did not exist, and then match") {
  const Tests tests;
  Random random(48);
  const Image<Rgba8> colours(7, 5, {10, 20, 30, 40});
  const Image<float> distances(7, 5, 0.5f);
  const Image<Rgb32f> light(7, 5, {1, 2, 3});
  const StoredImage stored = random_picture(random, 7, 5, 2, Format::kBytes);
  const Grey own{3, 2, {0, 1, 255, 256, 65534, 65535}};
  const auto check = [&](const auto& picture, const std::string& golden) {
    INFO(golden);
    CHECK(says(tests.check(picture, golden), "there is no such reference yet"));
    CHECK(tests.has("failures/" + golden));
    tests.approve(picture, golden);
    CHECK(tests.has(golden));
    CHECK_FALSE(tests.has("failures/" + golden));
    CHECK(says(tests.check(picture, golden), "equals"));
  };
  check(colours, "a/b/colours.png");
  check(distances, "a/distances.pfm");
  check(light, "light.pfm");
  check(stored, "c d/stored.png");
  check(own, "own.png");
  CHECK_THAT(own, MatchesGolden(tests.path("own.png")));
}

TEST_CASE(
    "a picture that differs fails and leaves its picture, heat map and page, until it passes") {
  const Tests tests;
  Grey picture{3, 2, {0, 1, 255, 256, 65534, 65535}};
  tests.approve(picture, "grey.png");
  picture.samples[4] = 7;
  const GoldenOutcome outcome = tests.check(picture, "grey.png");
  CHECK_FALSE(outcome.matches);
  CHECK(says(outcome, "1 of 6 pixels differ"));
  CHECK(says(outcome, "GLASSBOX_APPROVE=1"));
  for (const char* trace : {"failures/grey.png", "failures/grey.heat.png", "failures/grey.html"}) {
    INFO(trace);
    CHECK(tests.has(trace));
    CHECK(says(outcome, tests.path(trace)));
  }
  std::ofstream(tests.path("grey.png.fuzzy")) << "max-differing: 1\nreason: a test\n";
  const GoldenOutcome tolerated = tests.check(picture, "grey.png");
  CHECK(tolerated.matches);
  CHECK(says(tolerated, "because: a test"));
  CHECK_FALSE(tests.has("failures/grey.png"));
  CHECK_FALSE(tests.has("failures/grey.html"));
}

TEST_CASE("a server approves nothing") {
  const Tests tests;
  const EnvironmentVariable server("CI", "true"), wanted("GLASSBOX_APPROVE", "1");
  const GoldenOutcome outcome = tests.check(Image<float>(2, 2), "new.pfm");
  CHECK_FALSE(outcome.matches);
  CHECK(says(outcome, "CI is set"));
  CHECK_FALSE(tests.has("new.pfm"));
}

TEST_CASE("a picture file is compared, and is approved as it is") {
  const Tests tests;
  const auto write = [&](const std::string& name, std::uint8_t red, const std::string& author) {
    const std::vector<TextEntry> text{{"Author", author}};
    REQUIRE(write_image(tests.path(name), Image<Rgba8>(4, 4, {red, 0, 0}), text));
  };
  write("made.png", 7, "one");
  const PictureFile made{tests.path("made.png")};
  tests.approve(made, "golden.png");
  CHECK(says(tests.check(made, "golden.png"), "equals"));
  write("made.png", 7, "another");  // other bytes, and the same pixels
  CHECK(tests.check(made, "golden.png").matches);
  {
    const EnvironmentVariable named("GLASSBOX_PROGRAM", "/nowhere");  // so it was the program
    CHECK(says(tests.check(made, "golden.png"), "not compared"));
  }
  write("made.png", 8, "one");
  CHECK_FALSE(tests.check(made, "golden.png").matches);

  CHECK(says(tests.check(made, tests.path("made.png")), "is compared with itself"));
  CHECK(says(tests.check(PictureFile{tests.path("none.png")}, "golden.png"), "cannot be read"));
  CHECK(says(tests.check(PictureFile{tests.path("")}, "golden.png"), "cannot be read"));
}

TEST_CASE("a golden image that cannot be read fails, and is not replaced") {
  const Tests tests;
  std::ofstream(tests.path("broken.png")) << "no picture";
  const EnvironmentVariable wanted("GLASSBOX_APPROVE", "1");
  const GoldenOutcome outcome = tests.check(Image<Rgba8>(2, 2), "broken.png");
  CHECK_FALSE(outcome.matches);
  CHECK(says(outcome, "not approved: "));
  CHECK(fs::file_size(tests.path("broken.png")) == 10);
}

TEST_CASE("failures are not written over golden images, and these are not deleted") {
  const Tests tests;
  const Image<float> picture(2, 2, 1.0f), other(2, 2, 2.0f);
  tests.approve(picture, "a.pfm");
  const EnvironmentVariable same_folder("GLASSBOX_FAILURES", tests.path("."));
  for (const Image<float>& each : {picture, other}) {
    const GoldenOutcome outcome = tests.check(each, "a.pfm");
    CHECK_FALSE(outcome.matches);
    CHECK(says(outcome, "name another folder"));
  }
  CHECK_FALSE(tests.check(picture, "new.pfm").matches);
  CHECK_FALSE(tests.has("new.pfm"));
  CHECK(*read_pfm(tests.path("a.pfm")) == picture);
}

TEST_CASE("what cannot be stored, written or compared fails with a reason") {
  const Tests tests;
  CHECK(says(tests.check(Image<float>(2, 2), "a.png"), "PNG has no floats"));
  CHECK(says(tests.check(StoredImage{2, 2, 1, std::vector<float>(3)}, "a.pfm"), "too few samples"));
  std::ofstream(tests.path("failures")) << "a file";
  CHECK(says(tests.check(Image<float>(2, 2), "a.pfm"), "cannot be created"));
  fs::remove(tests.path("failures"));

  tests.approve(Image<float>(2, 2), "a.pfm");
  const Image<float> other(2, 2, 1.0f);
  for (const auto& [program, why] :
       {std::pair{"/nowhere", "cannot be started"}, std::pair{"no-such-program-in-PATH", "cannot"},
        std::pair{"/", "cannot be started"}}) {
    const EnvironmentVariable named("GLASSBOX_PROGRAM", program);
    INFO(program);
    const GoldenOutcome outcome = tests.check(other, "a.pfm");
    CHECK_FALSE(outcome.matches);
    CHECK(says(outcome, why));
    CHECK(says(outcome, "GLASSBOX_PROGRAM"));
  }
}

TEST_CASE("a golden image outside of the folder of tests leaves its failures in their folder") {
  const Tests tests;
  CHECK_FALSE(tests.check(Image<float>(2, 2), "../../outside.pfm").matches);
  CHECK(tests.has("failures/outside.pfm"));
  CHECK_FALSE(tests.check(Image<float>(2, 2), "/nowhere/at/all.pfm").matches);
  CHECK(tests.has("failures/all.pfm"));
}

// docs/image_tests.md shows what this prints.
TEST_CASE("how long a comparison takes that passes", "[.time]") {
  const Tests tests;
  StoredImage picture = four_times(test::golden("teapot.png"));
  tests.approve(picture, "teapot.png");
  const auto time = [&](const char* what, int count) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < count; ++i) REQUIRE(tests.check(picture, "teapot.png").matches);
    std::printf("%d x %d, %s: %.1f ms\n", picture.width, picture.height, what,
                elapsed_ms(start) / count);
  };
  time("equal", 500);
  set_sample(picture, 0, 0, 0, 1);
  std::ofstream(tests.path("teapot.png.fuzzy")) << "max-differing: 1\nreason: a test\n";
  time("one pixel that may differ", 50);
}

}  // namespace glassbox::test
