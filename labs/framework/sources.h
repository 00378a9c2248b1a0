// Finds the labs' files, and lists those that a student's code is compiled with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs {

struct Sources {
  std::filesystem::path labs;     // has NN-name/ and framework/
  std::filesystem::path include;  // has glassbox/
  // the folder of one lab that is not in `labs`; it is then used in place of every lab's folder
  std::filesystem::path outside = {};

  std::filesystem::path folder_of(const std::string& lab) const {
    return outside.empty() ? labs / lab : outside;
  }
};

// Finds the sources beside an installed program (share/glassbox/labs, include), or the source tree
// that it was built from.
Result<Sources> find_sources();

struct SourceFile {
  std::string path;  // "runner.cpp", "labs/framework/runner.h"
  std::string text;
};

// The files around student.cpp in a student's folder: student.h, cases.h, runner.cpp and the
// framework's files that they include. `with_hidden`: including the parts for hidden checks.
Result<std::vector<SourceFile>> support_files(const Sources& sources, const std::string& folder,
                                              bool with_hidden);

// The library's headers that the `files` include, directly or indirectly: mostly types. A student's
// code is compiled with no other headers, since some of the library's headers contain the answers.
Result<std::vector<SourceFile>> library_headers(const Sources& sources,
                                                const std::vector<SourceFile>& files);

// student.cpp of the lab, including the solution.
Result<std::string> solution_text(const Sources& sources, const std::string& folder);

Result<std::string> read_text_file(const std::filesystem::path& path);

// Writes the file only if its text changes, so that an up-to-date file keeps its date. Directories
// are created.
Result<void> write_if_changed(const std::filesystem::path& path, const std::string& text);

}  // namespace glassbox::labs
