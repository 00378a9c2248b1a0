// What submissions of a lab are compiled with: made once, by trusted code, and read by every compilation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/sources.h"

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

struct Kit {
  std::filesystem::path readable;  // all of it that a submission's compiler sees
  // Headers: those of the lab that its own student.cpp includes, and no others.
  std::filesystem::path include;
  std::vector<std::filesystem::path> objects;  // the runner without the student's functions
  std::string compiler;                        // its path
};

// Makes the kit of the lab labs/FOLDER in `directory`, which must be absolute, or finds the one that was made there. It appears
// whole: several may make the same one at the same time. An error where it is another lab's or another compiler's.
Result<Kit> make_kit(const Sources& sources, const std::string& folder,
                     const std::filesystem::path& directory);

// What submissions see of the kit, in another place: one that every user can reach.
Result<Kit> copy_kit(const Kit& kit, const std::filesystem::path& directory);

// The call that makes `program` of `source`; both are looked for in the directory that it is called in, where kFilesRead then
// names the files that were included.
std::vector<std::string> compile_command(const Kit& kit, const std::string& source,
                                         const std::string& program);
inline constexpr const char* kFilesRead = "files-read";

// The files that a compiler's rule "student.o: student.cpp a.h" names, without the first.
std::vector<std::filesystem::path> headers_of(const std::string& rule);

}  // namespace glassbox::labs::grading
