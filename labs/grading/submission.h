// Reads a student's submission: one file is taken from it, with care.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// The size of the largest source that is accepted, in bytes; a solution has some 10 KiB.
inline constexpr std::size_t kLargestSource = std::size_t(1) << 20;

// How many archives in a folder are looked at for student.cpp. Together they may have the contents
// of one, kMaxUnpacked (archive.h).
inline constexpr std::size_t kMaxArchives = 8;

struct SubmittedFile {
  std::string text;
  // For the student: which file was taken, if another one could have been meant; else empty.
  std::string note;
};

// student.cpp of a submission: a folder or an archive (archive.h) that has it at any depth, a
// folder with such an archive in it (as Moodle leaves it), or a file NAME.cpp itself. choose_file.h
// says what may be its name, and which one is taken of several. Links are not followed, and
// anything that is no regular file or is larger than kLargestSource is refused: a link to the
// solution is no submission, and reading a pipe might never end. If the file is missing, the error
// names the files that were found.
Result<SubmittedFile> read_submission(const std::filesystem::path& submission);

// The text of a source file at this path: an ordinary file, no larger than kLargestSource.
Result<std::string> read_source(const std::filesystem::path& path);

// The file `name`, found and refused by the rules of read_submission().
Result<SubmittedFile> read_submitted_file(const std::filesystem::path& submission,
                                          const std::string& name);

// The error for a submission without the file; `found` are the files that it has.
tl::unexpected<Error> missing_file_error(const std::string& name,
                                         std::vector<std::filesystem::path> found);

// The name of a submission in a class: the name of its folder, or of its file without the ending.
std::string submission_name(const std::filesystem::path& path);

// A file of this name is written beside the folders of results, so no submission may have the name.
inline constexpr const char* kTableOfClass = "class.csv";
inline constexpr const char* kPageOfClass = "index.html";

// One submission of a class.
struct Submission {
  std::string name;  // the student's name in the results
  std::filesystem::path path;
  // Other files of this name, which are not graded: archives and sources beside a folder, sources
  // beside an archive.
  std::vector<std::string> also;
};

struct ClassFolder {
  std::vector<Submission> submissions;  // by name; there may be none
  std::vector<std::string> skipped;     // entries that are no submission, each with the reason
};

// Lists a class's folder: every folder (also a link to one, which is refused later instead of being
// skipped), archive and .cpp file. Names that begin with a dot are ignored.
Result<ClassFolder> list_submissions(const std::filesystem::path& folder);

// The error for a folder without a submission.
tl::unexpected<Error> no_submission_error(const std::filesystem::path& folder);

// The folders in a folder, by name, except those whose name begins with a dot. There may be none.
Result<std::vector<std::string>> list_folders(const std::filesystem::path& folder);

}  // namespace glassbox::labs::grading
