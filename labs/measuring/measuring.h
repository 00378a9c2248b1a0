// A student's functions as one more way of an experiment (glassbox lab measure): how wrong they are at each place of its axis, and
// how long they take.
//
// A lab's part of it is two files in its folder:
//   timed.cpp      puts questions to the student's functions, and does for the clock what they ask (framework/stages.h): one
//                  StageFunction "measured"; in a process of its own
//   measured.cpp   what is asked at each place, and how wrong the answers are: LabMeasure measured_NN()
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "labs/drawing/program.h"
#include "labs/framework/stages.h"
#include "study/experiment/results.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

// One answer for each question, from the student's process. An answer may be of any length.
using Ask = std::function<Result<std::vector<Numbers>>(const std::vector<Numbers>& questions)>;

// A point of the chart, where the experiment has others. Its error is NaN for what can be no answer, so that doing nothing is not exact.
struct MeasuredPlace {
  std::string series;
  double parameter = 0;
  std::string scene = {}, measure = {};
  std::function<Result<double>(const Ask& ask)> error = {};
  // The question that is timed, and how many of the experiment's items it is. Without one the times are those of the same series
  // and scene at the same place.
  Numbers timed = {};
  double items = 1;
};

struct LabMeasure {
  std::string experiment;  // "D-3"
  std::string functions;   // of student.h: "edge, owns_edge, covered_pixels"
  // Of a quick run of the experiment.
  std::function<std::vector<MeasuredPlace>()> places;
};

// Nothing for a lab that has no such measurement.
std::optional<LabMeasure> measure_of(int lab);

// Every place as the experiment's own ways have theirs. Without `rounds` nothing is timed. An error is what kept it from being
// measured; if it comes from the student's code, `student` knows.
Result<std::vector<study::ConfigurationResult>> measure_places(
    const LabMeasure& lab, StudentAnswers& student, int rounds,
    const std::function<void(const std::string&)>& phase);

// The series that nothing is written of yet: at all their places the student's functions answer as the starter's do (which may throw).
Result<std::vector<std::string>> untouched_series(
    const LabMeasure& lab, StudentAnswers& student, StudentAnswers& starter,
    const std::function<void(const std::string&)>& phase);

// ---- for the labs' own files ----

// The number of an answer; NaN where it has no such number.
double number_of(const Numbers& answer, std::size_t index);

}  // namespace glassbox::labs
