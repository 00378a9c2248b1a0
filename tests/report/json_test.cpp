// The JSON of a comparison. These tests fix the schema, because other people's programs read it.
#include "tests/support/catch.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/report/comparisons.h"

#include <glassbox/compare/report/json.h>

namespace glassbox::test {
namespace {

using Json = nlohmann::ordered_json;

Json parsed(const char* text) {
  return Json::parse(text);
}

TEST_CASE("the report has a schema, counts of all verdicts, and the pictures in order") {
  const std::vector<Comparison> all{different("d"),
                                    comparison("a", Verdict::kSame),
                                    comparison("b", Verdict::kSame),
                                    without_test("e"),
                                    comparison("c", Verdict::kWithinTolerance),
                                    without_reference("f"),
                                    broken("g")};
  const Json json = json_report(all);
  CHECK(json["schema"] == "glassbox-diff-1");
  CHECK(json["summary"] == parsed(R"({"same": 2, "within-tolerance": 1, "different": 1, "new": 1,
                                      "missing": 1, "uncompared": 1})"));
  std::vector<std::string> names, verdicts;
  for (const Json& picture : json["pictures"]) {
    names.push_back(picture["name"]);
    verdicts.push_back(picture["verdict"]);
  }
  CHECK(names == std::vector<std::string>{"d", "a", "b", "e", "c", "f", "g"});
  CHECK(verdicts == std::vector<std::string>{"different", "same", "same", "missing",
                                             "within-tolerance", "new", "uncompared"});
  CHECK(json.size() == 3);
}

TEST_CASE("no pictures are an empty list and zeros") {
  const Json json = json_report({});
  CHECK(json["pictures"] == Json::array());
  for (const auto& [verdict, count] : json["summary"].items()) CHECK(count == 0);
  CHECK(json["summary"].size() == 6);
}

TEST_CASE("pictures that are the same are their facts and counts") {
  CHECK(to_json(comparison("a.png", Verdict::kSame)) == parsed(R"({
    "name": "a.png",
    "verdict": "same",
    "reference": {"path": "ref/a.png", "width": 8, "height": 4, "channels": "RGB", "format": "8 bits"},
    "test": {"path": "out/a.png", "width": 8, "height": 4, "channels": "RGB", "format": "8 bits"},
    "differences": {"compared_pixels": 32, "differing_pixels": 0, "largest": 0}
  })"));
}

TEST_CASE("everything that is known of a difference has its key") {
  Comparison all = different("a.png");
  all.metrics = {{"psnr", 10.5, "", Limit{LimitKind::kAbove, 40}, false},
                 {"rmse", 0.25, "", std::nullopt, true},
                 {"ssim.mean", std::nullopt, "too small", Limit{LimitKind::kAtLeast, 0.5}, false}};
  all.ignore = {{1, 2, 3, 4}};
  all.mask = "mask.png";
  all.tolerance = "psnr>40";
  all.tolerance_reason = "noise";
  all.reasons = {"one", "two"};
  all.hints = {"a hint"};
  all.notes = {"a note"};
  all.inspect_command = "glassbox pixel cube --at 2,1";
  const Json json = to_json(all);
  CHECK(json == parsed(R"({
    "name": "a.png",
    "verdict": "different",
    "reference": {"path": "ref/a.png", "width": 8, "height": 4, "channels": "RGB", "format": "8 bits"},
    "test": {"path": "out/a.png", "width": 8, "height": 4, "channels": "RGB", "format": "8 bits"},
    "differences": {
      "compared_pixels": 32, "differing_pixels": 3, "largest": 9,
      "first": {"x": 2, "y": 1},
      "box": {"x": 2, "y": 1, "width": 5, "height": 3},
      "region_count": 2,
      "regions": [
        {"box": {"x": 2, "y": 1, "width": 2, "height": 1}, "pixels": 2, "largest": 9, "worst": {"x": 3, "y": 1}},
        {"box": {"x": 6, "y": 3, "width": 1, "height": 1}, "pixels": 1, "largest": 4, "worst": {"x": 6, "y": 3}}
      ]
    },
    "metrics": [
      {"name": "psnr", "value": 10.5, "limit": "psnr>40", "passes": false},
      {"name": "rmse", "value": 0.25},
      {"name": "ssim.mean", "value": null, "why_not": "too small", "limit": "ssim.mean>=0.5", "passes": false}
    ],
    "ignore": [{"x": 1, "y": 2, "width": 3, "height": 4}],
    "mask": "mask.png",
    "tolerance": "psnr>40",
    "tolerance_reason": "noise",
    "reasons": ["one", "two"],
    "hints": ["a hint"],
    "notes": ["a note"],
    "inspect_command": "glassbox pixel cube --at 2,1"
  })"));
}

TEST_CASE("what could not be compared has its error, and no facts where nothing was read") {
  CHECK(to_json(broken("a.png")) == parsed(R"({
    "name": "a.png",
    "verdict": "uncompared",
    "error": {"file": "out/a.png", "place": "chunk 3", "cause": "is cut off", "remedy": "save it again"},
    "reference": {"path": "ref/a.png"},
    "test": {"path": "out/a.png"}
  })"));
}

TEST_CASE("a distance without end is a word, and so are the numbers that JSON does not have") {
  Comparison odd = different("a.pfm");
  odd.differences->largest = kUnbounded;
  odd.differences->regions[0].largest = kUnbounded;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  odd.metrics = {{"psnr", kInfinity, "", std::nullopt, true},
                 {"psnr", -kInfinity, "", std::nullopt, true},
                 {"rmse", std::nan(""), "", std::nullopt, true}};
  const Json json = Json::parse(to_json(odd).dump());
  CHECK(json["differences"]["largest"] == "unbounded");
  CHECK(json["differences"]["regions"][0]["largest"] == "unbounded");
  CHECK(json["differences"]["regions"][1]["largest"] == 4);
  CHECK(json["metrics"][0]["value"] == "inf");
  CHECK(json["metrics"][1]["value"] == "-inf");
  CHECK(json["metrics"][2]["value"] == "nan");
}

TEST_CASE("counts above 32 bits stay what they are") {
  Comparison large = different("a.png");
  large.differences->differing = std::uint64_t(1) << 40;
  CHECK(Json::parse(to_json(large).dump())["differences"]["differing_pixels"] == std::uint64_t(1)
                                                                                     << 40);
}

TEST_CASE("every verdict has its word") {
  CHECK(std::string(verdict_word(Verdict::kSame)) == "same");
  CHECK(std::string(verdict_word(Verdict::kWithinTolerance)) == "within-tolerance");
  CHECK(std::string(verdict_word(Verdict::kDifferent)) == "different");
  CHECK(std::string(verdict_word(Verdict::kNew)) == "new");
  CHECK(std::string(verdict_word(Verdict::kMissing)) == "missing");
  CHECK(std::string(verdict_word(Verdict::kUncompared)) == "uncompared");
}

}  // namespace
}  // namespace glassbox::test
