// Turns a solution into the starter that students get: the code between the markers is replaced by
// the stub, the code after "STUB:".
//
//   // BEGIN SOLUTION
//   return cofactors(m);
//   // STUB: return {};
//   // END SOLUTION
//
// In cases.h and runner.cpp, the lines between // BEGIN HIDDEN and // END HIDDEN belong to hidden
// checks and are removed too.
#pragma once

#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs {

// The text with each solution replaced by its stubs, and without hidden parts. Nested, unbalanced
// or misspelt markers, and a solution without a stub, are errors that name the line; `name` is the
// file's name for the message.
Result<std::string> strip_solution(const std::string& text, const std::string& name);

// A line of a solution that is also in the starter.
struct Leak {
  int line = 0;  // in the solution, counted from 1
  std::string text;
};

// Proves that nothing leaks, independently of strip_solution(): every line of the starter must be a
// line of the solution outside the markers, or one of the stubs, and must not occur more often than
// among these lines. Empty if nothing leaks.
std::vector<Leak> find_leaks(const std::string& solution, const std::string& starter);

}  // namespace glassbox::labs
