// The files that submissions of a lab are compiled with: made once, by trusted code, and read by
// every compilation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/sources.h"

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// Which checks a runner contains: those that students have, or all. The visible runner contains
// nothing of the hidden checks.
enum class CheckSelection { kVisible, kAll };

struct BuildKit {
  // Headers: those of the lab that its own student.cpp includes, and no others. The compiler of a
  // submission sees nothing else of the kit.
  std::filesystem::path include;
  // The two runners without the student's functions; only the linker gets them, after the
  // submission's code has been compiled.
  std::vector<std::filesystem::path> visible, all;
  std::filesystem::path starter;  // student.cpp as students get it, compiled
  // The library that hides files from the compiler where the sandbox does not (compiler_view.cpp)
  std::filesystem::path view;
  std::string compiler;     // the path of the compiler
  std::string fingerprint;  // a digest of all files and settings that it was made from

  const std::vector<std::filesystem::path>& objects(CheckSelection checks) const {
    return checks == CheckSelection::kVisible ? visible : all;
  }
};

// Makes the kit (the files that submissions are compiled with) of the lab labs/FOLDER in
// `directory`, which must be absolute, or finds the kit that was made there. It appears complete,
// in one step, so several processes may make the same kit at the same time. It is an error if the
// kit there belongs to another lab, another compiler or other sources.
Result<BuildKit> make_build_kit(const Sources& sources, const std::string& folder,
                                const std::filesystem::path& directory);

// The BuildKit::fingerprint that make_build_kit() would give.
Result<std::string> build_kit_fingerprint(const Sources& sources, const std::string& folder);

// Copies the kit to a directory where every user can reach its headers.
Result<BuildKit> copy_build_kit(const BuildKit& kit, const std::filesystem::path& directory);

// Compiles one of the lab's own files in the same way as a student's file, so that both compute the
// same numbers. Headers are searched in `includes`.
Result<void> compile_lab_file(const std::string& compiler, const std::filesystem::path& source,
                              const std::vector<std::filesystem::path>& includes,
                              const std::filesystem::path& object);

// Compiles compiler_view.cpp to a shared library.
Result<void> compile_view(const std::string& compiler, const Sources& sources,
                          const std::filesystem::path& library);

// The options of the commands that make a program of student.cpp, one after the other. The commands
// are run in the directory `build` and look for the files there; afterwards kFilesRead there lists
// the files that were included.
struct CompileOptions {
  bool warnings = false;
  // for a debugger: with debug information and without optimisation (-O0 -g)
  bool debugger = false;
  bool timed = false;  // as fast as the library (-O2), with the same numerical results
  // with AddressSanitizer and UndefinedBehaviorSanitizer, which end the program with a report
  bool sanitize = false;
  // the folder in which a debugger is to look for student.cpp; empty for none
  std::string debug_source_folder;
  bool quotes = true;  // whether messages quote the line of the file that they are about
};
std::vector<std::string> assembly_command(const BuildKit& kit, const CompileOptions& options,
                                          const std::filesystem::path& build);
// The command that runs only the preprocessor. Its output names every file that it opens, in a line
// of dots, a space and the path.
std::vector<std::string> preprocessor_command(const BuildKit& kit, const CompileOptions& options,
                                              const std::filesystem::path& build);
std::vector<std::string> object_command(const BuildKit& kit);
std::vector<std::string> link_command(const BuildKit& kit, const std::vector<std::string>& objects,
                                      const std::string& program, const CompileOptions& options);
inline constexpr const char* kSource = "student.cpp";
inline constexpr const char* kPreprocessed = "student.ii";
inline constexpr const char* kAssembly = "student.s";
inline constexpr const char* kObject = "student.o";
inline constexpr const char* kFilesRead = "files-read";

// The files that a compiler's dependency rule "student.o: student.cpp a.h" names, except the first.
std::vector<std::filesystem::path> headers_of(const std::string& rule);

}  // namespace glassbox::labs::grading
