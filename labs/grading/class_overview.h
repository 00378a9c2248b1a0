// An overview of a class: a table for spreadsheets and a page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace glassbox::labs::grading {

struct ClassRow {
  std::string name;
  // the submission's results.json; unfinished_json() if there is none that can be read
  nlohmann::ordered_json results;
  bool finished = true;  // false: there is no result, or only one of an earlier grading
};

// The outcome as text; if the grading did not finish and the result is that of an earlier grading,
// the text says so.
std::string outcome_of(const ClassRow& row);

// The columns are submission, score, max_score, outcome, then the score of each task. A text that a
// spreadsheet would take for a formula gets an apostrophe in front.
std::string class_csv(const std::vector<ClassRow>& rows);

// One page without a script: one line per submission, which opens to show its checks.
std::string class_html(const std::vector<ClassRow>& rows);

}  // namespace glassbox::labs::grading
