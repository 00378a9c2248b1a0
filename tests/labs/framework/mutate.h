// Mutation testing: changes a lab's solution by operators, one small change at a time. A check must
// find each of them, or its program must do the same as the solution.
#pragma once

#include <string>
#include <vector>

namespace glassbox::labs {

// A solution with one change.
struct Mutant {
  int line = 0;        // the first changed line, counted from 1
  std::string task;    // of the section in which it is: "6.4"
  std::string before;  // the changed lines without their indentation
  std::string after;   // the same with the change
  std::string source;  // the whole solution with the change
};

// All mutants of the code between BEGIN SOLUTION and END SOLUTION, in their order. The operators:
//
//   comparison    < and <=, > and >=, == and != for each other; < for > and > for <
//   arithmetic    + and -, * and /, % and /, << and >>, & and | for each other, also with =
//   logic         && and || for each other; no !; a condition that is always true, or always false
//   sign          no unary minus; ++ and -- for each other
//   constant      a whole number that is 1 larger, or 1 smaller; any other number doubled, or 0;
//                 true and false for each other
//   index         .x, .y, .z and .w for each other
//   type          double and float for each other; 32 bits in place of 64
//   call          min and max, floor and ceil, sin and cos and the like for each other; no abs, no
//                 sqrt
//   statement     an assignment, a call or a jump is left out; break and continue for each other
//   return        {} in place of the value
//
// Some do not compile.
std::vector<Mutant> mutants_of(const std::string& solution);

}  // namespace glassbox::labs
