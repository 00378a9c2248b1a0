// An overview of a class: a table for spreadsheets and a page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "labs/grading/roster.h"

namespace glassbox::labs::grading {

struct ClassRow {
  std::string name;
  // the submission's results.json; unfinished_json() if there is none that can be read
  nlohmann::ordered_json results;
  bool finished = true;  // false: there is no result, or only one of an earlier grading
  std::vector<std::string> cells = {};  // the further columns of the roster (roster.h)
  bool handed_in = true;                // false: a student of the roster without a submission
};

inline constexpr const char* kNoSubmission = "no submission";

struct RowsOfRoster {
  std::vector<ClassRow> rows;          // one for each student, in the order of the roster
  std::vector<std::string> missing;    // students without a submission
  std::vector<std::string> strangers;  // submissions of nobody on the roster: they have no row
};

// One row for each student of the roster. A student without a submission has no points out of those
// of `lab`, a results.json of the same lab.
RowsOfRoster rows_of_roster(const Roster& roster, std::vector<ClassRow> rows,
                            const nlohmann::ordered_json& lab);

// A results.json for rows_of_roster(): that of a row which says what the points of the lab are; of
// no lab if there is none.
nlohmann::ordered_json lab_of_rows(const std::vector<ClassRow>& rows);

// The outcome as text; if the grading did not finish and the result is that of an earlier grading,
// the text says so.
std::string outcome_of(const ClassRow& row);

// The columns are submission, score, max_score, outcome, then the score of each task, then
// `columns`, which name the cells of the rows. A text that a spreadsheet would take for a formula
// gets an apostrophe in front.
std::string class_csv(const std::vector<ClassRow>& rows,
                      const std::vector<std::string>& columns = {});

// One page without a script: one line per row, which opens to show its checks.
std::string class_html(const std::vector<ClassRow>& rows,
                       const std::vector<std::string>& columns = {});

}  // namespace glassbox::labs::grading
