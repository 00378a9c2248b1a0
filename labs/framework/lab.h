// A lab as its judge sees it: the tasks, the checks with their cases (inputs), the expected answers
// and the bounds of their errors.
//
// A lab is a folder labs/NN-name:
//   handout.md     the idea, the formulas with their conventions, the tasks with their points
//   student.h      the contract of each function that a student writes
//   student.cpp    the solution, between // BEGIN SOLUTION, // STUB: ... and // END SOLUTION
//   cases.h        the inputs of every check, which runner and judge both make
//   generators.h   generates further inputs, thousands for every function (choices.h)
//   runner.cpp     calls the student's functions with the cases (runner.h)
//   checks.cpp     the expected answers, by the pipeline's functions or an oracle: Lab lab_NN()
//   faults.json    planted wrong variants of the solution, with what a report must say of each
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "labs/framework/runner.h"

namespace glassbox::labs {

enum class Shape { kNumbers, kPoint, kMatrix, kPolygon, kCoverage };

struct Expected {
  std::string field = {};  // the name that the runner gives it
  Shape shape = Shape::kNumbers;
  std::vector<double> values = {};
  double bound = 0;       // how far each number may be off, in `unit`; 0: not at all
  std::string unit = {};  // "world units", "px", "radian" (which makes it an angle); empty: a count
  // for coverage: the width in pixels; for a polygon: how many numbers a vertex has
  int columns = 0;
  // The bound of each number, where they differ: with_bounds(). `bound` is the largest then.
  std::vector<double> bounds = {};
};

// What is expected of a field that is a list of numbers, a point, a matrix (row by row), or a
// polygon (vertex by vertex).
inline Expected numbers(std::string field, std::vector<double> values, double bound = 0,
                        std::string unit = {}) {
  return {std::move(field), Shape::kNumbers, std::move(values), bound, std::move(unit)};
}
inline Expected point(std::string field, std::vector<double> values, double bound,
                      std::string unit = {}) {
  return {std::move(field), Shape::kPoint, std::move(values), bound, std::move(unit)};
}
inline Expected matrix(std::string field, int columns, std::vector<double> values, double bound = 0,
                       std::string unit = {}) {
  return {std::move(field), Shape::kMatrix, std::move(values), bound, std::move(unit), columns};
}
inline Expected polygon(std::string field, int columns, std::vector<double> values,
                        double bound = 0, std::string unit = {}) {
  return {std::move(field), Shape::kPolygon, std::move(values), bound, std::move(unit), columns};
}

// The same with a bound for each number.
inline Expected with_bounds(Expected expected, std::vector<double> bounds) {
  expected.bound = 0;
  for (const double each : bounds) expected.bound = std::max(expected.bound, each);
  expected.bounds = std::move(bounds);
  return expected;
}

// The first place where an answer differs from what is expected.
struct Divergence {
  enum class Kind { kMissing, kExtra, kPosition, kData, kNotANumber };
  Kind kind = Kind::kData;
  std::string field = {};
  std::size_t index = 0;     // the index of the number, pixel or vertex in the field
  std::string element = {};  // "row 2, column 3", "vertex 4, w", "pixel (10, 12)"
  double expected = 0, actual = 0;
  double distance = 0, bound = 0;  // in `unit`
  // The distance in ulps of float if both numbers are floats, in ulps of double otherwise.
  double ulps = 0;
  bool ulps_of_double = false;
  std::string unit = {};
  std::string explanation = {};  // what the case's own judge adds; may be empty
};

// What the answer would be with one of the slips (typical mistakes with a convention, slips.h).
struct ExpectedWithSlip {
  std::string slip;
  std::vector<Expected> expected;
};

struct GeneratedInputs;

// One input of a check. The first case that fails is reported in full.
struct Case {
  std::string where;  // "triangle 3, vertex 1"; "pixel (10, 12)"
  // The input in coordinates that a student can picture (NDC, screen), with its winding. A line
  // that begins with "glassbox " is a command that shows the case.
  std::string restated;
  std::vector<Expected> expected = {};
  // The case's own judge, used where more than one answer is right. It replaces the comparison with
  // `expected`, and returns nothing if the answer is right.
  std::function<std::optional<Divergence>(const Answer&)> judge = nullptr;
  // What the answer would be with typical mistakes (slips) that cannot be recognised from the
  // answer alone, such as a product in the other order. Mistakes that slips.h recognises, such as a
  // wrong sign, need no entry. A mistake is named only if every answer of the check is what the
  // mistake leads to.
  std::vector<ExpectedWithSlip> slipped = {};
  // Set if the case is a class of generated inputs. It is right if every input's answer is right;
  // then the other members but `where` are not used.
  std::shared_ptr<const GeneratedInputs> generated = nullptr;
};

// A class of generated inputs, as the judge sees it.
struct GeneratedInputs {
  const char* what;
  int count;
  // Only makes the input, so that the choices are recorded.
  std::function<void(Choices& choices)> make;
  // The input that the choices make, as a case of its own.
  std::function<Case(Choices& choices)> expect;
  // Whether an answer to this input is right: what judging the case says, but faster.
  std::function<bool(Choices& choices, const Answer& answer)> is_right;
};

// The command that shows the extreme case whose number the text contains, as in "... (C-43)"; empty
// if the text contains none.
inline std::string extreme_case_command(const std::string& what) {
  const std::size_t id = what.find("C-");
  if (id == std::string::npos) return "";
  const std::size_t end = what.find_first_not_of("0123456789", id + 2);
  return "\nglassbox study extremes --case " + what.substr(id, end - id);
}

// The first place where the answer to a case is wrong. It is found by Case::judge if the case has
// that function, otherwise by comparing the expected fields in turn.
std::optional<Divergence> judge_case(const Case& input, const Answer& answer);

struct Check {
  std::string name;  // "points in front of the eye have negative z"
  std::string task;  // Task::id
  // The stage of the pipeline: one of "world", "eye", "clip", "NDC", "screen", "coverage", "depth",
  // "shading", "anaglyph".
  std::string stage;
  bool hidden = false;  // students do not get this check
  std::function<std::vector<Case>()> cases;
  double weight = 1;            // its part of the task's points is proportional to this
  bool all_or_nothing = false;  // points are given only if all cases are right
  bool generated = false;       // each case is a class of generated inputs
};

// A check with one case for each of the `inputs`; expect(input) returns the case with the expected
// answer.
template <class Inputs, class Input>
Check check(const char* name, const char* task, const char* stage, Inputs inputs,
            Case (*expect)(const Input&)) {
  return {name, task, stage, false, [inputs, expect] {
            std::vector<Case> cases;
            for (const Input& input : inputs()) cases.push_back(expect(input));
            return cases;
          }};
}

// A hidden check, which students do not get; otherwise as check().
template <class Inputs, class Input>
Check hidden_check(const char* name, const char* task, const char* stage, Inputs inputs,
                   Case (*expect)(const Input&)) {
  Check made = check(name, task, stage, inputs, expect);
  made.hidden = true;
  return made;
}

// A check of generated inputs (choices.h). Every class of inputs is a case. expect(input) returns
// the input as a case with the expected answer. It is called for each of some 100,000 inputs,
// unless there is is_right(input, answer), which must say the same and should seldom make texts.
template <class Input>
Check generated_check(const char* name, const char* task, const char* stage,
                      std::vector<InputClass<Input>> (*classes)(), Case (*expect)(const Input&),
                      bool (*is_right)(const Input&, const Answer&) = nullptr) {
  const auto cases_of = [classes, expect, is_right] {
    std::vector<Case> cases;
    for (const InputClass<Input>& each : classes()) {
      const auto make = each.make;
      const auto make_one = [make](Choices& choices) { (void)make(choices); };
      const auto expect_one = [make, expect](Choices& choices) { return expect(make(choices)); };
      const auto judge_one = [make, expect, is_right](Choices& choices, const Answer& answer) {
        const Input input = make(choices);
        return is_right != nullptr ? is_right(input, answer) : !judge_case(expect(input), answer);
      };
      Case made{.where = each.what, .restated = ""};
      made.generated = std::make_shared<GeneratedInputs>(
          GeneratedInputs{each.what, each.count, make_one, expect_one, judge_one});
      cases.push_back(std::move(made));
    }
    return cases;
  };
  return {name, task, stage, false, cases_of, 1, false, true};
}

// A placeholder for the hidden checks of a task, in the program for students, which contains no
// hidden checks (student_version.h).
inline Check hidden_check_placeholder(const char* task) {
  return {"", task, "", true, [] { return std::vector<Case>(); }};
}

struct Task {
  std::string id;     // "5.2"
  std::string title;  // "Clip a polygon against one plane"
  double points = 0;  // divided among its checks (lab_points.h)
};

struct Lab {
  int number = 0;
  std::string folder;  // "05-clipping"
  std::string title;
  std::vector<Task> tasks;
  std::vector<Check> checks;
};

// All labs, in the order of their numbers.
const std::vector<Lab>& all_labs();

}  // namespace glassbox::labs
