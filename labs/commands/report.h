// The report that a student gets on a lab, as text, JSON and a page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "labs/framework/judge_check.h"
#include "labs/framework/lab.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::labs {

// A result, with further facts for the report.
struct LabReport {
  const labs::LabResult& result;
  std::string student;  // the student's file
  std::string runner;   // the program that runs the cases, for a debugger
  double seconds = 0;   // time to build and run
  // The outcome of each check in a grader's words: "passed", "crash (stack overflow)".
  std::vector<std::string> names = {};
};

std::string lab_report_text(const LabReport& report);

// {"score", "max_score", "tests": [{"name", "task", "stage", "score", "max_score", "status",
// "first_divergence"}]}. Numbers that JSON cannot represent are "nan", "inf" and "-inf".
nlohmann::ordered_json lab_report_json(const LabReport& report);

// The report as a page that needs no other file, with pictures of the expected result, the actual
// one, and where they differ.
Result<std::string> lab_report_page(const LabReport& report);

// Points in words: "2.5 of 3".
std::string points_text(double score, double max_score);

// The lines about a failing case, sorted into statements (facts), such as its input in NDC, and
// commands of glassbox that show the case.
struct Restated {
  std::vector<std::string> facts, commands;
};
Restated restated_lines(const std::string& restated);

// The outcome of the check in a grader's words if the report has such words; otherwise the verdict
// on the check's first wrong case.
std::string outcome_text(const LabReport& report, const labs::CheckResult& check);

// The command that runs the failing case in a debugger; empty if there is no runner.
std::string debugger_command(const LabReport& report, const labs::CheckResult& check);

// Pictures of the expected result, the actual one, and where they differ.
struct CoveragePictures {
  Image<Rgba8> expected, actual, difference;
};

// Pictures of how often each pixel is covered: more coverage is lighter. In the difference, correct
// pixels are grey, missing ones red, those covered too often orange, and those that should be empty
// but are not, blue.
CoveragePictures coverage_pictures(const labs::Expected& expected,
                                   const std::vector<double>& actual);

// An SVG of two polygons, x to the right and y up, after the division by w if there is one: the
// expected polygon filled, the actual one as a dashed outline. Empty if neither can be drawn.
std::string polygon_drawing(const labs::Expected& expected, const std::vector<double>& actual);

}  // namespace glassbox::labs
