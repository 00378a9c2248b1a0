// An overview of a class: a table for spreadsheets and a page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace glassbox::labs::grading {

struct ClassRow {
  std::string name;
  // results.json, or unfinished_json() where there is none that can be read.
  nlohmann::ordered_json results;
  bool finished = true;  // false: there is no result, or only one of an earlier grading
};

// The outcome; where the grading did not finish, it says that the result is an earlier one.
std::string outcome_of(const ClassRow& row);

// The columns are submission, score, max_score, outcome, then the score of each task. A text that a
// spreadsheet would take for a formula gets an apostrophe in front.
std::string class_csv(const std::vector<ClassRow>& rows);

// One page without a script: one line per submission, which opens to show its checks.
std::string class_html(const std::vector<ClassRow>& rows);

}  // namespace glassbox::labs::grading
