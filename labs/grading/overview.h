// A class at one look: a table for spreadsheets and a page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace glassbox::labs::grading {

struct Row {
  std::string name;
  // results.json; unfinished_json() where there is none that can be read.
  nlohmann::ordered_json results;
  bool finished = true;  // false: there is no result, or one of an earlier grading
};

// The outcome; where a grading did not finish, that the result is an earlier one.
std::string outcome_of(const Row& row);

// submission, score, max_score, outcome, then the score of each task. A text that a spreadsheet would take for a formula begins
// with an apostrophe.
std::string class_csv(const std::vector<Row>& rows);

// One page without a script: a line a submission, which opens to its checks.
std::string class_html(const std::vector<Row>& rows);

}  // namespace glassbox::labs::grading
