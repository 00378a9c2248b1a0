// The HTML page as a file: what it contains, what it leaves out, and that no name breaks out of its
// place.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <tuple>

#include <nlohmann/json.hpp>

#include <glassbox/compare/pictures/prepared_pair.h>
#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/compare/report/page.h>
#include <glassbox/compare/report/page_pictures.h>
#include <glassbox/images/write.h>

#include "tests/images/temporary_directory.h"
#include "tests/report/blob.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

using Json = nlohmann::json;
using test::TemporaryDirectory;

Image<Rgba8> grey(int width, int height) {
  return Image<Rgba8>(width, height, Rgba8{100, 110, 120, 255});
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// The content of the script element with this id.
std::string element(const std::string& page, const std::string& id) {
  const std::string mark = "id=\"" + id + "\">";
  const auto start = page.find(mark);
  REQUIRE(start != std::string::npos);
  const auto first = start + mark.size();
  return page.substr(first, page.find("</script>", first) - first);
}

struct Page {
  std::string text;
  Json manifest;
};

Page page_of(const TemporaryDirectory& directory, const std::vector<Comparison>& comparisons,
             const PageOptions& options = {}) {
  const std::string path = directory.file("page.html");
  const auto written = write_page(path, comparisons, options);
  INFO((written ? "" : written.error().message()));
  REQUIRE(written);
  Page page{text_of(path), {}};
  page.manifest = Json::parse(element(page.text, "manifest"));
  return page;
}

// A pair of grey pictures that differ by `steps` in pixel (3, 2).
Comparison pair_of(const TemporaryDirectory& directory, const std::string& name, int steps,
                   int width = 16, int height = 8) {
  Image<Rgba8> picture = grey(width, height);
  const std::string reference = directory.file("reference-" + name);
  const std::string test = directory.file("test-" + name);
  REQUIRE(write_image(reference, picture));
  picture.at(3, 2).g = std::uint8_t(110 + steps);
  REQUIRE(write_image(test, picture));
  Comparison comparison = compare_files(reference, test);
  comparison.name = name;
  return comparison;
}

std::vector<PixelBox> tiles_of(const Json& picture) {
  std::vector<PixelBox> tiles;
  for (const Json& box : picture["tiles"]) tiles.push_back({box[0], box[1], box[2], box[3]});
  return tiles;
}

std::vector<std::uint8_t> bytes_of(const Page& page, const Json& picture) {
  return test::decode_blob<std::uint8_t>(element(page.text, picture["blob"]), tiles_of(picture),
                                         picture["channels"]);
}

}  // namespace

TEST_CASE("the page holds the exact samples of both pictures and the levels of the heat map",
          "[report]") {
  const TemporaryDirectory directory;
  const Comparison comparison = pair_of(directory, "a.png", 7);
  const Page page = page_of(directory, {comparison});
  const Json& pictures = page.manifest["pairs"][0]["pictures"];

  const auto reference = read_stored(comparison.reference.path);
  const auto test = read_stored(comparison.test.path);
  REQUIRE(reference);
  REQUIRE(test);
  CHECK(bytes_of(page, pictures["reference"]) ==
        std::get<std::vector<std::uint8_t>>(reference->samples));
  CHECK(bytes_of(page, pictures["test"]) == std::get<std::vector<std::uint8_t>>(test->samples));
  const Selection all(16, 8);
  const Image<std::uint8_t> heat = heat_map({*reference, *test, all});
  CHECK(std::ranges::equal(bytes_of(page, pictures["heat"]), heat.pixels));
  CHECK(page.manifest["heat_colours"].size() == 256);
}

TEST_CASE("what a comparison leaves out is left out in the page's heat map", "[report]") {
  const TemporaryDirectory directory;
  const std::string first = pair_of(directory, "a.png", 7).reference.path;
  const std::string second = directory.file("test-a.png");
  CompareOptions options;
  options.ignore = {{0, 0, 4, 4}};
  const Page page = page_of(directory, {compare_files(first, second, options)});
  const auto levels = bytes_of(page, page.manifest["pairs"][0]["pictures"]["heat"]);
  CHECK(levels[2 * 16 + 3] == kHeatNotCompared);
  CHECK(levels[2 * 16 + 4] == kHeatSame);
}

