// What a student handed in: one file is taken, and taken with care.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// Bytes; a solution has some 10 KiB.
inline constexpr std::size_t kLargestSource = std::size_t(1) << 20;

// The text of student.cpp at the top of the folder, or in the only folder in it (what unpacking an archive leaves). Links are not
// followed, and what is no regular file, or larger than kLargestSource, is refused: a link to the solution is no
// submission, and a pipe would never end.
Result<std::string> read_submission(const std::filesystem::path& folder);

// The text of the file `name`, found and refused by the rules of read_submission().
Result<std::string> read_submitted(const std::filesystem::path& folder, const std::string& name);

// The folders of a class, by name: of every folder in `submissions` but those that begin with a dot. Links are passed over.
Result<std::vector<std::string>> list_submissions(const std::filesystem::path& submissions);

}  // namespace glassbox::labs::grading
