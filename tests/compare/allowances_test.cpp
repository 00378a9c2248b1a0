// Tests the short forms of tolerances: thresholds, numbers and shares of pixels, and moved edges;
// as text, in sidecars, and in verdicts.
#include "tests/support/catch.h"

#include <limits>
#include <string>
#include <vector>

#include "tests/compare/moved_edges.h"
#include "tests/compare/pictures.h"
#include "tests/images/temporary_directory.h"

#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pictures/rules.h>
#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/compare/pixels/tolerance.h>
#include <glassbox/compare/report/heat_map_file.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::test {
namespace {

MaxDiffering most(const std::string& text) {
  INFO(text);
  const auto parsed = parse_max_differing(text);
  REQUIRE(parsed);
  return *parsed;
}

Differences differing(std::uint64_t pixels, std::uint64_t compared, std::uint32_t largest = 255) {
  Differences found;
  found.compared = compared;
  found.differing = pixels;
  found.largest = largest;
  return found;
}

TEST_CASE("a number of pixels and a share of them are read and written") {
  CHECK(most("0") == MaxDiffering{0, {}});
  CHECK(most(" 12 ") == MaxDiffering{12, {}});
  CHECK(most("0.1%").share == 100000u);
  CHECK(most("100%").share == 100000000u);
  CHECK(most(" 0.1 % ").share == 100000u);
  for (const char* text : {"0", "12", "0.1%", "100%", "0%", "0.000001%", "12.5%", "3%"}) {
    CHECK(to_string(most(text)) == text);
  }
  for (const char* text : {"", "%", "-1", "1.5", "101%", "100.000001%", "0.0000001%", "1e2", "1.%",
                           ".5%", "1%%", "1 %x", "0x4", "nan", "-0.1%", "0. 5%", "0 .5%", "1 2%"}) {
    INFO(text);
    const auto refused = parse_max_differing(text);
    REQUIRE(!refused);
    CHECK(refused.error().cause.find("not a number of pixels") == 0);
  }
}

TEST_CASE("a share is exact at its end") {
  // 0.1 % of 1000 and 30 % of 10, where floating point would be in doubt.
  CHECK(allows(most("0.1%"), differing(1, 1000)));
  CHECK(!allows(most("0.1%"), differing(1, 999)));
  CHECK(allows(most("30%"), differing(3, 10)));
  CHECK(!allows(most("29.999999%"), differing(3, 10)));
  CHECK(allows(most("100%"), differing(std::uint64_t(1) << 28, std::uint64_t(1) << 28)));
  CHECK(!allows(most("99.999999%"), differing(std::uint64_t(1) << 28, std::uint64_t(1) << 28)));
  CHECK(allows(most("12"), differing(12, 100)));
  CHECK(!allows(most("12"), differing(13, 100)));
  CHECK(!allows(most("100%"), differing(1, 100, kUnbounded)));
}

TEST_CASE("a threshold is a number from 0 to 1") {
  CHECK(parse_threshold("0.1") == 0.1);
  CHECK(parse_threshold("0") == 0.0);
  CHECK(parse_threshold("1") == 1.0);
  for (const char* text : {"", "-0.1", "1.01", "nan", "inf", "0,1", "10%", "1e-1", "x"}) {
    INFO(text);
    CHECK(!parse_threshold(text));
  }
}

// a.png, and b.png with `changes` pixels that are 40 steps greener.
class GreenFiles {
public:
  explicit GreenFiles(int changes) {
    StoredImage image = blank(40, 30, 3, Format::kBytes);
    write("a.png", image);
    for (int i = 0; i < changes; ++i) set_sample(image, 3 * (i % 13), 3 * (i / 13), 1, 40);
    write("b.png", image);
  }
  Comparison compare(const CompareOptions& options) const {
    return compare_files(file("a.png"), file("b.png"), options);
  }
  void write(const std::string& name, const StoredImage& image) const {
    REQUIRE(write_file(file(name), *encode_png(image)));
  }
  void write_sidecar(const std::string& text) const {
    REQUIRE(write_file(file("a.png.fuzzy"), std::as_bytes(std::span(text))));
  }
  std::string file(const std::string& name) const { return directory_.file(name); }

private:
  TemporaryDirectory directory_;
};

Tolerance tolerance(std::optional<double> threshold, const std::string& max_differing = "") {
  Tolerance limits;
  limits.set_aside.threshold = threshold;
  if (!max_differing.empty()) limits.max_differing = most(max_differing);
  return limits;
}

TEST_CASE("the verdict follows from the threshold and from the number of pixels") {
  const GreenFiles files(12);  // 1 % of 1200 pixels; 40 steps of green are 0.096 apart
  const auto verdict = [&](const Tolerance& limits) {
    CompareOptions options;
    options.tolerance = limits;
    return files.compare(options).verdict;
  };
  CHECK(verdict({}) == Verdict::kDifferent);
  CHECK(verdict(tolerance(0.11)) == Verdict::kWithinTolerance);
  CHECK(verdict(tolerance(0.08)) == Verdict::kDifferent);
  CHECK(verdict(tolerance({}, "12")) == Verdict::kWithinTolerance);
  CHECK(verdict(tolerance({}, "11")) == Verdict::kDifferent);
  CHECK(verdict(tolerance({}, "1%")) == Verdict::kWithinTolerance);
  CHECK(verdict(tolerance({}, "0.99%")) == Verdict::kDifferent);
  CHECK(verdict(tolerance(0.08, "12")) == Verdict::kWithinTolerance);
  CHECK(verdict(tolerance(0.08, "11")) == Verdict::kDifferent);
  Tolerance both = tolerance(0.11);
  both.fuzzy = Fuzzy{{0, 0}, {0, 0}};
  CHECK(verdict(both) == Verdict::kWithinTolerance);
}

TEST_CASE("what is set aside is said, also where the pictures pass") {
  const GreenFiles files(12);
  CompareOptions options;
  options.tolerance = tolerance(0.11);
  const Comparison found = files.compare(options);
  CHECK(found.reasons ==
        std::vector<std::string>{"none of 1200 pixels differs, except those set aside: 12 pixels "
                                 "below the threshold (by up to 40/255)"});
  CHECK(found.tolerance == "threshold 0.11");
}

TEST_CASE("moved edges pass only where they are to be ignored, and are counted") {
  const GreenFiles files(0);
  const MovedPair pair = moved_pair("large-light-text", 0.3, 0, 3, 120, 80);
  files.write("a.png", pair.reference);
  files.write("b.png", pair.test);
  CompareOptions options;
  CHECK(files.compare(options).verdict == Verdict::kDifferent);
  options.tolerance.set_aside.moved_edges = true;
  const Comparison found = files.compare(options);
  INFO(found.reasons[0]);
  CHECK(found.verdict == Verdict::kWithinTolerance);
  REQUIRE(found.differences);
  CHECK(found.differences->differing == 0);
  CHECK(found.differences->moved_edges.pixels > 500);
  CHECK(found.reasons[0].find("pixels at moved edges (by up to ") != std::string::npos);
  const auto levels = heat_levels(found);
  REQUIRE(levels);
  CHECK(std::uint64_t(std::count(levels->pixels.begin(), levels->pixels.end(), kHeatMovedEdge)) ==
        found.differences->moved_edges.pixels);
  // The same pictures with a pixel that changed on the plain ground fail.
  StoredImage changed = pair.test;
  set_sample(changed, 0, 0, 1, 255);
  files.write("b.png", changed);
  const Comparison one = files.compare(options);
  CHECK(one.verdict == Verdict::kDifferent);
  CHECK(one.differences->differing == 1);
}

TEST_CASE("suggested options allow the pictures, and still do when they come nearer") {
  const GreenFiles files(12);
  CompareOptions options;
  options.suggest_tolerance = true;
  const Comparison found = files.compare(options);
  REQUIRE(found.suggestions.size() == 2);
  CHECK(found.suggestions[0] == "fuzzy: maxDifference=0-40;totalPixels=0-12");
  const std::string start = "short: --max-differing 12, or --threshold ";
  REQUIRE(found.suggestions[1].find(start) == 0);
  const auto threshold = parse_threshold(found.suggestions[1].substr(start.size()));
  REQUIRE(threshold);
  for (const int changes : {12, 5, 1, 0}) {
    const GreenFiles nearer(changes);
    CompareOptions fuzzy, share, distance;
    fuzzy.tolerance.fuzzy = *parse_fuzzy(found.suggestions[0].substr(7));
    share.tolerance = tolerance({}, "12");
    distance.tolerance = tolerance(*threshold);
    for (const CompareOptions& one : {fuzzy, share, distance}) {
      CHECK(passes(nearer.compare(one).verdict));
    }
  }
  CompareOptions tighter;
  tighter.tolerance = tolerance(*threshold - 0.0001);
  CHECK(files.compare(tighter).verdict == Verdict::kDifferent);
}

TEST_CASE("nothing is suggested where a metric fails") {
  const GreenFiles files(12);
  CompareOptions options;
  options.suggest_tolerance = true;
  options.metrics = *parse_metrics("psnr>1000");
  CHECK(files.compare(options).suggestions ==
        std::vector<std::string>{"no suggestion: a metric does not keep its limit"});
  options.metrics = *parse_metrics("psnr>1");
  CHECK(files.compare(options).suggestions.size() == 2);
}

TEST_CASE("NaN is no pixel that a number of pixels allows, and the reason says so") {
  const TemporaryDirectory directory;
  StoredImage numbers = blank(4, 3, 1, Format::kFloats), one = numbers;
  set_sample(one, 2, 1, 0, std::numeric_limits<double>::quiet_NaN());
  const std::string a = directory.file("a.pfm"), b = directory.file("b.pfm");
  REQUIRE(write_file(a, *encode_pfm(numbers)));
  REQUIRE(write_file(b, *encode_pfm(one)));
  CompareOptions options;
  options.tolerance = tolerance({}, "12");
  const Comparison found = compare_files(a, b, options);
  CHECK(found.verdict == Verdict::kDifferent);
  REQUIRE(!found.reasons.empty());
  CHECK(found.reasons[0].find("no number of pixels allows NaN") != std::string::npos);
}

TEST_CASE("a sidecar has the short forms, too") {
  const GreenFiles files(12);
  files.write_sidecar("threshold: 0.08\nmax-differing: 20\nignore-antialiasing: yes\nreason: r\n");
  const Comparison found = files.compare({});
  CHECK(found.verdict == Verdict::kWithinTolerance);
  CHECK(found.tolerance == "threshold 0.08, at most 20 differing pixels, moved edges are ignored");
  REQUIRE(found.notes.size() == 1);
  CHECK(found.notes[0].find("enough is max-differing: 12") != std::string::npos);
  files.write_sidecar("threshold: 0.11\nreason: r\n");
  CHECK(files.compare({}).verdict == Verdict::kWithinTolerance);
  // It is needed, although no pixel counts as different.
  CHECK(files.compare({}).notes.empty());
  for (const char* text : {"threshold: 2\nreason: r", "threshold: 0.1\nthreshold: 0.1\nreason: r",
                           "max-differing: x\nreason: r", "ignore-antialiasing: no\nreason: r",
                           "max-differing: 1\nmax-differing: 1\nreason: r"}) {
    INFO(text);
    files.write_sidecar(text);
    CHECK(files.compare({}).verdict == Verdict::kUncompared);
  }
}

}  // namespace
}  // namespace glassbox::test
