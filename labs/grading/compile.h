// Compiles a submission in the sandbox, and links the programs that run the checks.
#pragma once

#include <filesystem>
#include <string>

#include "labs/grading/build_kit.h"
#include "labs/grading/sandbox.h"

namespace glassbox::labs::grading {

struct CompileResult {
  // "compile error", "compile timeout", "grading did not finish"; empty if there is an object
  std::string failure;
  std::string messages;  // the compiler's errors or warnings
};

// Makes student.o in `build`, a directory of the sandbox's user. The text is compiled to assembly,
// which is checked (assembly.h) before it is assembled, so that no file except the lab's headers
// can get into student.o.
CompileResult compile_submission(const std::string& text, const Sandbox& sandbox,
                                 const BuildKit& kit, const std::filesystem::path& build,
                                 const CompileOptions& options = {});

// Links the program that runs `checks` on student.o, or on the lab's starter. The runner's objects
// are in `build` only during this call. Returns an empty path if there is no program; `messages`
// then says why.
std::filesystem::path link_submission(CheckSelection checks, const Sandbox& sandbox,
                                      const BuildKit& kit, const std::filesystem::path& build,
                                      std::string& messages, const CompileOptions& options = {});
std::filesystem::path link_starter(CheckSelection checks, const Sandbox& sandbox,
                                   const BuildKit& kit, const std::filesystem::path& build);

}  // namespace glassbox::labs::grading
