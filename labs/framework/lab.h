// The side of a lab that judges: what is expected of each case, within which bound, and what it is called.
//
// A lab is a folder labs/NN-name:
//   handout.md     the idea, the formulas with their conventions, the tasks with their points
//   student.h      the contract of each function that a student writes
//   student.cpp    the solution, between // BEGIN SOLUTION, // STUB: ... and // END SOLUTION
//   cases.h        the inputs of every check, which runner and judge both make
//   runner.cpp     puts the cases to the student's functions (runner.h)
//   checks.cpp     what is expected, by the pipeline's own functions or an oracle: Lab lab_NN()
//   faults.json    planted wrong variants of the solution, with what a report must say of each
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "labs/framework/runner.h"

namespace glassbox::labs {

enum class Shape { kNumbers, kPoint, kMatrix, kPolygon, kCoverage };

struct Expected {
  std::string field = {};  // as the runner emits it
  Shape shape = Shape::kNumbers;
  std::vector<double> values = {};
  double bound = 0;       // of the distance of each number, in `unit`; 0: exact
  std::string unit = {};  // "world units", "px", "radian" (which makes it an angle); empty: a count
  int columns = 0;        // of coverage: the width in pixels; of a polygon: the numbers of a vertex
};

// What is expected of a field that holds numbers, a point, a matrix row by row, or a polygon vertex by vertex.
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

// Where an answer first departs from what is expected.
struct Divergence {
  enum class Kind { kMissing, kExtra, kPosition, kData, kNotANumber };
  Kind kind = Kind::kData;
  std::string field = {};
  std::size_t index = 0;     // of the number, pixel or vertex in the field
  std::string element = {};  // "row 2, column 3", "vertex 4, w", "pixel (10, 12)"
  double expected = 0, actual = 0;
  double distance = 0, bound = 0;  // in `unit`
  // Between expected and actual: of float where both are floats, else of double.
  double ulps = 0;
  bool ulps_of_double = false;
  std::string unit = {};
  std::string explanation = {};  // where a judge of the case's own has more to say
};

// What the answer is under one of the convention slips, known_slips() of slips.h.
struct Slipped {
  std::string slip;
  std::vector<Expected> expected;
};

// One input. The first case of a check that fails is the one reported in full.
struct Case {
  std::string where;  // "triangle 3, vertex 1"; "pixel (10, 12)"
  // The input in the spaces where it can be seen: NDC, screen, winding. A line that begins with "glassbox " is a command that
  // shows the case.
  std::string restated;
  std::vector<Expected> expected = {};
  // Where more than one answer is right: none if the answer is. In place of the comparison with `expected`.
  std::function<std::optional<Divergence>(const Answer&)> judge = nullptr;
  // Slips that cannot be seen from the answer alone, such as a product in the other order. Those that can (slips.h) need no
  // entry. A slip is named only if every case of the check answers as it does under the slip.
  std::vector<Slipped> slipped = {};
};

// What a case's text says of an extreme case, "... (C-43)", as the line that shows that one; empty where it names none.
inline std::string command_for(const std::string& what) {
  const std::size_t id = what.find("C-");
  if (id == std::string::npos) return "";
  const std::size_t end = what.find_first_not_of("0123456789", id + 2);
  return "\nglassbox study extremes --case " + what.substr(id, end - id);
}

struct Check {
  std::string name;  // "points in front of the eye have negative z"
  std::string task;  // Task::id
  // "world", "eye", "clip", "NDC", "screen", "coverage", "depth", "shading", "anaglyph".
  std::string stage;
  bool hidden = false;  // not part of what a student is given
  std::function<std::vector<Case>()> cases;
  double weight = 1;   // of its task's points (points.h)
  bool whole = false;  // it gives its points only where every case is right
};

// A check that expects of each of `inputs` what `expect` says.
template <class Inputs, class Input>
Check check(const char* name, const char* task, const char* stage, Inputs inputs,
            Case (*expect)(const Input&)) {
  return {name, task, stage, false, [inputs, expect] {
            std::vector<Case> cases;
            for (const Input& input : inputs()) cases.push_back(expect(input));
            return cases;
          }};
}

// A check of that kind that is not part of what a student is given.
template <class Inputs, class Input>
Check hidden_check(const char* name, const char* task, const char* stage, Inputs inputs,
                   Case (*expect)(const Input&)) {
  Check made = check(name, task, stage, inputs, expect);
  made.hidden = true;
  return made;
}

// A hidden check of the task that this program does not have: it is a students' (students.h).
inline Check hidden_elsewhere(const char* task) {
  return {"", task, "", true, [] { return std::vector<Case>(); }};
}

struct Task {
  std::string id;     // "5.2"
  std::string title;  // "Clip a polygon against one plane"
  double points = 0;  // shared by its checks (points.h)
};

struct Lab {
  int number = 0;
  std::string folder;  // "05-clipping"
  std::string title;
  std::vector<Task> tasks;
  std::vector<Check> checks;
};

// In the order of their numbers.
const std::vector<Lab>& all_labs();

}  // namespace glassbox::labs
