// From a solution to what a student starts with: the code between the markers goes, its stubs come.
//
//   // BEGIN SOLUTION
//   return cofactors(m);
//   // STUB: return {};
//   // END SOLUTION
//
// In cases.h and runner.cpp, what stands between // BEGIN HIDDEN and // END HIDDEN belongs to hidden checks and goes too.
#pragma once

#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs {

// The text with each solution replaced by its stubs and without hidden parts. Markers that are nested, unbalanced or
// misspelt, and a solution without a stub, are errors that name the line; `name` is the file's, for the message.
Result<std::string> strip_solution(const std::string& text, const std::string& name);

// A line of a solution that is also in what was handed out.
struct Leak {
  int line = 0;  // of the solution, from 1
  std::string text;
};

// The proof that nothing leaks, by a reading of its own: a line of the starter must be a line of the solution that stands outside
// the markers, or one of its stubs, and occur no more often than there. Empty if so.
std::vector<Leak> find_leaks(const std::string& solution, const std::string& starter);

}  // namespace glassbox::labs