TEST_CASE("a name cannot leave the text that it stands in", "[report]") {
  const TemporaryDirectory directory;
  const std::vector<std::string> names = {
      "</script><script>alert(1)</script>", "<!--<script>",  "]]>\"'&lt;", "\xff\xfe broken \xc3",
      "line\xe2\x80\xa8separator",          "{SCRIPT}{DATA}"};
  std::vector<Comparison> comparisons;
  for (const std::string& name : names) {
    Comparison comparison = pair_of(directory, "a.png", 9);
    comparison.name = comparison.reference.path = name;
    comparison.differences.reset();
    comparison.reasons = comparison.hints = comparison.notes = {name};
    comparison.error = Error{name, name, name, name};
    comparisons.push_back(comparison);
  }
  const std::size_t blobs =
      names.size();  // one for each test picture: the references have no such files
  const std::size_t closing = blobs + 2;  // the manifest and the script
  PageOptions options;
  options.title = options.command = options.program = names[0];
  const Page page = page_of(directory, comparisons, options);
  CHECK(count(page.text, "</script") == closing);
  CHECK(count(page.text, "<script") == closing);
  CHECK(page.text.find("<!--") == std::string::npos);
  CHECK(page.text.find("\xe2\x80\xa8") == std::string::npos);

  const Json& pairs = page.manifest["pairs"];
  CHECK(pairs[0]["name"] == names[0]);
  CHECK(pairs[3]["name"] == "\xef\xbf\xbd\xef\xbf\xbd broken \xef\xbf\xbd");
  CHECK(pairs[4]["name"] == names[4]);
  CHECK(page.manifest["title"] == names[0]);
}

TEST_CASE("the page asks for nothing outside of itself", "[report]") {
  const TemporaryDirectory directory;
  const Page page = page_of(directory, {pair_of(directory, "a.png", 1)});
  CHECK(page.text.find("default-src 'none'") != std::string::npos);
  CHECK(page.text.find("http:") == std::string::npos);
  CHECK(page.text.find("https:") == std::string::npos);
  CHECK(page.text.find("unsafe") == std::string::npos);
  for (const char* mark : {"{STYLE", "{SCRIPT", "{DATA}"}) {
    CHECK(page.text.find(mark) == std::string::npos);
  }
}

TEST_CASE("the worst pair comes first, and the same come last, without pictures", "[report]") {
  const TemporaryDirectory directory;
  const Comparison same = pair_of(directory, "same.png", 0);
  const Comparison slight = pair_of(directory, "slight.png", 1);
  const Comparison strong = pair_of(directory, "strong.png", 100);
  Comparison allowed = pair_of(directory, "allowed.png", 120);
  allowed.verdict = Verdict::kWithinTolerance;
  const Comparison missing =
      compare_files(same.reference.path, directory.file("there-is-no-such.png"));
  const Comparison sizes =
      compare_files(same.reference.path, pair_of(directory, "small.png", 0, 15, 8).test.path);

  const Page page = page_of(directory, {same, slight, allowed, missing, strong, sizes});
  std::vector<std::string> names;
  for (const Json& pair : page.manifest["pairs"]) names.push_back(pair["name"]);
  CHECK(names == std::vector<std::string>{sizes.name, "strong.png", "slight.png", missing.name,
                                          "allowed.png", "same.png"});
  CHECK(!page.manifest["pairs"][5].contains("pictures"));
  CHECK(!page.manifest["pairs"][5].contains("thumbnail"));
  CHECK(page.manifest["pairs"][5].contains("left_out"));
}

TEST_CASE("a single pair is shown even where it is the same", "[report]") {
  const TemporaryDirectory directory;
  const Page page = page_of(directory, {pair_of(directory, "same.png", 0)});
  CHECK(page.manifest["pairs"][0]["pictures"].size() == 3);
}

