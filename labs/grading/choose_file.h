// Which of the files in a submission is the one that is graded.
//
// A file has the wanted name if it is called so ("student.cpp"), in upper or lower case
// ("Student.cpp"), or is a copy that a browser or a course's site numbered ("student (1).cpp",
// "student(1).cpp", "student-1.cpp"). If there are several, the one in the fewest folders is taken;
// among these the exact name, then the name in another case, then the copy with the highest number;
// and at last the path that comes first by its bytes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace glassbox::labs::grading {

// Whether the file has the wanted name, or one of its variants.
bool has_wanted_name(const std::filesystem::path& file, const std::string& wanted);

// Whether `a` is taken rather than `b`. Both are paths within the submission, and have the wanted
// name.
bool is_taken_before(const std::filesystem::path& a, const std::filesystem::path& b,
                     const std::string& wanted);

// The name of an archive without its ending, which may be in upper case: "ann" for "ann.TAR.GZ".
// Other names stay as they are. The endings are those of is_archive() in archive.h.
std::string archive_stem(const std::filesystem::path& file);

// The same as is_taken_before() for archives, which may have any name: in the fewest folders,
// without a number, with the highest number, and at last by the bytes of the path.
bool is_archive_taken_before(const std::filesystem::path& a, const std::filesystem::path& b);

// Whether a path in a submission was made by an operating system or an editor: a part of it begins
// with a dot, or is "__MACOSX".
bool is_ignored(const std::filesystem::path& path);

// What a student reads about the choice: the file that was taken and those that were not. Empty if
// there was nothing to choose and the file has the wanted name.
std::string note_of_choice(const std::filesystem::path& taken,
                           std::vector<std::filesystem::path> not_taken, const std::string& wanted);

}  // namespace glassbox::labs::grading
