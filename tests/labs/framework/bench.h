// A lab's checks put to one student.cpp after the other.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "labs/framework/judge.h"
#include "labs/framework/lab.h"
#include "labs/framework/run_check.h"
#include "labs/framework/sources.h"
#include "labs/grading/kit.h"
#include "tests/support/catch.h"

namespace glassbox::labs {

// A student.cpp compiled and linked with a lab's checks.
struct BenchProgram {
  std::filesystem::path path;
  bool hidden = true;  // with the hidden checks too
};

// One for each lab: what surrounds a student's file is compiled once (a kit, kept for the next time), a text that was compiled
// before is not compiled again, and what is expected is worked out once.
class Bench {
public:
  static Bench& of(const Lab& lab);

  const Sources& sources() const { return sources_; }
  const std::string& solution() const { return solution_; }

  BenchProgram program(const std::string& student, bool hidden = true);
  // The starter as the kit has it.
  BenchProgram starter(bool hidden);

  LabResult check(const BenchProgram& program) const { return check(program, cases_); }
  LabResult check(const std::string& student) { return check(program(student)); }
  // With cases that depend on a seed, worked out anew.
  LabResult check_anew(const BenchProgram& program) const;

private:
  using AllCases = std::vector<std::vector<Case>>;
  explicit Bench(const Lab& lab);
  LabResult check(const BenchProgram& program, const AllCases& cases) const;
  BenchProgram linked(const std::filesystem::path& object, bool hidden);
  AllCases all_cases() const;

  Lab lab_;  // with its points
  Sources sources_;
  std::string solution_;
  grading::Kit kit_;
  std::filesystem::path folder_;
  AllCases cases_;
  std::map<std::string, std::filesystem::path> objects_;  // of the texts that were compiled
  int programs_ = 0;
};

// What a report would say first of each check that is not right.
std::string failures(const LabResult& result);

}  // namespace glassbox::labs
