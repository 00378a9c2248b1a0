// Reads what a runner writes. It is treated as untrusted text, because a student's code may have
// written it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "labs/framework/runner.h"

namespace glassbox::labs {

// The outcome of one case.
struct CaseAnswer {
  enum class State {
    kMissing,   // there is no line for the case
    kAnswered,  // the case was answered: `answer` is valid
    kThrew,     // the function threw: `text` is what()
    kCrashed,   // the process ended during the case, by a signal or exit: `text` says how
    kTimeout,   // the case was still running when the time was up
    // the process was stopped because of memory, output or a forbidden call: `text` says which
    kLimit,
    kMalformed,  // the case's line is not a valid answer: `text` says why
  };
  State state = State::kMissing;
  Answer answer;
  std::string text;
};

struct CheckAnswers {
  std::string check;
  std::vector<CaseAnswer> cases;  // one for each case of the check
  // The first line that is not an answer and names no case, and what is wrong with it; empty if
  // there is none.
  std::string malformed;
  std::string printed;  // what the student's code printed
  double seconds = 0;
};

// Reads the lines of one process into `answers`, whose cases must already have their size. A line
// must be one object with "case", an index below the number of cases that has not been answered
// yet, and "fields" or "threw". The numbers of a field are a list of JSON numbers, "nan", "inf" or
// "-inf", or one string with the bits of each as 16 hexadecimal digits. "sizes" has the sizes of a
// batch's fields, and becomes fields of its own (batch.h). A last line without a line end was cut
// off by a crash, and is ignored. Never throws.
//
// "fields" and "sizes" may have kMaxFields each; the labs' answers have fewer than 20.
inline constexpr std::size_t kMaxFields = 64;
void read_answers(std::string_view lines, CheckAnswers& answers);

}  // namespace glassbox::labs
