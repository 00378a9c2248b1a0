// Reads and writes the result files of grading.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "labs/grading/class_overview.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

// The files for the result of a submission: results.json, and, if their paths are given, the same
// result for GitHub Classroom, as JUnit XML, and as text for Moodle's Virtual Programming Lab.
struct ResultFiles {
  std::string output, classroom = {}, junit = {}, vpl = {};
};

// An error if the directory of a file does not exist, if two are the same file, or if one is the
// mark file next to results.json.
Result<void> check_result_files(const ResultFiles& files);

// Call it before a submission is graded. Writes a mark file next to results.json that says that the
// grading has begun. The result of an earlier grading stays until it is replaced; if there is no
// earlier result, `unfinished` is written.
Result<void> begin_results(const ResultFiles& files, const nlohmann::ordered_json& unfinished);

// Writes each result file completely or not at all, then removes the mark file.
Result<void> write_results(const ResultFiles& files, const nlohmann::ordered_json& results);

// Whether there is a result of a finished grading with this digest. If so, removes the mark file.
bool is_up_to_date(const std::string& output, const std::string& digest);

// The results of every folder in `results`, sorted by name. A results.json that cannot be read
// counts as unfinished.
Result<std::vector<labs::grading::ClassRow>> read_results(const std::filesystem::path& results);

// The lab whose student.h is in the folder; null if there is none.
const labs::Lab* lab_of_folder(const std::vector<labs::Lab>& labs, const labs::Sources& sources,
                               const std::filesystem::path& folder);

}  // namespace glassbox::labs
