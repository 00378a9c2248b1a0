// Runs a lab's checks on one student.cpp after another.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "labs/framework/judge_check.h"
#include "labs/framework/lab.h"
#include "labs/framework/run_check.h"
#include "labs/framework/sources.h"
#include "labs/grading/build_kit.h"
#include "tests/support/catch.h"

namespace glassbox::labs {

// A student.cpp that is compiled and linked with a lab's checks.
struct BenchProgram {
  std::filesystem::path path;
  bool hidden = true;  // whether it has the hidden checks too
};

// Which checks are run: all of them, or those without generated inputs, which take a tenth of the
// time.
enum class Inputs { kAll, kCases };

// Which checks first_wrong() runs.
enum class Checks { kAll, kOfTask };

// Runs a changed program, which may run for ever, or allocate for ever: it has 5 seconds and 2 GB.
// The time is the processor's, so that a busy machine makes no difference. `variable`
// ("NAME=VALUE") is set in the program's environment. After a run that did not end well nothing
// more is run.
class LimitedRunner : public Runner {
public:
  explicit LimitedRunner(std::string variable) : variable_(std::move(variable)) {}
  RunOutcome run(const RunRequest& request) override;

private:
  std::string variable_;
  bool has_failed_ = false;
};

// One bench for each lab. The code around a student's file is compiled once (a kit, kept for the
// next run), a text that was compiled before is not compiled again, and the expected answers are
// computed once.
class Bench {
public:
  static Bench& for_lab(const Lab& lab);

  const Sources& sources() const { return sources_; }
  const std::string& solution() const { return solution_; }

  BenchProgram program(const std::string& student, bool hidden = true);
  // The same, but text that does not compile is an error with the compiler's messages.
  Result<BenchProgram> try_program(const std::string& student, bool hidden = true);
  // Returns the lab's starter, which the kit contains compiled.
  BenchProgram starter(bool hidden);

  LabResult check(const BenchProgram& program, Inputs inputs = Inputs::kAll) const {
    return check(program, cases_, inputs);
  }
  LabResult check(const std::string& student) { return check(program(student)); }
  // The first check that is not right: of `task` first, and of generated inputs last. Null if all
  // are right.
  const Check* first_wrong(Runner& runner, const BenchProgram& program, const std::string& task,
                           Checks which = Checks::kAll) const;
  // Checks with cases that are computed again, because they depend on a seed.
  LabResult check_with_new_cases(const BenchProgram& program, Inputs inputs) const;

private:
  using AllCases = std::vector<std::vector<Case>>;
  explicit Bench(const Lab& lab);
  LabResult check(const BenchProgram& program, const AllCases& cases, Inputs inputs) const;
  BenchProgram linked(const std::filesystem::path& object, bool hidden);
  AllCases all_cases() const;

  Lab lab_;  // with the points of points.json
  Sources sources_;
  std::string solution_;
  grading::BuildKit kit_;
  std::filesystem::path folder_;
  AllCases cases_;
  std::map<std::string, std::filesystem::path> objects_;  // of the texts compiled so far
  int programs_ = 0;
};

// Lists, for each check that is not right, the first thing that a report would state.
std::string failures(const LabResult& result);

}  // namespace glassbox::labs
