// Compiles a submission in the sandbox, and links the programs that run the checks.
#pragma once

#include <filesystem>
#include <string>

#include "labs/grading/kit.h"
#include "labs/grading/sandbox.h"

namespace glassbox::labs::grading {

struct Compiled {
  // "compile error", "compile timeout", "grading did not finish"; empty if there is an object
  std::string trouble;
  std::string said;  // the compiler's errors or warnings
};

// Makes student.o in `build`, a directory of the sandbox's user. The text is compiled to assembly,
// which is checked (assembly.h) before it is assembled, so that no file but the lab's headers gets
// into it.
Compiled compile_submission(const std::string& text, const Sandbox& sandbox, const Kit& kit,
                            const std::filesystem::path& build, const CompileWords& words = {});

// Links the program that runs `checks` on student.o, or on the lab's starter. The runner's objects
// are in `build` only during this call. Returns an empty path if there is no program; `said` then
// says why.
std::filesystem::path link_submission(Checks checks, const Sandbox& sandbox, const Kit& kit,
                                      const std::filesystem::path& build, std::string& said,
                                      const CompileWords& words = {});
std::filesystem::path link_starter(Checks checks, const Sandbox& sandbox, const Kit& kit,
                                   const std::filesystem::path& build);

}  // namespace glassbox::labs::grading
