// A student's functions as one more way in an experiment (glassbox lab measure): how large their
// errors are at each place of its axis, and how long they take.
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

// A point of the chart, at a place where the experiment has others. Its error is NaN for an answer
// of the wrong form, so that doing nothing does not count as exact.
struct MeasuredPoint {
  std::string series;
  double parameter = 0;
  std::string scene = {}, measure = {};
  std::function<Result<double>(const Ask& ask)> error = {};
  // The question that is timed, and how many of the experiment's items it has. If it is empty, the
  // times of the same series and scene at the same place are used.
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

// Measures every point in the same way as the experiment measures its own ways. Without `rounds`
// nothing is timed. An error says what prevented the measurement; if it comes from the student's
// code, `student` has the details.
Result<std::vector<study::ConfigurationResult>> measure_points(
    const LabMeasure& lab, StudentAnswers& student, int rounds,
    const std::function<void(const std::string&)>& phase);

// The series for which the student has written nothing yet: at all their points the student's
// functions answer as the starter's do (which may throw).
Result<std::vector<std::string>> untouched_series(
    const LabMeasure& lab, StudentAnswers& student, StudentAnswers& starter,
    const std::function<void(const std::string&)>& phase);

// ---- for the labs' own files ----

// Number `index` of an answer; NaN where the answer has no such number.
double number_of(const Numbers& answer, std::size_t index);

}  // namespace glassbox::labs
