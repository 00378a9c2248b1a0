// `glassbox lab grade` and `lab collect` with the tests' own lab instead of the program's.
#include <cstdio>

#include <CLI/CLI.hpp>

#include "cli/report/exit_codes.h"
#include "labs/commands/grade_command.h"
#include "tests/labs/grading/tiny_lab.h"

int main(int argc, char** argv) {
  using namespace glassbox;
  CLI::App app{"The grader with a lab of the tests.", "tiny_grader"};
  CLI::App& lab = *app.add_subcommand("lab", "");
  int exit_code = kSuccess;
  // TINY_LABS is a folder with this lab's files and those of the framework.
  labs::LabGradeCommand grade(test::tiny_labs, [] {
    return Result<labs::Sources>(labs::Sources{TINY_LABS, TINY_INCLUDE, {}});
  });
  grade.add_to(lab, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return kBadInput;
  }
  return exit_code;
}
