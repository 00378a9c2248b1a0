// Who should hand in: a table of a course's students.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

struct EnrolledStudent {
  std::string submission;          // the name of the student's submission
  std::vector<std::string> cells;  // the further columns, as many as Roster::columns
};

struct Roster {
  std::vector<std::string> columns;       // the names of the further columns
  std::vector<EnrolledStudent> students;  // in the order of the file
};

// Reads a CSV file (RFC 4180, UTF-8, cells separated by commas, semicolons or tabs). If a cell of
// its first line is "submission", this line has the names of the columns, and that column has the
// names of the submissions. Otherwise there is no such line, the first column has the names, and
// the further columns are called "column 2", "column 3" and so on. Lines without text are ignored.
// It is an error if a student has no name or is there twice, if a line has more cells than the
// first one, or if the first line names columns, but none of them "submission".
Result<Roster> read_roster(const std::filesystem::path& file);

// The same from the text of a file. An error begins with `name`.
Result<Roster> parse_roster(const std::string& text, const std::string& name);

}  // namespace glassbox::labs::grading
