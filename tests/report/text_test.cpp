// Comparisons as text.
#include "tests/support/catch.h"

#include <algorithm>
#include <string>
#include <vector>

#include "tests/report/comparisons.h"

#include <glassbox/compare/report/text.h>

namespace glassbox::test {
namespace {

TEST_CASE("a comparison is one line: the picture, the verdict, and why") {
  CHECK(comparison_line(comparison("a.png", Verdict::kSame)) == "a.png: same");
  CHECK(comparison_line(different("a.png")) == "a.png: different: 3 of 32 pixels differ");
  CHECK(comparison_line(without_test("a.png")) ==
        "a.png: missing: out/a.png: there is no such picture; render it");
  CHECK(comparison_line(without_reference("a.png")) ==
        "a.png: new: ref/a.png: there is no such reference; look at it");
  CHECK(comparison_line(broken("a.png")) ==
        "a.png: not compared: out/a.png: chunk 3: is cut off; save it again");
  Comparison within = different("a.png");
  within.verdict = Verdict::kWithinTolerance;
  CHECK(comparison_line(within) == "a.png: within tolerance: 3 of 32 pixels differ");
}

TEST_CASE("the details are a line each, in the order of their weight") {
  Comparison all = different("a.png");
  all.reasons.push_back("psnr is 10, not psnr>40");
  all.tolerance = "psnr>40";
  all.tolerance_reason = "noise";
  all.metrics = {{"psnr", 10.0, "", Limit{LimitKind::kAbove, 40}, false},
                 {"ssim.mean", std::nullopt, "too small", std::nullopt, true}};
  all.hints = {"a hint"};
  all.notes = {"a note"};
  all.inspect_command = "glassbox pixel cube --at 2,1";
  CHECK(comparison_details(all) ==
        "  and: psnr is 10, not psnr>40\n"
        "  tolerance: psnr>40\n"
        "  because: noise\n"
        "  psnr: 10\n"
        "  ssim.mean: not defined: too small\n"
        "  likely: a hint\n"
        "  note: a note\n"
        "  inspect: glassbox pixel cube --at 2,1\n");
}

TEST_CASE("a picture that passes and has nothing to tell has no details") {
  CHECK(comparison_details(comparison("a.png", Verdict::kSame)).empty());
}

TEST_CASE("names and words from files stay on their line") {
  Comparison hostile = different("a\nb\x1b[2J\x07.png");
  hostile.reasons = {"one\ntwo\x1b", "three\r\nfour"};
  hostile.hints = {"hint\n\x1b"};
  hostile.notes = {"note\n"};
  hostile.tolerance_reason = "why\nnot";
  const std::string line = comparison_line(hostile);
  CHECK(line.find_first_of("\n\r\x1b\x07") == std::string::npos);
  const std::string more = comparison_details(hostile);
  CHECK(std::count(more.begin(), more.end(), '\n') == 4);
  CHECK(more.find_first_of("\r\x1b") == std::string::npos);
  Comparison error = broken("a");
  error.error->cause = "x\ny\x1b";
  CHECK(comparison_line(error).find_first_of("\n\x1b") == std::string::npos);
}

TEST_CASE("long names are cut, commands are not") {
  Comparison longest = different(std::string(10000, 'n'));
  longest.inspect_command = "glassbox pixel " + std::string(9000, 's') + " --at 2,1";
  CHECK(comparison_line(longest).size() < 600);
  CHECK(comparison_details(longest) == "  inspect: " + longest.inspect_command + "\n");
}

TEST_CASE("the summary counts every verdict that there is") {
  const std::vector<Comparison> none;
  CHECK(summary_line(none) == "0 pictures");
  const std::vector<Comparison> one{comparison("a", Verdict::kSame)};
  CHECK(summary_line(one) == "1 picture: 1 same");
  std::vector<Comparison> all{comparison("a", Verdict::kSame),
                              comparison("b", Verdict::kSame),
                              comparison("c", Verdict::kWithinTolerance),
                              different("d"),
                              without_test("e"),
                              without_reference("f"),
                              broken("g")};
  CHECK(summary_line(all) ==
        "7 pictures: 2 same, 1 within tolerance, 1 different, 1 missing, 1 new, 1 not compared");
}

}  // namespace
}  // namespace glassbox::test
