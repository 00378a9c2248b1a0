// The faults of a lab (faults.json) planted in its solution, each by itself or all in one program.
#pragma once

#include <string>
#include <vector>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"

namespace glassbox::labs {

// A sentence of a contract that is not kept: `find`, which the solution has once, becomes `replace`.
struct Fault {
  std::string name;  // what is wrong
  std::string find, replace;
  std::string task;
  std::string slip = {};   // that a report must name; empty: it must name none
  bool headline = false;   // of the task's main requirement: what a student is given must find it
  std::string stage = {};  // that a report must name; only of those that are compiled by themselves
};

// In the order of the file.
std::vector<Fault> faults_of(const Sources& sources, const Lab& lab);

std::string with_fault(const std::string& solution, const Fault& fault);

// One student.cpp for all of them, which costs one compilation: the solution is a class with the functions of student.h, each fault
// one that overrides what it changes, and the environment variable kPlanted says whose are called; 0 or nothing: the solution's.
inline constexpr const char* kPlanted = "GLASSBOX_PLANTED";
std::string all_in_one(const std::string& header, const std::string& solution,
                       const std::vector<Fault>& faults);

}  // namespace glassbox::labs
