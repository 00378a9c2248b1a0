// Finds the functions that students get in the headers of a lab.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"

namespace glassbox::labs {

// What students get, as a text without includes of its own, and what it defines.
struct HandedOut {
  std::string text;
  // "glassbox::dot", "lab_05::handed_out::prism", with the fewest and the most arguments
  std::map<std::string, std::pair<int, int>> functions;
  std::set<std::string> left_out;  // those that seem to compile with any arguments
  std::string members;  // functions members(S&), one for each struct S, which return a tuple
};

// What the headers of a lab's folder define, as `glassbox lab start` gives them, and the headers
// that they include. What a student's file includes stays outside of `text`. Everything else has a
// namespace of its own in the lab's, so that it is not mistaken for what the runner is compiled
// with.
HandedOut handed_out(const Sources& sources, const Lab& lab);

// Adds what the code of a header defines in the first column to the functions and members. `space`
// is the code's namespace. Functions for arguments of any type are left out.
void add_definitions(HandedOut& all, const std::string& header, const std::string& space);

// The text with its first `what` replaced. There must be one.
std::string filled_in(std::string text, const std::string& what, const std::string& by);

}  // namespace glassbox::labs
