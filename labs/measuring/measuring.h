// Adds a student's functions to an experiment (glassbox lab measure) as one more method: how large
// their errors are at each value of the experiment's parameter, and how long they take.
//
// A lab's part of this is two files in its folder:
//   timed.cpp      passes questions to the student's functions, and does their work for the clock
//                  (framework/stages.h): one StageFunction "measured"; in its own process
//   measured.cpp   the questions at each place, and how the errors of the answers are computed:
//                  LabMeasure measured_NN()
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "labs/drawing/stage_program.h"
#include "labs/framework/stages.h"
#include "study/experiment/results.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

// Asks the student's process; returns one answer for each question. An answer may be of any length.
using Ask = std::function<Result<std::vector<Numbers>>(const std::vector<Numbers>& questions)>;

// A point of the experiment's chart, at a parameter where the experiment has points of its own. Its
// error is NaN for an answer of the wrong form, so that a function that does nothing is not taken
// for an exact one.
struct MeasuredPoint {
  std::string series;
  double parameter = 0;
  std::string scene = {}, measure = {};
  std::function<Result<double>(const Ask& ask)> error = {};
  // The input that is timed, and how many items (polygons, vertices, pixels) it has. If `timed` is
  // empty, the times of another point with the same series, scene and parameter are used.
  Numbers timed = {};
  double items = 1;
};

struct LabMeasure {
  std::string experiment;  // "D-3"
  std::string functions;   // the functions of student.h: "edge, owns_edge, covered_pixels"
  // The points of a quick run of the experiment.
  std::function<std::vector<MeasuredPoint>()> points;
};

// Returns nothing for a lab that has no such measurement.
std::optional<LabMeasure> measure_of(int lab);

// Measures every point as the experiment measures its own methods. If `rounds` is 0, nothing is
// timed. An error says what prevented the measurement; if it comes from the student's code,
// `student` has the details.
Result<std::vector<study::ConfigurationResult>> measure_points(
    const LabMeasure& lab, StudentAnswers& student, int rounds,
    const std::function<void(const std::string&)>& phase);

// The series for which the student has written nothing yet: at all points of such a series the
// student's functions answer as the starter's do (which may throw).
Result<std::vector<std::string>> untouched_series(
    const LabMeasure& lab, StudentAnswers& student, StudentAnswers& starter,
    const std::function<void(const std::string&)>& phase);

// ---- for the labs' own files ----

// Number `index` of an answer; NaN where the answer has no such number.
double number_of(const Numbers& answer, std::size_t index);

}  // namespace glassbox::labs
