// The heat map of a comparison, computed from its files.
#include "tests/support/catch.h"

#include <string>

#include "tests/compare/pictures.h"
#include "tests/images/temporary_directory.h"

#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/compare/report/heat_map_file.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>

namespace glassbox::test {
namespace {

// a.png and b.png, which differ by 40 steps in pixel (3, 2), and a.pfm with floats.
class Pictures {
public:
  Pictures() {
    StoredImage image = blank(16, 16, 3, Format::kBytes);
    write("a.png", image);
    set_sample(image, 3, 2, 1, 40);
    write("b.png", image);
    REQUIRE(write_file(file("a.pfm"), *encode_pfm(blank(16, 16, 1, Format::kFloats))));
  }
  void write(const std::string& name, const StoredImage& image) const {
    REQUIRE(write_file(file(name), *encode_png(image)));
  }
  std::string file(const std::string& name) const { return directory_.file(name); }

private:
  TemporaryDirectory directory_;
};

TEST_CASE("the levels are those of the files, with what the comparison left out") {
  const Pictures here;
  CompareOptions options;
  options.ignore = {{0, 0, 2, 2}};
  const Comparison found = compare_files(here.file("a.png"), here.file("b.png"), options);
  const auto levels = heat_levels(found);
  REQUIRE(levels);
  Image<std::uint8_t> expected(16, 16, kHeatSame);
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
    expected.at(x, y) = kHeatNotCompared;
  }
  expected.at(3, 2) = heat_level(40, blank(1, 1, 1, Format::kBytes));
  CHECK(*levels == expected);

  REQUIRE(write_heat_map(here.file("heat.png"), found));
  const auto picture = read_image(here.file("heat.png"));
  REQUIRE(picture);
  CHECK(*picture == heat_picture(*levels));
}

TEST_CASE("the levels of FLIP are highest where the error is, and none of floats") {
  const Pictures here;
  const auto levels =
      heat_levels(compare_files(here.file("a.png"), here.file("b.png")), HeatMapKind::kFlip);
  REQUIRE(levels);
  CHECK(levels->at(3, 2) > 0);
  // Beyond the reach of the widest filter the levels are 0; they grow towards the pixel.
  CHECK(levels->at(3, 2) >= levels->at(4, 2));
  CHECK(levels->at(3, 2) >= levels->at(12, 12));
  const auto floats =
      heat_levels(compare_files(here.file("a.pfm"), here.file("a.pfm")), HeatMapKind::kFlip);
  REQUIRE(!floats);
  CHECK(floats.error().cause.find("floats") != std::string::npos);
}

TEST_CASE("there is no heat map of what could not be compared") {
  const Pictures here;
  here.write("grey.png", blank(16, 16, 1, Format::kBytes));
  for (const char* test : {"grey.png", "a.pfm", "none.png"}) {
    INFO(test);
    const Comparison found = compare_files(here.file("a.png"), here.file(test));
    CHECK(!heat_levels(found));
    CHECK(!write_heat_map(here.file("heat.png"), found));
    CHECK(!read_image(here.file("heat.png")));
  }
}

TEST_CASE("a file that has changed since it was compared is not shown as if it had not") {
  const Pictures here;
  const Comparison found = compare_files(here.file("a.png"), here.file("b.png"));
  here.write("b.png", blank(17, 16, 3, Format::kBytes));
  const auto levels = heat_levels(found);
  REQUIRE(!levels);
  CHECK(levels.error().cause.find("changed") != std::string::npos);
}

TEST_CASE("a heat map goes where its extension says, or nowhere") {
  const Pictures here;
  const Comparison found = compare_files(here.file("a.png"), here.file("b.png"));
  CHECK(write_heat_map(here.file("heat.ppm"), found));
  CHECK(!write_heat_map(here.file("heat.jpg"), found));
  CHECK(!write_heat_map(here.file("nowhere/heat.png"), found));
}

}  // namespace
}  // namespace glassbox::test
