// Tests how the first place where an answer differs is found, and what kind of difference it is.
#include <cmath>
#include <limits>

#include "labs/framework/compare.h"
#include "labs/framework/divergence_text.h"
#include "tests/support/catch.h"

using namespace glassbox::labs;
using Kind = Divergence::Kind;

namespace {

Expected field(Shape shape, std::vector<double> values, double bound = 0, int columns = 0) {
  return {"f", shape, std::move(values), bound, "px", columns};
}

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("an answer within its bound is right, and one just outside is not") {
  const Expected expected = field(Shape::kPoint, {1, 2, 3}, 0.5);
  CHECK_FALSE(compare(expected, {1.5, 2, 2.5}).first);
  const auto result = compare(expected, {1, 2, std::nextafter(3.5, 4.0)});
  REQUIRE(result.first);
  CHECK(result.first->kind == Kind::kPosition);
  CHECK(result.first->index == 2);
  CHECK(result.first->element == "z");
  CHECK(result.first->unit == "px");
  CHECK(result.differing == 1);
}

TEST_CASE("each number has the bound of its own that an expected field gives it") {
  const Expected expected = with_bounds(field(Shape::kMatrix, {1e6, 1, 0}, 0, 3), {1, 1e-6, 0});
  CHECK(expected.bound == 1);
  const auto of = [](std::vector<double> values) {
    Answer answer;
    answer.emit("f", std::move(values));
    return answer;
  };
  const auto first = compare(expected, of({1e6 + 1, 1.5, 0})).first;
  REQUIRE(first);
  CHECK(first->element == "row 0, column 1");
  CHECK(first->bound == 1e-6);
  CHECK(has_field(of(expected.values), expected));
  CHECK(has_field(of({1e6 - 1, 1 + 0.9e-6, -0.0}), expected));
  CHECK_FALSE(has_field(of({1e6, 1, 1e-300}), expected));
  CHECK_FALSE(has_field(of({1e6, 1}), expected));
  CHECK(judge_nearly(expected, of({1e6 + 0.5, 1, 0})) == true);
  CHECK(judge_nearly(expected, of({1e6 + 0.5, 1 + 1e-6, 0})) == std::nullopt);
  CHECK(judge_nearly(expected, of({1e6 + 1, 1 + 3e-6, 0})) == false);
  CHECK(judge_nearly(expected, of({1e6, 1, 1e-300})) == false);
}

TEST_CASE("without a bound one float apart is one ulp, and a zero has no sign") {
  const float next = std::nextafter(1.0f, 2.0f);
  const auto result = compare(field(Shape::kNumbers, {1}), {double(next)});
  REQUIRE(result.first);
  CHECK(result.first->ulps == 1);
  CHECK(result.first->kind == Kind::kData);
  CHECK_FALSE(compare(field(Shape::kNumbers, {0}), {-0.0}).first);
}

TEST_CASE("NaN is named as such, unless it is expected") {
  CHECK(compare(field(Shape::kPoint, {1, 2, 3}, 1e9), {1, kNan, 3}).first->kind ==
        Kind::kNotANumber);
  CHECK_FALSE(compare(field(Shape::kNumbers, {kNan}), {kNan}).first);
  CHECK(compare(field(Shape::kNumbers, {kNan}), {1}).first);
  CHECK_FALSE(compare(field(Shape::kNumbers, {kInfinity}), {kInfinity}).first);
  CHECK(compare(field(Shape::kNumbers, {kInfinity}, 1), {-kInfinity}).first);
}

TEST_CASE("matrix elements are named by row and column, counted from 0") {
  std::vector<double> identity(16, 0);
  for (std::size_t i = 0; i < 16; i += 5) identity[i] = 1;
  std::vector<double> wrong = identity;
  wrong[6] = 9;
  CHECK(compare(field(Shape::kMatrix, identity), wrong).first->element == "row 1, column 2");
}

TEST_CASE("a polygon with too few vertices misses one, with too many has one extra") {
  const Expected triangle = field(Shape::kPolygon, {0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1}, 0, 4);
  const auto fewer = compare(triangle, {0, 0, 0, 1, 1, 0, 0, 1});
  REQUIRE(fewer.first);
  CHECK(fewer.first->kind == Kind::kMissing);
  CHECK(fewer.first->element == "vertex 2, x");
  CHECK(fewer.first->explanation == "a polygon of 3 vertices is expected, but it has 2");
  std::vector<double> more = triangle.values;
  more.insert(more.end(), {5, 5, 5, 1});
  CHECK(compare(triangle, more).first->kind == Kind::kExtra);
}

TEST_CASE("a polygon's attributes are data, its first four numbers a position") {
  const Expected one = field(Shape::kPolygon, {0, 0, 0, 1, 7}, 0, 5);
  const auto result = compare(one, {0, 0, 0, 1, 8});
  CHECK(result.first->kind == Kind::kData);
  CHECK(result.first->element == "vertex 0, attribute 0");
}

TEST_CASE("coverage counts gaps, doubles and extras, and draws them") {
  const Expected expected = field(Shape::kCoverage, {1, 1, 0, 1, 0, 0}, 0, 3);
  const auto result = compare(expected, {0, 2, 0, 1, 1, 0});
  REQUIRE(result.first);
  CHECK(result.first->kind == Kind::kMissing);
  CHECK(result.first->element == "pixel (0, 0)");
  CHECK(result.coverage.gaps == 1);
  CHECK(result.coverage.doubles == 1);
  CHECK(result.coverage.extra == 1);
  CHECK(result.map.find("o2.") != std::string::npos);
  CHECK(result.map.find("#+.") != std::string::npos);
}

TEST_CASE("a field that is not emitted is missing, and so is an empty one") {
  const Expected expected = field(Shape::kNumbers, {1, 2});
  CHECK(compare(expected, Answer{}).first->kind == Kind::kMissing);
  CHECK(compare(expected, std::vector<double>{}).first->kind == Kind::kMissing);
}

TEST_CASE("a case's own judge stands in place of the comparison") {
  Case input;
  input.expected = {field(Shape::kNumbers, {1})};
  Answer answer;
  answer.emit("f", {2});
  CHECK(judge_case(input, answer));
  input.judge = [](const Answer&) { return std::nullopt; };
  CHECK_FALSE(judge_case(input, answer));
}

TEST_CASE("ulps are those of the numbers' own format, and of what is counted there are none") {
  const auto text_of = [](const Expected& expected, double actual) {
    const auto found = compare(expected, std::vector<double>{actual}).first;
    REQUIRE(found);
    return expected_text(*found) + "; " + distance_text(*found);
  };
  CHECK(text_of(numbers("f", {1}, 1e-6), 1 + 0x1p-18) ==
        "1; 3.8147e-06, 32 float ulps; at most 1e-06 is allowed");
  CHECK(text_of(numbers("f", {1}, 1e-15), 1 + 0x1p-48) ==
        "1; 3.55271e-15, 16 double ulps; at most 1e-15 is allowed");
  CHECK(text_of(numbers("f", {3}), 2) == "3; 1; it must be exact");
  CHECK(text_of(numbers("f", {1}, 1e-15), -1) == "1; 2; at most 1e-15 is allowed");
  // An expected number that is only the judge's own round-off is shown as 0.
  CHECK(text_of(numbers("f", {4.44e-16}, 1e-15, "px"), 0.25) ==
        "0; 0.25 px; at most 1e-15 is allowed");
}