TEST_CASE("a pair of which one picture is missing or broken shows the other and the error",
          "[report]") {
  const TemporaryDirectory directory;
  const Comparison good = pair_of(directory, "a.png", 1);
  const std::string broken = directory.file("broken.png");
  std::ofstream(broken, std::ios::binary) << text_of(good.test.path).substr(0, 60);
  for (const std::string& test : {broken, directory.file("there-is-no-such.png")}) {
    const Page page = page_of(directory, {compare_files(good.reference.path, test)});
    const Json& pair = page.manifest["pairs"][0];
    CHECK(pair["pictures"].contains("reference"));
    CHECK(pair["pictures"].size() == 1);
    CHECK(!pair["error"]["cause"].get<std::string>().empty());
  }
  const Page page = page_of(directory, {compare_files(broken, broken)});
  CHECK(!page.manifest["pairs"][0].contains("pictures"));
  CHECK(page.manifest["pairs"][0].contains("left_out"));
}

TEST_CASE("pictures that have changed since the comparison are not shown beside its numbers",
          "[report]") {
  const TemporaryDirectory directory;
  const Comparison comparison = pair_of(directory, "a.png", 1);
  for (const Image<Rgba8>& other :
       {grey(17, 8), grey(16, 8)}) {  // of another size, or other pixels
    REQUIRE(write_image(comparison.test.path, other));
    const Page page = page_of(directory, {comparison});
    const Json& pair = page.manifest["pairs"][0];
    CHECK(!pair.contains("pictures"));
    CHECK(pair["left_out"].get<std::string>().find("changed") != std::string::npos);
  }
}

TEST_CASE("the worst pairs fill the page up to its limit; the others are numbers and a command",
          "[report]") {
  const TemporaryDirectory directory;
  const std::uint64_t one_pair = 16 * 8 * (3 + 3 + 1);  // RGB twice, and the heat map
  const std::vector<Comparison> comparisons = {pair_of(directory, "b.png", 2),
                                               pair_of(directory, "c.png", 1),
                                               pair_of(directory, "a.png", 3)};
  for (std::size_t room = 0; room <= 3; ++room) {
    PageOptions options;
    options.max_bytes = one_pair * room + one_pair / 2;
    options.max_crop_bytes = 0;
    const Page page = page_of(directory, comparisons, options);
    for (std::size_t i = 0; i < 3; ++i) {
      INFO("room for " << room << " pairs, pair " << i);
      const Json& pair = page.manifest["pairs"][i];
      CHECK(pair["name"] == std::vector<std::string>{"a.png", "b.png", "c.png"}[i]);
      CHECK(pair.contains("pictures") == (i < room));
      CHECK(pair.contains("left_out") == (i >= room));
      CHECK(pair["differences"]["differing_pixels"] == 1);
      CHECK(pair.contains("thumbnail"));
      if (i >= room) {
        CHECK(pair["alone_command"].get<std::string>().find(comparisons[0].reference.path.substr(
                  0, directory.path().string().size())) != std::string::npos);
      }
    }
  }
}

TEST_CASE(
    "of pictures beyond the limit the page has crops, and they have the pixels of their place",
    "[report]") {
  const TemporaryDirectory directory;
  const Comparison comparison = pair_of(directory, "a.png", 5, 300, 200);
  PageOptions options;
  options.crops = {.whole_pixels = 1000, .side = 40, .count = 8};
  const Page page = page_of(directory, {comparison}, options);
  const Json& test = page.manifest["pairs"][0]["pictures"]["test"];
  const auto tiles = tiles_of(test);
  REQUIRE(tiles.size() == 1);
  CHECK(test["width"] == 300);
  CHECK(tiles[0].width <= 40);
  CHECK(tiles[0].height <= 40);
  const auto samples = bytes_of(page, test);
  const int at = ((2 - tiles[0].y) * tiles[0].width + (3 - tiles[0].x)) * 3;
  CHECK(samples[std::size_t(at) + 1] == 115);
  CHECK(std::count(samples.begin(), samples.end(), std::uint8_t(115)) == 1);
}

