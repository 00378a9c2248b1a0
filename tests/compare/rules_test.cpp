// Tests how options and a sidecar are combined, and notes about tolerances that are wider than
// needed.
#include "tests/support/catch.h"
#include "tests/support/contains.h"

#include <string>
#include <vector>

#include <glassbox/compare/pictures/rules.h>

namespace glassbox::test {
namespace {

Sidecar sidecar(const std::string& text) {
  const auto parsed = parse_sidecar("a.png.fuzzy", text + "\nreason: ties\n");
  REQUIRE(parsed);
  return *parsed;
}

Differences differences(std::uint32_t largest, std::uint64_t pixels) {
  Differences found;
  found.largest = largest;
  found.differing = pixels;
  return found;
}

std::string stale(const std::string& text, const Differences& found) {
  std::vector<std::string> notes;
  return stale_tolerance_text(combine_rules({}, sidecar(text), notes), found);
}

TEST_CASE("without options the sidecar's rules apply") {
  std::vector<std::string> notes;
  const ComparisonRules rules = combine_rules(
      {}, sidecar("fuzzy: 0-1;0-4\nmax-ulp: 2\nmetric: psnr>40\nignore: 1,2,3x4\nmask: m.png"),
      notes);
  CHECK(rules.tolerance_of_sidecar);
  CHECK(rules.reason == "ties");
  CHECK(rules.options.ignore == std::vector<PixelBox>{{1, 2, 3, 4}});
  CHECK(rules.options.mask == "m.png");
  CHECK(tolerance_text(rules.options) == "maxDifference=0-1;totalPixels=0-4, 2 ulps, psnr>40");
  CHECK(notes.empty());
}

TEST_CASE("a tolerance among the options overrules the sidecar's, with a note") {
  CompareOptions fuzzy, ulps, metric;
  fuzzy.tolerance.fuzzy = Fuzzy{{0, 9}, {0, 9}};
  ulps.tolerance.max_ulp = 9;
  metric.metrics = *parse_metrics("psnr>10");
  for (const CompareOptions& options : {fuzzy, ulps, metric}) {
    std::vector<std::string> notes;
    const ComparisonRules rules = combine_rules(
        options, sidecar("fuzzy: 0-1;0-4\nmetric: psnr>40\nignore: 1,2,3x4\nmask: m.png"), notes);
    CHECK(!rules.tolerance_of_sidecar);
    CHECK(rules.reason.empty());
    CHECK(tolerance_text(rules.options) == tolerance_text(options));
    // The choice of compared pixels stays the same.
    CHECK(rules.options.ignore == std::vector<PixelBox>{{1, 2, 3, 4}});
    CHECK(rules.options.mask == "m.png");
    REQUIRE(notes.size() == 1);
    CHECK(contains(notes[0], "a.png.fuzzy"));
    CHECK(contains(notes[0], "is not used"));
  }
}

TEST_CASE("a sidecar without a tolerance has none to overrule") {
  CompareOptions options;
  options.tolerance.fuzzy = Fuzzy{{0, 9}, {0, 9}};
  std::vector<std::string> notes;
  combine_rules(options, sidecar("ignore: 1,2,3x4\nmetric: rmse"), notes);
  CHECK(notes.empty());
}

TEST_CASE("a metric that is only reported overrules nothing") {
  CompareOptions options;
  options.metrics = *parse_metrics("rmse");
  std::vector<std::string> notes;
  const ComparisonRules rules = combine_rules(options, sidecar("fuzzy: 0-1;0-4"), notes);
  CHECK(rules.tolerance_of_sidecar);
  CHECK(notes.empty());
}

TEST_CASE("boxes add up, and a mask given takes the place of the sidecar's") {
  CompareOptions options;
  options.ignore = {{9, 9, 1, 1}};
  options.mask = "mine.png";
  std::vector<std::string> notes;
  const ComparisonRules rules =
      combine_rules(options, sidecar("ignore: 1,2,3x4\nmask: m.png"), notes);
  CHECK(rules.options.ignore == std::vector<PixelBox>{{9, 9, 1, 1}, {1, 2, 3, 4}});
  CHECK(rules.options.mask == "mine.png");
}

TEST_CASE("without a sidecar the options stand as they are") {
  CompareOptions options;
  options.tolerance.max_ulp = 3;
  std::vector<std::string> notes;
  const ComparisonRules rules = combine_rules(options, std::nullopt, notes);
  CHECK(!rules.tolerance_of_sidecar);
  CHECK(tolerance_text(rules.options) == "3 ulps");
  CHECK(tolerance_text({}).empty());
}

TEST_CASE("a tolerance that is used up to its ends is not stale") {
  CHECK(stale("fuzzy: 0-3;0-7", differences(3, 7)).empty());
  CHECK(stale("fuzzy: 3;7", differences(3, 7)).empty());
  CHECK(stale("fuzzy: 1-3;2-7", differences(3, 7)).empty());
  CHECK(stale("max-ulp: 3", differences(3, 7)).empty());
  CHECK(stale("fuzzy: 0-3;0-7\nmax-ulp: 3", differences(3, 7)).empty());
  CHECK(stale("metric: rmse<0.5", differences(3, 7)).empty());
  CHECK(stale("ignore: 1,2,3x4", differences(0, 0)).empty());
  CHECK(stale("metric: rmse", differences(0, 0)).empty());
}

TEST_CASE("a tolerance wider than needed is stale, and the one that is enough is named") {
  for (const char* text : {"fuzzy: 0-4;0-7", "fuzzy: 0-3;0-8", "fuzzy: 0-99;0-99"}) {
    const std::string note = stale(text, differences(3, 7));
    INFO(note);
    CHECK(contains(note, "stale"));
    CHECK(contains(note, "a.png.fuzzy"));
    CHECK(contains(note, "maxDifference=0-3;totalPixels=0-7"));
    // A sidecar that follows this advice gives no further note.
    CHECK(stale("fuzzy: maxDifference=0-3;totalPixels=0-7", differences(3, 7)).empty());
  }
  const std::string ulps = stale("max-ulp: 4", differences(3, 7));
  CHECK(contains(ulps, "max-ulp: 3"));
  const std::string both = stale("fuzzy: 0-9;0-9\nmax-ulp: 4", differences(3, 7));
  CHECK(contains(both, "maxDifference=0-3;totalPixels=0-7"));
  CHECK(contains(both, "max-ulp: 3"));
  const std::string one = stale("fuzzy: 0-3;0-7\nmax-ulp: 4", differences(3, 7));
  CHECK(!contains(one, "maxDifference"));
  CHECK(contains(one, "max-ulp: 3"));
}

TEST_CASE("the share that is enough is enough, and no smaller one is") {
  Random random(66);
  for (int round = 0; round < 300; ++round) {
    Differences found = differences(3, std::uint64_t(random.integer(1, 5000)));
    found.compared = found.differing + std::uint64_t(random.integer(0, 100000));
    INFO("seed 66, round " << round << ": " << found.differing << " of " << found.compared);
    const MaxDiffering enough = tightest_like({0, 100000000}, found);
    CHECK(allows(enough, found));
    CHECK(!allows(MaxDiffering{0, *enough.share - 1}, found));
    CHECK(stale("max-differing: " + to_string(enough), found).empty());
    if (*enough.share == 100000000) continue;
    CHECK(contains(stale("max-differing: 100%", found), "max-differing: " + to_string(enough)));
  }
}

TEST_CASE("moved edges that there are none of need no line") {
  Differences found = differences(3, 7);
  CHECK(contains(stale("ignore-antialiasing: yes\nmax-differing: 7", found),
                 "enough is no ignore-antialiasing"));
  found.moved_edges = {4, 9};
  CHECK(stale("ignore-antialiasing: yes\nmax-differing: 7", found).empty());
}

TEST_CASE("a tolerance of pictures that are the same is not needed") {
  for (const char* text :
       {"fuzzy: 0-4;0-7", "fuzzy: 0;0", "max-ulp: 0", "max-ulp: 4", "metric: flip.mean<0.05"}) {
    const std::string note = stale(text, differences(0, 0));
    INFO(text << ": " << note);
    CHECK(contains(note, "stale"));
    CHECK(contains(note, "not needed"));
    CHECK(contains(note, "delete the file"));
  }
}

TEST_CASE("a sidecar that also says what to leave out is not to be deleted") {
  for (const char* text : {"fuzzy: 0-4;0-7\nignore: 1,2,3x4", "fuzzy: 0-4;0-7\nmask: m.png"}) {
    const std::string note = stale(text, differences(0, 0));
    INFO(text << ": " << note);
    CHECK(contains(note, "not needed"));
    CHECK(!contains(note, "delete the file"));
  }
}

}  // namespace
}  // namespace glassbox::test
