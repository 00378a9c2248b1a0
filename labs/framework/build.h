// A lab's runner made from a student's file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/sources.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

struct BuildRequest {
  std::string folder;               // of the lab: "05-clipping"
  std::filesystem::path student;    // the student's student.cpp
  std::filesystem::path build_dir;  // private to this student; made if it is not there
  bool with_hidden = false;         // hidden checks too
  double seconds = 60;              // for each call of the compiler
};

// One call of the compiler.
struct BuildStep {
  std::vector<std::string> argv;
  std::filesystem::path source;  // empty: the link
  std::filesystem::path output;
  std::filesystem::path dependencies;  // what the compiler says it read; empty for the link
  bool student = false;                // the student's own file
};

struct BuildPlan {
  std::vector<BuildStep> steps;  // the last is the link
  std::filesystem::path program;
};

// Puts the lab's files into build_dir/src and says what must be called. The student's file is compiled where it is, but sees no
// file of the labs except those, and no header of the library that they do not need: not the solution, and not the judge.
Result<BuildPlan> plan_build(const Sources& sources, const BuildRequest& request);

// Whether the step's output is younger than everything it was made from.
bool is_up_to_date(const BuildStep& step);

struct BuildOutcome {
  bool built = false;
  bool compiled = false;  // something had to be
  bool timed_out = false;
  std::string messages;  // of the compiler: errors, or warnings
  std::filesystem::path program;
  double seconds = 0;
};

// Calls the compiler for what is not up to date, at the same time for each file.
Result<BuildOutcome> build_runner(const Sources& sources, const BuildRequest& request);

// What was read to make the output of a compiler's rule "out.o: a.cpp b.h \ c\ d.h", the source first.
std::vector<std::filesystem::path> dependencies_of(const std::string& rule);

// CXX of the environment, or the compiler that glassbox was built with, or c++.
std::string compiler();

}  // namespace glassbox::labs
