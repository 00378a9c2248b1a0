// What a student handed in: one file is taken, and taken with care.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// Bytes; a solution has some 10 KiB.
inline constexpr std::size_t kLargestSource = std::size_t(1) << 20;

// The text of student.cpp: of a folder at its top, in the only folder in it (what unpacking an archive leaves) or in the only
// archive in it (what Moodle leaves); of an archive (archive.h); of a file NAME.cpp itself. Links are not followed, and what is no
// regular file, or larger than kLargestSource, is refused: a link to the solution is no submission, and a pipe would
// never end. Where it is missing, the error names the files that were found.
Result<std::string> read_submission(const std::filesystem::path& submission);

// The text of a source by its path: an ordinary file, no larger than kLargestSource.
Result<std::string> read_source(const std::filesystem::path& path);

// The text of the file `name`, found and refused by the rules of read_submission().
Result<std::string> read_submitted(const std::filesystem::path& submission,
                                   const std::string& name);

// The error of a submission without the file; `found` are the files that it has.
tl::unexpected<Error> missing(const std::string& name, std::vector<std::filesystem::path> found);

// The name of a submission in a class: that of its folder, or of its file without what says what kind it is.
std::string submission_name(const std::filesystem::path& path);

// What stands beside the folders of results, so that no submission may be called so.
inline constexpr const char* kTableOfClass = "class.csv";
inline constexpr const char* kPageOfClass = "index.html";

// One submission of a class.
struct Submission {
  std::string name;  // as the student is to be named
  std::filesystem::path path;
};

struct ClassFolder {
  std::vector<Submission> submissions;  // by name
  std::vector<std::string> skipped;     // what is none, each with the reason
};

// Of a class's folder: every folder (a link to one too, which is then refused and not passed over), archive and .cpp file. Names
// that begin with a dot are not looked at.
Result<ClassFolder> list_submissions(const std::filesystem::path& folder);

// The folders in a folder, by name, but those that begin with a dot.
Result<std::vector<std::string>> list_folders(const std::filesystem::path& folder);

}  // namespace glassbox::labs::grading
