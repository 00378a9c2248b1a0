// What a student is told of a lab, as text, JSON and a page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "labs/framework/judge.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// What stands around a result.
struct LabReport {
  const labs::LabResult& result;
  std::string student;  // the file
  std::string runner;   // the program that puts the cases, for a debugger
  double seconds = 0;   // of building and running
  // Of each check of the result: "passed", "crash (stack overflow)", as a grader names it.
  std::vector<std::string> names = {};
};

std::string lab_report_text(const LabReport& report);

// {"score", "max_score", "tests": [{"name", "task", "stage", "score", "max_score", "status", "first_divergence"}]}. Numbers that
// JSON does not have are "nan", "inf" and "-inf".
nlohmann::ordered_json lab_report_json(const LabReport& report);

// A page that needs no other file: the same, with pictures of what is expected, what came and where they differ.
Result<std::string> lab_report_page(const LabReport& report);

// "2.5 of 3".
std::string points_text(double score, double max_score);

// The lines of a case's restatement: what it says, and the commands that show it.
struct Restated {
  std::vector<std::string> facts, commands;
};
Restated restated_lines(const std::string& restated);

// What a grader calls the outcome of the check, where there are names; else the verdict on its first wrong case.
std::string outcome_text(const LabReport& report, const labs::CheckResult& check);

// The command that puts the failing case under a debugger; empty if there is no runner.
std::string debugger_command(const LabReport& report, const labs::CheckResult& check);

}  // namespace glassbox::app
