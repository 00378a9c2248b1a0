// Tests the reports of glassbox diff: files, and standard output that has nothing but the report.
#include "tests/support/catch.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/picture_file_kinds.h"

#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/images/read.h>

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

// The pictures a.png and b.png, which differ by 40 steps in pixel (3, 3) and by one in (10, 5).
class TwoPictures {
public:
  TwoPictures() {
    StoredImage image = sample_picture({"", "", 3, Format::kBytes, {}});
    here.write("a.png", png_of(image));
    set_sample(image, 3, 3, 1,
               sample_at(image, 3, 3, 1) < 128 ? sample_at(image, 3, 3, 1) + 40
                                               : sample_at(image, 3, 3, 1) - 40);
    set_sample(image, 10, 5, 2, sample_at(image, 10, 5, 2) + 1);
    here.write("b.png", png_of(image));
  }
  Outcome diff(const std::string& options) const { return here.run("diff a.png b.png " + options); }
  WorkingDirectory here;
};

TEST_CASE("the heat map is a picture of the levels, as large as the pictures") {
  const TwoPictures two;
  REQUIRE(two.diff("-o heat.png --ignore 0,0,2x2").exit_code == 1);
  const auto heat = read_image(two.here.file("heat.png"));
  REQUIRE(heat);
  REQUIRE(heat->width == 24);
  REQUIRE(heat->height == 18);
  const StoredImage bytes = blank(1, 1, 1, Format::kBytes);
  CHECK(heat->at(3, 3) == heat_colours()[heat_level(40, bytes)]);
  CHECK(heat->at(10, 5) == heat_colours()[heat_level(1, bytes)]);
  CHECK(heat->at(1, 1) == heat_colours()[kHeatNotCompared]);
  CHECK(heat->at(20, 9) == heat_colours()[kHeatSame]);
  CHECK(two.diff("-o heat.ppm").exit_code == 1);
  CHECK(read_image(two.here.file("heat.ppm")));
  CHECK(two.diff("-o flip.png --heat flip").exit_code == 1);
  CHECK(read_image(two.here.file("flip.png")));
  // For equal pictures the heat map is black.
  CHECK(two.here.run("diff a.png a.png -o same.png").exit_code == 0);
  const auto same = read_image(two.here.file("same.png"));
  REQUIRE(same);
  CHECK(*same == Image<Rgba8>(24, 18, Rgba8{0, 0, 0, 255}));
}

TEST_CASE("where there is nothing to show there is no heat map, and a note") {
  const TwoPictures two;
  two.here.write("c.png", png_of(sample_picture({"", "", 1, Format::kBytes, {}}, 24, 18)));
  const Outcome outcome = two.here.run("diff a.png c.png -o heat.png");
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.err, "no heat map"));
  CHECK(!std::filesystem::exists(two.here.file("heat.png")));
}

TEST_CASE("--json - prints one JSON document and nothing else") {
  const TwoPictures two;
  const Outcome outcome = two.diff("--json - --suggest-fuzzy --metric psnr");
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.err.empty());
  const Json json = Json::parse(outcome.out);
  CHECK(json["schema"] == "glassbox-diff-1");
  CHECK(json["summary"]["different"] == 1);
  CHECK(json["pictures"][0]["differences"]["differing_pixels"] == 2);
  CHECK(json["pictures"][0]["differences"]["first"] == Json({{"x", 3}, {"y", 3}}));
  CHECK(json["pictures"][0]["metrics"][0]["name"] == "psnr");

  REQUIRE(two.diff("--json report.json --suggest-fuzzy --metric psnr").exit_code == 1);
  CHECK(Json::parse(two.here.read("report.json")) == json);
}

TEST_CASE("what is missing or corrupt is in the JSON, too, and said on standard error") {
  const TwoPictures two;
  two.here.write("cut.png", two.here.read("a.png").substr(0, 100));
  for (const char* words : {"diff a.png none.png --json -", "diff none.png a.png --json -",
                            "diff a.png cut.png --json -", "diff cut.png a.png --json -"}) {
    INFO(words);
    const Outcome outcome = two.here.run(words);
    CHECK(outcome.exit_code == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    const Json json = Json::parse(outcome.out);
    CHECK(json["summary"]["same"] == 0);
    CHECK(json["pictures"][0].contains("error"));
    CHECK(!json["pictures"][0].contains("differences"));
  }
}

TEST_CASE("--junit - prints the XML and nothing else") {
  const TwoPictures two;
  const Outcome outcome = two.diff("--junit - --suggest-fuzzy");
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.find("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>") == 0);
  CHECK(contains(outcome.out, "tests=\"1\" failures=\"1\" errors=\"0\""));
  CHECK(outcome.out.find("</testsuites>\n") == outcome.out.size() - 14);
  REQUIRE(two.diff("--junit report.xml --suggest-fuzzy").exit_code == 1);
  const std::regex time(" time=\"[0-9.]+\"");
  CHECK(std::regex_replace(two.here.read("report.xml"), time, "") ==
        std::regex_replace(outcome.out, time, ""));
  CHECK(contains(two.here.run("diff a.png a.png --junit -").out, "failures=\"0\""));
}

TEST_CASE("all reports at once do not get into each other's way") {
  const TwoPictures two;
  const Outcome outcome = two.diff("-o h.png --html p.html --json - --junit j.xml");
  CHECK(outcome.exit_code == 1);
  CHECK(Json::accept(outcome.out));
  auto names = two.here.names();
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{"a.png", "b.png", "h.png", "j.xml", "p.html"});
  CHECK(contains(two.here.read("p.html"), "<html"));
  // Existing files are replaced, by the same bytes.
  const std::string page = two.here.read("p.html");
  CHECK(two.diff("-o h.png --html p.html --json - --junit j.xml").exit_code == 1);
  CHECK(two.here.read("p.html") == page);
}

TEST_CASE("the page names the words that compare the same again") {
  const TwoPictures two;
  REQUIRE(two.diff("--fuzzy 0-9;0-1 --ignore 1,1,2x2 --ignore -3,4,5x5 --nan-equal --metric rmse "
                   "--html p.html")
              .exit_code == 1);
  const std::string page = two.here.read("p.html");
  for (const char* part : {"diff a.png b.png", "0-9;0-1", "--ignore 1,1,2x2", "--ignore -3,4,5x5",
                           "--nan-equal", "--metric rmse"}) {
    INFO(part);
    CHECK(contains(page, part));
  }
}

}  // namespace
}  // namespace glassbox::test