TEST_CASE("a page has small crops of the pairs beyond its limit, up to the crops' own limit",
          "[report]") {
  const TemporaryDirectory directory;
  const std::vector<Comparison> comparisons = {pair_of(directory, "b.png", 2, 300, 200),
                                               pair_of(directory, "a.png", 3, 300, 200)};
  PageOptions options;
  options.max_bytes = 0;
  options.small_crops = {.whole_pixels = 100, .side = 20, .count = 2};
  options.max_crop_bytes = 7 * 13 * 12;  // of one crop: RGB twice, and the heat map
  const Page page = page_of(directory, comparisons, options);
  const Json& worst = page.manifest["pairs"][0];
  CHECK(worst.contains("left_out"));
  const auto tiles = tiles_of(worst["pictures"]["test"]);
  REQUIRE(tiles.size() == 1);
  CHECK(tiles[0] == PixelBox{0, 0, 13, 12});  // 20 x 20 around (3, 2), as far as there are pixels
  const auto samples = bytes_of(page, worst["pictures"]["test"]);
  const int at = ((2 - tiles[0].y) * tiles[0].width + (3 - tiles[0].x)) * 3;
  CHECK(samples[std::size_t(at) + 1] == 113);
  CHECK(!page.manifest["pairs"][1].contains("pictures"));
  CHECK(page.manifest["pairs"][1].contains("left_out"));
  options.max_crop_bytes *= 2;
  CHECK(page_of(directory, comparisons, options).manifest["pairs"][1].contains("pictures"));
}

TEST_CASE("small pictures beyond the page's limit are whole, and nothing is said to be left out",
          "[report]") {
  const TemporaryDirectory directory;
  const Comparison canvas = compare_files(pair_of(directory, "tall.png", 1, 10, 30).reference.path,
                                          pair_of(directory, "wide.png", 1, 20, 20).test.path);
  const std::vector<Comparison> comparisons = {pair_of(directory, "a.png", 2, 24, 25), canvas};
  for (const bool files_beside : {false, true}) {
    PageOptions options;
    options.max_bytes = 0;
    options.files_beside = files_beside;
    options.small_crops = {.whole_pixels = 600, .side = 20, .count = 2};
    const Page page = page_of(directory, comparisons, options);
    for (const Json& pair : page.manifest["pairs"]) {
      INFO(pair["name"]);
      REQUIRE(pair.contains("pictures"));
      CHECK(!pair.contains("left_out"));
      CHECK(!pair.contains("beside"));
      for (const Json& picture : pair["pictures"]) CHECK(tiles_of(picture).size() == 1);
    }
    CHECK(!std::filesystem::exists(directory.file("page-files")));
    // Without room for them in the page, they are as other pictures.
    options.max_crop_bytes = 0;
    const Page full = page_of(directory, comparisons, options);
    for (const Json& pair : full.manifest["pairs"]) {
      CHECK(!pair.contains("pictures"));
      CHECK(pair.contains(files_beside ? "beside" : "left_out"));
    }
    std::filesystem::remove_all(directory.file("page-files"));
  }
}

TEST_CASE("a page shows the pixels that a comparison kept, without a copy of them", "[report]") {
  const TemporaryDirectory directory;
  const Comparison comparison = pair_of(directory, "a.png", 2);
  CompareOptions options;
  options.keep_pixels = true;
  const Comparison kept = compare_files(comparison.reference.path, comparison.test.path, options);
  REQUIRE(kept.pixels);
  const std::vector<PagePicture> pictures = page_pictures(kept);
  REQUIRE(pictures.size() == 3);
  CHECK(pictures[0].image.get() == &kept.pixels->reference);
  CHECK(pictures[1].image.get() == &kept.pixels->test);
}

TEST_CASE("a file that no page wrote is found before anything is written", "[report]") {
  const TemporaryDirectory directory;
  PageOptions options;
  options.files_beside = true;
  options.small_crops = {.whole_pixels = 100, .side = 20, .count = 2};
  const std::vector<Comparison> comparisons = {pair_of(directory, "b.png", 2, 300, 200),
                                               pair_of(directory, "a.png", 3, 300, 200)};
  std::filesystem::create_directory(directory.file("page-files"));
  std::ofstream(directory.file("page-files/0002.js")) << "let own = 1;";
  REQUIRE(!write_page(directory.file("page.html"), comparisons, options));
  CHECK(!std::filesystem::exists(directory.file("page-files/0001.js")));
  CHECK(!std::filesystem::exists(directory.file("page.html")));
  CHECK(text_of(directory.file("page-files/0002.js")) == "let own = 1;");
}

