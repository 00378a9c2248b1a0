// Tests how pictures of different sizes are laid on each other, compared and shown.
#include "tests/support/catch.h"

#include <string>
#include <tuple>

#include "tests/compare/pictures.h"
#include "tests/images/temporary_directory.h"

#include <glassbox/base/random.h>
#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pixels/canvas.h>
#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/compare/report/heat_map_file.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::test {
namespace {

TEST_CASE("a canvas has both pictures, and an overlap as large as the smaller sizes") {
  for (const auto& [rw, rh, tw, th] :
       {std::tuple(7, 5, 3, 4), std::tuple(3, 4, 7, 5), std::tuple(7, 2, 3, 6),
        std::tuple(3, 6, 7, 2), std::tuple(1, 1, 9, 1), std::tuple(4, 4, 4, 5)}) {
    const StoredImage reference = blank(rw, rh, 3, Format::kBytes);
    const StoredImage test = blank(tw, th, 3, Format::kBytes);
    for (const Alignment alignment : {Alignment::kTopLeft, Alignment::kCentre, Alignment::kBest}) {
      const Canvas canvas = place_on_canvas(reference, test, alignment);
      CHECK(canvas.width == std::max(rw, tw));
      CHECK(canvas.height == std::max(rh, th));
      const PixelBox all{0, 0, canvas.width, canvas.height};
      CHECK(intersection(canvas.reference, all) == canvas.reference);
      CHECK(intersection(canvas.test, all) == canvas.test);
      CHECK(canvas.overlap().width == std::min(rw, tw));
      CHECK(canvas.overlap().height == std::min(rh, th));
    }
  }
}

TEST_CASE("corners lie on corners, and centres on centres to the pixel up and left") {
  const StoredImage large = blank(9, 8, 3, Format::kBytes), small = blank(4, 3, 3, Format::kBytes);
  CHECK(place_on_canvas(large, small, Alignment::kTopLeft).test == PixelBox{0, 0, 4, 3});
  CHECK(place_on_canvas(large, small, Alignment::kCentre).test == PixelBox{2, 2, 4, 3});
  const Canvas turned = place_on_canvas(small, large, Alignment::kCentre);
  CHECK(turned.reference == PixelBox{2, 2, 4, 3});
  CHECK(turned.test == PixelBox{0, 0, 9, 8});
}

TEST_CASE("the best place is where the picture was cut from, whatever its format") {
  Random random(61);
  for (const Format format : kFormats) {
    for (int round = 0; round < 20; ++round) {
      StoredImage large = blank(60, 40, 3, format);
      // A few marks on a plain background: most places fit nearly everywhere.
      for (int i = 0; i < 60; ++i) {
        const auto x = int(random.integer(0, 59));
        const auto y = int(random.integer(0, 39));
        const auto channel = int(random.integer(0, 2));
        set_sample(large, x, y, channel, random_sample(random, format));
      }
      const auto x = int(random.integer(0, 30));
      const PixelBox box{x, int(random.integer(0, 20)), 30, 20};
      StoredImage small = part_of(large, box, format);
      // One of its pixels has changed.
      set_sample(small, 7, 9, 0, sample_at(small, 7, 9, 0) + 1);
      INFO(name_of(format) << ", cut at " << box.x << ", " << box.y);
      CHECK(best_place(large, small) == PixelPosition{box.x, box.y});
      CHECK(best_place(small, large) == PixelPosition{-box.x, -box.y});
    }
  }
}

TEST_CASE("the best place is found where the test is wider and lower") {
  Random random(62);
  const StoredImage scene = random_picture(random, 50, 40, 3, Format::kBytes);
  const StoredImage reference = part_of(scene, {10, 0, 20, 40}, Format::kBytes);
  const StoredImage test = part_of(scene, {3, 12, 47, 15}, Format::kBytes);
  CHECK(best_place(reference, test) == PixelPosition{-7, 12});
}

class SizesFiles {
public:
  SizesFiles() {
    Random random(63);
    const StoredImage scene = random_picture(random, 24, 18, 3, Format::kBytes);
    write("scene.png", scene);
    write("corner.png", part_of(scene, {0, 0, 20, 15}, Format::kBytes));
    StoredImage inner = part_of(scene, {3, 2, 20, 15}, Format::kBytes);
    write("inner.png", inner);
    set_sample(inner, 4, 5, 1, 255 - sample_at(inner, 4, 5, 1));
    write("changed.png", inner);
  }
  Comparison compare(const std::string& reference, const std::string& test,
                     const CompareOptions& options = {}) const {
    return compare_files(file(reference), file(test), options);
  }
  std::string file(const std::string& name) const { return directory_.file(name); }

private:
  void write(const std::string& name, const StoredImage& image) const {
    REQUIRE(write_file(file(name), *encode_png(image)));
  }
  TemporaryDirectory directory_;
};

TEST_CASE("pictures of different sizes are different, and what both have is compared") {
  const SizesFiles files;
  const Comparison found = files.compare("scene.png", "corner.png");
  CHECK(found.verdict == Verdict::kDifferent);
  REQUIRE(found.differences);
  CHECK(found.differences->compared == 20 * 15);
  CHECK(found.differences->differing == 0);
  CHECK(found.reasons ==
        std::vector<std::string>{"the reference has 24 x 18 pixels, the test 20 x 15",
                                 "the 20 x 15 pixels that both have are the same"});
  CHECK(files.compare("scene.png", "inner.png").differences->differing > 200);
}

TEST_CASE("other sizes pass if this is asked for, and what both have passes") {
  const SizesFiles files;
  CompareOptions options;
  options.ignore_size = true;
  CHECK(files.compare("scene.png", "corner.png", options).verdict == Verdict::kWithinTolerance);
  CHECK(files.compare("scene.png", "scene.png", options).verdict == Verdict::kSame);
  CHECK(files.compare("scene.png", "inner.png", options).verdict == Verdict::kDifferent);
  options.alignment = Alignment::kBest;
  CHECK(files.compare("scene.png", "inner.png", options).verdict == Verdict::kWithinTolerance);
  CHECK(files.compare("scene.png", "changed.png", options).verdict == Verdict::kDifferent);
  options.tolerance.max_differing = MaxDiffering{1, {}};
  CHECK(files.compare("scene.png", "changed.png", options).verdict == Verdict::kWithinTolerance);
}

TEST_CASE("what is suggested for pictures of different sizes passes with --ignore-size") {
  const SizesFiles files;
  CompareOptions options;
  options.alignment = Alignment::kBest;
  options.suggest_tolerance = true;
  const auto suggestions = files.compare("scene.png", "changed.png", options).suggestions;
  REQUIRE(suggestions.size() == 3);
  CHECK(suggestions[2] == "together with: --ignore-size");
  options.tolerance.fuzzy = *parse_fuzzy(suggestions[0].substr(7));
  CHECK(!passes(files.compare("scene.png", "changed.png", options).verdict));
  options.ignore_size = true;
  const Comparison found = files.compare("scene.png", "changed.png", options);
  CHECK(passes(found.verdict));
  CHECK(found.tolerance == suggestions[0].substr(7) + ", different sizes are ignored");
  CHECK(found.suggestions.size() == 2);
}

TEST_CASE("positions are counted on the canvas, and a note says where it lies") {
  const SizesFiles files;
  CompareOptions options;
  options.alignment = Alignment::kBest;
  const Comparison found = files.compare("scene.png", "changed.png", options);
  REQUIRE(found.differences);
  CHECK(found.differences->differing == 1);
  CHECK(found.differences->first == PixelPosition{7, 7});
  CHECK(found.notes ==
        std::vector<std::string>{
            "the test begins at (3, 2), counted from the reference's top left pixel"});
  const Comparison turned = files.compare("changed.png", "scene.png", options);
  CHECK(turned.differences->first == PixelPosition{7, 7});
  REQUIRE(turned.notes.size() == 1);
  CHECK(turned.notes[0].find("the reference begins at (3, 2), the test at (0, 0)") !=
        std::string::npos);
}

TEST_CASE("the heat map has the canvas, and marks what only one picture has") {
  const SizesFiles files;
  CompareOptions options;
  options.alignment = Alignment::kBest;
  const auto levels = heat_levels(files.compare("changed.png", "scene.png", options));
  REQUIRE(levels);
  REQUIRE(levels->width == 24);
  REQUIRE(levels->height == 18);
  for (int y = 0; y < 18; ++y) {
    for (int x = 0; x < 24; ++x) {
      const bool both = 3 <= x && x < 23 && 2 <= y && y < 17;
      CHECK((levels->at(x, y) == kHeatNotCompared) == !both);
      CHECK((is_heat(levels->at(x, y))) == (x == 7 && y == 7));
    }
  }
}

TEST_CASE("boxes and masks are counted in the reference's pixels") {
  const SizesFiles files;
  CompareOptions options;
  options.alignment = Alignment::kBest;
  options.ignore = {{4, 5, 1, 1}};
  const Comparison found = files.compare("changed.png", "scene.png", options);
  REQUIRE(found.differences);
  CHECK(found.differences->compared == 20 * 15 - 1);
  CHECK(found.differences->differing == 0);
  // Nothing is left where both pictures are.
  options.alignment = Alignment::kTopLeft;
  options.ignore = {{0, 0, 20, 15}};
  const Comparison none = files.compare("scene.png", "corner.png", options);
  CHECK(none.verdict == Verdict::kUncompared);
}

}  // namespace
}  // namespace glassbox::test
