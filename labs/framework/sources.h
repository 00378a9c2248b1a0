// Where the labs' files are, and which of them a student's code is compiled with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs {

struct Sources {
  std::filesystem::path labs;     // has NN-name/ and framework/
  std::filesystem::path include;  // has glassbox/
  std::filesystem::path outside =
      {};  // a lab's folder that is not in `labs`, and stands for every lab

  std::filesystem::path folder_of(const std::string& lab) const {
    return outside.empty() ? labs / lab : outside;
  }
};

// Beside an installed program (share/glassbox/labs, include), or the source tree that it was built from.
Result<Sources> find_sources();

struct SourceFile {
  std::string path;  // "runner.cpp", "labs/framework/runner.h"
  std::string text;
};

// What stands around student.cpp, as it lies in a student's folder: student.h, cases.h, runner.cpp and the framework's files that
// they include. `with_hidden`: with the parts of hidden checks.
Result<std::vector<SourceFile>> support_files(const Sources& sources, const std::string& folder,
                                              bool with_hidden);

// The library's headers that those files include, and what these include: types, and little besides. A student's code is compiled
// with no others, since some would have the answers in them.
Result<std::vector<SourceFile>> library_headers(const Sources& sources,
                                                const std::vector<SourceFile>& files);

// student.cpp of the lab, with the solution.
Result<std::string> solution_text(const Sources& sources, const std::string& folder);

Result<std::string> read_text_file(const std::filesystem::path& path);

// Writes the file if its text is another, so that what is up to date stays so. Directories are made.
Result<void> write_if_changed(const std::filesystem::path& path, const std::string& text);

}  // namespace glassbox::labs
