// Tests that solutions are removed from a file without a trace.
#include <string>

#include "labs/framework/strip_solution.h"
#include "tests/support/catch.h"

using namespace glassbox::labs;

namespace {

const std::string kSolution = R"(// Newell.
Vector newell(const Polygon& p) {
  // BEGIN SOLUTION
  Vector sum{};
  for (auto v : p) sum += v;
  return sum;
  // STUB: // Sum over the edges.
  // STUB: return {};
  // END SOLUTION
}
)";

std::string error_of(const std::string& text) {
  const auto stripped = strip_solution(text, "student.cpp");
  REQUIRE_FALSE(stripped);
  return stripped.error().message();
}

}  // namespace

TEST_CASE("a solution gives way to its stubs, with their indentation") {
  const auto stripped = strip_solution(kSolution, "student.cpp");
  REQUIRE(stripped);
  CHECK(
      *stripped ==
      "// Newell.\nVector newell(const Polygon& p) {\n  // Sum over the edges.\n  return {};\n}\n");
}

TEST_CASE("hidden parts leave without a stub") {
  const auto stripped = strip_solution("a\n// BEGIN HIDDEN\nb\n// END HIDDEN\nc\n", "cases.h");
  REQUIRE(stripped);
  CHECK(*stripped == "a\nc\n");
}

TEST_CASE("nested, unbalanced and stub-less markers are errors that name the line") {
  const std::string begin = "// BEGIN SOLUTION\n", stub = "// STUB: return;\n",
                    end = "// END SOLUTION\n";
  CHECK(error_of(begin + begin).find("line 2") != std::string::npos);
  CHECK(error_of("x\n" + begin + stub).find("line 2: a solution has no end") != std::string::npos);
  CHECK(error_of("x\n" + end).find("line 2") != std::string::npos);
  CHECK(error_of(begin + "code\n" + end).find("line 1: a solution has no // STUB: line") !=
        std::string::npos);
  CHECK(error_of(stub).find("line 1") != std::string::npos);
  CHECK(error_of(begin + stub + "// BEGIN HIDDEN\n").find("line 3") != std::string::npos);
  CHECK(error_of(begin + stub + "// END HIDDEN\n").find("line 3") != std::string::npos);
}

TEST_CASE("a marker that is almost right is an error, since it would hand the solution out") {
  for (const std::string line :
       {"// Begin Solution", "//BEGIN SOLUTION", "/* BEGIN SOLUTION */", "// BEGIN  SOLUTION",
        "// BEGIN SOLUTION: part 2", "// END SOLUTIONS", "//STUB: return;", "// begin hidden"}) {
    CAPTURE(line);
    CHECK(error_of("x\n" + line + "\n").find("line 2") != std::string::npos);
  }
}

TEST_CASE("carriage returns do not hide a marker") {
  const auto stripped =
      strip_solution("// BEGIN SOLUTION\r\nsecret\r\n// STUB: a;\r\n// END SOLUTION\r\n", "s");
  REQUIRE(stripped);
  CHECK(stripped->find("secret") == std::string::npos);
}

TEST_CASE("the proof finds every line of a solution that survives") {
  const auto stripped = strip_solution(kSolution, "student.cpp");
  CHECK(find_leaks(kSolution, *stripped).empty());
  const auto whole = find_leaks(kSolution, kSolution);
  CHECK(whole.size() >= 3);
  const auto one = find_leaks(kSolution, *stripped + "  return sum;\n");
  REQUIRE(one.size() == 1);
  CHECK(one[0].line == 6);
  CHECK(one[0].text == "return sum;");
}

TEST_CASE("a line that may be handed out once may not be handed out twice") {
  const std::string text =
      "return {};\n// BEGIN SOLUTION\nreturn {};\n// STUB: x;\n// END SOLUTION\n";
  CHECK(find_leaks(text, "return {};\nx;\n").empty());
  CHECK(find_leaks(text, "return {};\nx;\nreturn {};\n").size() == 1);
}
