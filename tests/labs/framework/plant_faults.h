// Plants a lab's faults (faults.json) in its solution, each by itself or all in one program.
#pragma once

#include <string>
#include <vector>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"

namespace glassbox::labs {

// A violated sentence of a contract: `find`, which occurs once in the solution, becomes `replace`.
struct Fault {
  std::string name;  // describes what is wrong
  std::string find, replace;
  std::string task;
  std::string slip = {};  // slip that a report must name; if empty, it must name none
  bool headline = false;  // violates the task's main requirement: a visible check must find it
  // stage that a report must name; only for faults that are compiled by themselves
  std::string stage = {};
  // The reason why no picture of the lab shows the fault; only for faults with a slip. If empty,
  // one does (tests/labs/drawing/slip_pictures_test.cpp).
  std::string unseen = {};
};

// Returns the faults in the order of the file.
std::vector<Fault> faults_of(const Sources& sources, const Lab& lab);

std::string with_fault(const std::string& solution, const Fault& fault);

// A function declared in student.h.
struct Function {
  std::string declaration;  // "bool owns_edge(const SnappedVertex& a, const SnappedVertex& b)"
  std::string name;         // "owns_edge"
  std::string arguments;    // "a, b"
};

// Returns the functions that student.h declares, without those that it defines.
std::vector<Function> functions_of(const std::string& header);

// The whole of a solution with a change, and a line that describes the change.
struct Variant {
  std::string name;
  std::string source;
};

// Returns one student.cpp with all variants, which needs only one compilation. The solution is a
// class with the functions of student.h, each variant is a class that overrides what it changes,
// and the environment variable kPlanted is the number of the class to call, counted from 1; 0 or
// unset means the solution. The class of variant N begins with a line "struct PlantedN :".
inline constexpr const char* kPlanted = "GLASSBOX_PLANTED";
std::string solution_with_variants(const std::string& header, const std::string& solution,
                                   const std::vector<Variant>& variants);
std::string solution_with_all_faults(const std::string& header, const std::string& solution,
                                     const std::vector<Fault>& faults);

}  // namespace glassbox::labs
