// What submissions of a lab are compiled with: made once, by trusted code, and read by every compilation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/sources.h"

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// A runner puts the checks that students have, or all of them. Of hidden checks there is nothing in the visible runner.
enum class Checks { kVisible, kAll };

struct Kit {
  // Headers: those of the lab that its own student.cpp includes, and no others. All of the kit that a submission's compiler sees.
  std::filesystem::path include;
  // The two runners without the student's functions; for the linker alone, when the submission's code has been compiled.
  std::vector<std::filesystem::path> visible, all;
  std::filesystem::path starter;  // student.cpp as students get it, compiled
  std::string compiler;           // its path
  std::string fingerprint;        // of all that it was made from

  const std::vector<std::filesystem::path>& objects(Checks checks) const {
    return checks == Checks::kVisible ? visible : all;
  }
};

// Makes the kit of the lab labs/FOLDER in `directory`, which must be absolute, or finds the one that was made there. It appears
// whole: several may make the same one at the same time. An error where it is another lab's, another compiler's or of other
// sources.
Result<Kit> make_kit(const Sources& sources, const std::string& folder,
                     const std::filesystem::path& directory);

// Kit::fingerprint of the kit that would be made.
Result<std::string> kit_fingerprint(const Sources& sources, const std::string& folder);

// The kit in another place: one where every user can reach its headers.
Result<Kit> copy_kit(const Kit& kit, const std::filesystem::path& directory);

// Compiles a file of the lab's own as a student's is compiled, so that the numbers are the same. `includes` are searched for headers.
Result<void> compile_own(const std::string& compiler, const std::filesystem::path& source,
                         const std::vector<std::filesystem::path>& includes,
                         const std::filesystem::path& object);

// The calls that make a program of student.cpp, one after the other. The files are looked for in the directory `build` that they
// are called in, where kFilesRead then names those that were included.
struct CompileWords {
  bool warnings = false;
  bool debugger = false;  // with what a debugger reads, and every variable in its place (-O0 -g)
  bool timed = false;     // as fast as the library (-O2); the numbers are the same
  bool sanitize =
      false;  // with AddressSanitizer and UndefinedBehaviorSanitizer, which end the program with a report
  std::string
      stands_for;      // the folder that a debugger is to look for student.cpp in; empty for none
  bool quotes = true;  // what a message is about, from the file that it names
};
std::vector<std::string> assembly_command(const Kit& kit, const CompileWords& words,
                                          const std::filesystem::path& build);
// The preprocessor alone: every file that it opens is named in what it says, in a line of dots, a space and the path.
std::vector<std::string> preprocessor_command(const Kit& kit, const CompileWords& words,
                                              const std::filesystem::path& build);
std::vector<std::string> object_command(const Kit& kit);
std::vector<std::string> link_command(const Kit& kit, const std::vector<std::string>& objects,
                                      const std::string& program, const CompileWords& words);
inline constexpr const char* kSource = "student.cpp";
inline constexpr const char* kPreprocessed = "student.ii";
inline constexpr const char* kAssembly = "student.s";
inline constexpr const char* kObject = "student.o";
inline constexpr const char* kFilesRead = "files-read";

// The files that a compiler's rule "student.o: student.cpp a.h" names, without the first.
std::vector<std::filesystem::path> headers_of(const std::string& rule);

}  // namespace glassbox::labs::grading