TEST_CASE("a page with fewer pairs leaves no pictures of the others beside it", "[report]") {
  const TemporaryDirectory directory;
  PageOptions options;
  options.files_beside = true;
  options.small_crops = {.whole_pixels = 100, .side = 20, .count = 2};
  std::vector<Comparison> comparisons = {pair_of(directory, "b.png", 2, 300, 200),
                                         pair_of(directory, "a.png", 3, 300, 200)};
  page_of(directory, comparisons, options);
  CHECK(std::filesystem::exists(directory.file("page-files/0002.js")));
  comparisons.pop_back();
  page_of(directory, comparisons, options);
  CHECK(std::filesystem::exists(directory.file("page-files/0001.js")));
  CHECK(!std::filesystem::exists(directory.file("page-files/0002.js")));
}

TEST_CASE("a page has no crop of a new picture, which would be any corner of it", "[report]") {
  const TemporaryDirectory directory;
  PageOptions options;
  options.max_bytes = 0;
  options.small_crops = {.whole_pixels = 20 * 20, .side = 20, .count = 2};
  for (const auto& [name, width, has_crop] :
       {std::tuple("small.png", 20, true), std::tuple("large.png", 300, false)}) {
    const Comparison pair = pair_of(directory, name, 1, width, 20);
    const Page page =
        page_of(directory, {compare_files(directory.file("nothing.png"), pair.test.path)}, options);
    INFO(name);
    CHECK(page.manifest["pairs"][0].contains("pictures") == has_crop);
    CHECK(page.manifest["pairs"][0].contains("thumbnail"));
  }
}

TEST_CASE("with files beside it, the page has addresses, and the files have the samples",
          "[report]") {
  const TemporaryDirectory directory;
  PageOptions options;
  options.files_beside = true;
  options.small_crops = {.whole_pixels = 100, .side = 20, .count = 2};
  const std::vector<Comparison> comparisons = {pair_of(directory, "b.png", 2, 300, 200),
                                               pair_of(directory, "same.png", 0),
                                               pair_of(directory, "a.png", 3, 300, 200)};
  const Page page = page_of(directory, comparisons, options);
  CHECK(page.text.find("' 'self' file:; ") != std::string::npos);
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& pair = page.manifest["pairs"][i];
    const Json& beside = pair["beside"];
    CHECK(beside["address"] == "page-files/000" + std::to_string(i + 1) + ".js");
    CHECK(beside["path"] == beside["address"]);
    CHECK(tiles_of(pair["pictures"]["test"])[0].width <= 20);
    const std::string file = text_of(directory.file(beside["address"].get<std::string>()));
    const auto comma = file.find(',');
    REQUIRE(file.substr(0, comma) ==
            "glassboxPictures(\"" + beside["stamp"].get<std::string>() + "\"");
    const Json blobs = Json::parse(file.substr(comma + 1, file.rfind(')') - comma - 1));
    const Json& test = beside["pictures"]["test"];
    const auto samples = test::decode_blob<std::uint8_t>(blobs["test"].get<std::string>(),
                                                         tiles_of(test), test["channels"]);
    const auto expected = read_stored(directory.file("test-" + std::string(pair["name"])));
    REQUIRE(expected);
    CHECK(samples == std::get<std::vector<std::uint8_t>>(expected->samples));
  }
  CHECK(!page.manifest["pairs"][2].contains("beside"));
}

TEST_CASE("a name that a list of names cannot have says why", "[report]") {
  const TemporaryDirectory directory;
  const auto why_not = [&](const std::string& name) {
    Comparison comparison = pair_of(directory, "a.png", 1);
    comparison.name = name;
    const Json pair = page_of(directory, {comparison}).manifest["pairs"][0];
    return pair.contains("not_listed") ? pair["not_listed"].get<std::string>() : "";
  };
  CHECK(why_not("a\nb.png").find("line break") != std::string::npos);
  CHECK(why_not("a\rb.png").find("line break") != std::string::npos);
  CHECK(why_not("\xff.png").find("UTF-8") != std::string::npos);
  CHECK(why_not(" # \t'\"\xc3\xa4.png").empty());
}

TEST_CASE("a page that cannot be written is an error with the path", "[report]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("no-such-folder/page.html");
  const auto written = write_page(path, std::vector{pair_of(directory, "a.png", 1)});
  REQUIRE(!written);
  CHECK(written.error().message().find("no-such-folder") != std::string::npos);
}

}  // namespace glassbox
