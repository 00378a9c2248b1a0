// A slip is named if it makes every answer of a check right, and only then.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "labs/framework/judge_check.h"
#include "labs/framework/slips.h"
#include "tests/support/catch.h"

using namespace glassbox::labs;

namespace {

using Values = std::vector<double>;

struct AnsweredField {
  Expected expected;
  Values actual;
};

std::vector<std::string> slips_of(const std::vector<AnsweredField>& all) {
  std::vector<Case> cases;
  std::vector<CaseAnswer> answers;
  for (const AnsweredField& answered : all) {
    Case input;
    input.expected = {answered.expected};
    cases.push_back(input);
    CaseAnswer answer;
    answer.state = CaseAnswer::State::kAnswered;
    answer.answer.emit(answered.expected.field, answered.actual);
    answers.push_back(answer);
  }
  return find_slips(cases, answers);
}

bool finds_slip(const std::vector<AnsweredField>& all, const std::string& slip) {
  const auto found = slips_of(all);
  return std::find(found.begin(), found.end(), slip) != found.end();
}

Expected field(Shape shape, Values values, double bound = 1e-6, int columns = 0) {
  return {"f", shape, std::move(values), bound, "", columns};
}

Values about_z(double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  return {c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

Values projection(double fovy) {
  const double f = 1 / std::tan(fovy / 2);
  return {f / 1.5, 0, 0, 0, 0, f, 0, 0, 0, 0, -1.1, -0.2, 0, 0, -1, 0};
}

Values transposed(const Values& m) {
  Values t(16);
  for (std::size_t i = 0; i < 16; ++i) t[i] = m[i % 4 * 4 + i / 4];
  return t;
}

}  // namespace

TEST_CASE("a square with its corners in the other order may as well have its y turned round") {
  const Expected square = field(Shape::kPolygon, {0, 0, 1, 0, 1, 1, 0, 1}, 0, 2);
  CHECK(slips_of({{square, {0, 1, 1, 1, 1, 0, 0, 0}}}).empty());
}

TEST_CASE("signs of coordinates") {
  CHECK(slips_of({{field(Shape::kPoint, {1, 2, -3}), {1, 2, 3}}}) ==
        std::vector<std::string>{"z-sign"});
  CHECK(slips_of({{field(Shape::kPoint, {1, 2, -3}), {1, -2, -3}}}) ==
        std::vector<std::string>{"y-direction"});
  CHECK(slips_of({{field(Shape::kPoint, {1, 2, -3}), {-1, 2, -3}}}) ==
        std::vector<std::string>{"handedness"});
}

TEST_CASE("the row of a view matrix with the opposite sign") {
  Values view = about_z(0.3);
  view[11] = -5;
  Values slipped = view;
  slipped[10] = -slipped[10];
  slipped[11] = -slipped[11];
  CHECK(finds_slip({{field(Shape::kMatrix, view), slipped}}, "z-sign"));
}

TEST_CASE("screen y from the bottom, with one height for all points") {
  const auto screen = [](double y) { return field(Shape::kNumbers, {10, y}); };
  CHECK(finds_slip({{screen(100), {10, 380}}, {screen(20), {10, 460}}}, "y-direction"));
  CHECK_FALSE(finds_slip({{screen(100), {10, 380}}, {screen(20), {10, 459}}}, "y-direction"));
  // With a single point there is always a height that fits, so it is no evidence.
  CHECK_FALSE(finds_slip({{screen(100), {10, 380}}}, "y-direction"));
}

TEST_CASE(
    "a transposed matrix, and one for row vectors, which has its translation in the last row") {
  Values m = about_z(0.3);
  CHECK(finds_slip({{field(Shape::kMatrix, m), transposed(m)}}, "row-column-order"));
  m[3] = 7;
  CHECK(finds_slip({{field(Shape::kMatrix, m), transposed(m)}}, "row-vectors"));
}

TEST_CASE("reversed polygons, triples, normals and yes for no") {
  const Expected quad = field(Shape::kPolygon, {0, 0, 2, 0, 1, 1, 0, 1}, 0, 2);
  CHECK(finds_slip({{quad, {0, 0, 0, 1, 1, 1, 2, 0}}}, "winding"));
  CHECK(finds_slip({{quad, {0, 1, 1, 1, 2, 0, 0, 0}}}, "winding"));
  CHECK_FALSE(finds_slip({{quad, {0, 0, 1, 1, 2, 0, 0, 1}}}, "winding"));
  CHECK(
      finds_slip({{field(Shape::kNumbers, {0, 1, 2, 2, 1, 3}, 0), {0, 2, 1, 2, 3, 1}}}, "winding"));
  Expected normal = field(Shape::kPoint, {1, 2, 3});
  CHECK(slips_of({{normal, {-1, -2, -3}}})
            .empty());  // without the field's name it may be a point behind the eye
  normal.field = "normal";
  CHECK(finds_slip({{normal, {-1, -2, -3}}}, "winding"));
  const auto back = [](double yes) { return field(Shape::kNumbers, {yes}, 0); };
  CHECK(finds_slip({{back(1), {0}}, {back(0), {1}}}, "winding"));
  CHECK_FALSE(finds_slip({{back(1), {0}}, {back(0), {0}}}, "winding"));
}

TEST_CASE("angles that are halved, doubled, or in degrees") {
  const double degree = std::numbers::pi / 180;
  Expected angle = field(Shape::kNumbers, {0.5});
  CHECK_FALSE(finds_slip({{angle, {1.0}}}, "half-angle"));  // without a unit it may be any number
  angle.unit = "radian";
  CHECK(finds_slip({{angle, {1.0}}}, "half-angle"));
  CHECK(finds_slip({{angle, {0.5 / degree}}}, "degrees-radians"));
  angle.values = {1e-7}, angle.bound = 1e-12;
  CHECK_FALSE(finds_slip({{angle, {4e-7}}}, "half-angle"));  // merely a small angle that is wrong
  CHECK(finds_slip({{field(Shape::kMatrix, about_z(0.8)), about_z(0.4)}}, "half-angle"));
  CHECK(
      finds_slip({{field(Shape::kMatrix, about_z(30 * degree)), about_z(30)}}, "degrees-radians"));
  CHECK(finds_slip({{field(Shape::kMatrix, projection(1)), projection(2)}}, "half-angle"));
  CHECK(finds_slip({{field(Shape::kMatrix, projection(60 * degree)), projection(60)}},
                   "degrees-radians"));
}

TEST_CASE("a rotation and a translation in the other order") {
  Values first_turned = about_z(0.7), first_moved = about_z(0.7);
  first_turned[3] = 5;
  first_moved[3] = 5 * std::cos(0.7);
  first_moved[7] = 5 * std::sin(0.7);
  CHECK(finds_slip({{field(Shape::kMatrix, first_turned), first_moved}}, "multiplication-order"));
  CHECK(finds_slip({{field(Shape::kMatrix, first_moved), first_turned}}, "multiplication-order"));
}

TEST_CASE("a slip that explains some answers of a check and not others is not named") {
  const Expected point = field(Shape::kPoint, {1, 2, -3});
  CHECK(slips_of({{point, {1, 2, 3}}, {point, {1, 5, 3}}}).empty());
  CHECK(slips_of({{point, {1, 2, -3}}}).empty());
  CHECK(slips_of({{point, {0, 0, 0}}}).empty());
}

TEST_CASE(
    "a slip is not named where another explains as much, or where a right answer contradicts it") {
  Case input;
  input.expected = {field(Shape::kNumbers, {3, 4, 5, 6, 7})};
  const auto slipped = [](const char* slip, Values values) {
    return ExpectedWithSlip{slip, {field(Shape::kNumbers, std::move(values))}};
  };
  const auto answered = [](Values values) {
    CaseAnswer answer;
    answer.state = CaseAnswer::State::kAnswered;
    answer.answer.emit("f", std::move(values));
    return answer;
  };
  const Values right{3, 4, 5, 6, 7}, wrong{1, 1, 2, 3, 5};
  input.slipped = {slipped("affine", wrong)};
  CHECK(find_slips({input}, {answered(wrong)}) == std::vector<std::string>{"affine"});
  CHECK(find_slips({input, input}, {answered(wrong), answered(right)}).empty());
  // A case that the slip does not change does not contradict it.
  Case unchanged = input;
  unchanged.slipped = {slipped("affine", right)};
  CHECK(find_slips({input, unchanged}, {answered(wrong), answered(right)}).size() == 1);
  input.slipped.push_back(slipped("half-pixel", wrong));
  CHECK(find_slips({input}, {answered(wrong)}).empty());
}

TEST_CASE("a normal carried along by the model matrix, which a lab says of a case of its own") {
  // No lab asks for normals. With a scale of (1, 2, 1), the normal (1, 1, 0) becomes (1, 1/2, 0) by
  // the inverse transpose and (1, 2, 0) by the matrix itself; both are then normalised.
  const double root = std::sqrt(5.0);
  Case input;
  input.expected = {field(Shape::kPoint, {2 / root, 1 / root, 0})};
  input.slipped = {{"normal-as-vector", {field(Shape::kPoint, {1 / root, 2 / root, 0})}}};
  CaseAnswer answer;
  answer.state = CaseAnswer::State::kAnswered;
  answer.answer.emit("f", {1 / root, 2 / root, 0});
  CHECK(find_slips({input}, {answer}) == std::vector<std::string>{"normal-as-vector"});
}

TEST_CASE("a case with a judge of its own is asked again without the slip") {
  Case input;
  input.judge = [](const Answer& answer) -> std::optional<Divergence> {
    if (answer.fields()[0].values[2] < 0) return std::nullopt;
    return Divergence{};
  };
  CaseAnswer answer;
  answer.state = CaseAnswer::State::kAnswered;
  answer.answer.emit("p", {1, 2, 3});
  const auto found = find_slips({input}, {answer});
  CHECK(std::find(found.begin(), found.end(), "z-sign") != found.end());
}

TEST_CASE("what a lab says of a slip is enough, and only where an answer matches") {
  Case input;
  input.expected = {field(Shape::kNumbers, {3, 4, 5, 6, 7})};
  input.slipped = {{"multiplication-order", {field(Shape::kNumbers, {7, 1, 8, 2, 0})}}};
  CaseAnswer answer;
  answer.state = CaseAnswer::State::kAnswered;
  answer.answer.emit("f", {7, 1, 8, 2, 0});
  CHECK(find_slips({input}, {answer}) == std::vector<std::string>{"multiplication-order"});
  answer.answer = {};
  answer.answer.emit("f", {7, 1, 8, 2, 1});
  CHECK(find_slips({input}, {answer}).empty());
}

TEST_CASE("a clipped polygon of a slip may begin with any vertex, in the same order") {
  Case input;
  input.expected = {polygon("f", 2, {0, 0, 1, 0, 1, 1})};
  input.slipped = {{"no-near-plane", {polygon("f", 2, {0, 0, 2, 0, 2, 2, 0, 2})}}};
  CaseAnswer answer;
  answer.state = CaseAnswer::State::kAnswered;
  answer.answer.emit("f", {2, 2, 0, 2, 0, 0, 2, 0});
  CHECK(find_slips({input}, {answer}) == std::vector<std::string>{"no-near-plane"});
  answer.answer = {};
  answer.answer.emit("f", {2, 2, 2, 0, 0, 0, 0, 2});
  CHECK(find_slips({input}, {answer}).empty());
}

TEST_CASE("a slip that another one leads to is named only without that one") {
  const auto slips_with = [](const std::vector<std::string>& others) {
    CheckResult edges, coverage;
    edges.slips = others;
    coverage.slips = {"ownership"};
    return sum_up(Lab{}, {edges, coverage}).checks[1].slips;
  };
  CHECK(slips_with({}) == std::vector<std::string>{"ownership"});
  CHECK(slips_with({"all-edges"}) == std::vector<std::string>{"ownership"});
  CHECK(slips_with({"edge-sign"}).empty());
  for (const Slip& slip : known_slips())
    CHECK((slip.cause.empty() || !slip_text(slip.cause).empty()));
}

TEST_CASE("every slip has a sentence, and a name of its own") {
  CHECK(known_slips().size() == 30);
  for (const Slip& slip : known_slips()) CHECK(slip_text(slip.id) == slip.text);
  CHECK(slip_text("z-sign") == "your z has the opposite sign: the eye looks down -z");
  CHECK(slip_text("no such slip").empty());
}
