// From a submission's text to the programs that put the checks to it, in the sandbox.
#pragma once

#include <filesystem>
#include <string>

#include "labs/grading/kit.h"
#include "labs/grading/sandbox.h"

namespace glassbox::labs::grading {

struct Compiled {
  std::string
      trouble;  // "compile error", "compile timeout", "grading did not finish"; empty if there is an object
  std::string said;  // by the compiler: errors, or warnings
};

// Makes student.o in `build`, a directory of the sandbox's user: compiled to assembly, which is read (assembly.h) before it is
// assembled, so that no file but the lab's headers gets into it.
Compiled compile_submission(const std::string& text, const Sandbox& sandbox, const Kit& kit,
                            const std::filesystem::path& build, const CompileWords& words = {});

// The program that puts `checks` to student.o, or to the lab's starter. The runner's objects lie in
// `build` for this call alone. Empty if there is none; `said` then says why.
std::filesystem::path link_submission(Checks checks, const Sandbox& sandbox, const Kit& kit,
                                      const std::filesystem::path& build, std::string& said,
                                      const CompileWords& words = {});
std::filesystem::path link_starter(Checks checks, const Sandbox& sandbox, const Kit& kit,
                                   const std::filesystem::path& build);

}  // namespace glassbox::labs::grading
