// What a runner writes, read as what anybody might have written.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "labs/framework/runner.h"

namespace glassbox::labs {

// What came of one case.
struct CaseAnswer {
  enum class State {
    kMissing,    // no line of the case
    kAnswered,   // `answer` holds
    kThrew,      // the function threw: `text` is what()
    kCrashed,    // the process ended in it, by a signal or exit: `text` says how
    kTimeout,    // it was still running in it
    kLimit,      // it was stopped for memory, output or a forbidden call: `text` says which
    kMalformed,  // its line is no answer: `text` says why
  };
  State state = State::kMissing;
  Answer answer;
  std::string text;
};

struct CheckAnswers {
  std::string check;
  std::vector<CaseAnswer> cases;  // one for each case of the check
  // The first line that is no answer and names no case, and why; empty if none.
  std::string malformed;
  std::string said;  // what the student's code printed
  double seconds = 0;
};

// Reads the lines of one process into `answers`, whose cases must have been sized. A line must be one object with "case", an
// index below the number of cases that has not been answered yet, and "fields" or "threw"; the numbers of a field are JSON
// numbers, "nan", "inf" or "-inf". A last line without its end is what a crash left, and is passed over. Never throws.
void read_answers(std::string_view lines, CheckAnswers& answers);

}  // namespace glassbox::labs
