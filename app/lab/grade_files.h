// The files that grading reads and writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "labs/grading/overview.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// Where the result of a submission goes: results.json, and where they are named the same for GitHub Classroom, JUnit's XML and the
// text for Moodle's Virtual Programming Lab.
struct ResultFiles {
  std::string output, classroom = {}, junit = {}, vpl = {};
};

// An error if the directory of one does not exist, or if two are the same file or the mark beside results.json.
Result<void> check_result_files(const ResultFiles& files);

// Before a submission is graded: a mark beside results.json that its grading is under way. The result of an
// earlier grading stays until there is another; where there is none, `unfinished` takes its place.
Result<void> begin_results(const ResultFiles& files, const nlohmann::ordered_json& unfinished);

// Each file is whole or not there. The mark goes.
Result<void> write_results(const ResultFiles& files, const nlohmann::ordered_json& results);

// Whether the result of a finished grading with this digest is there. The mark goes if it is.
bool is_up_to_date(const std::string& output, const std::string& digest);

// Of every folder in `results`, by name. A results.json that cannot be read counts as unfinished.
Result<std::vector<labs::grading::Row>> read_results(const std::filesystem::path& results);

// The lab whose student.h lies in the folder; null if it is none.
const labs::Lab* lab_of_folder(const std::vector<labs::Lab>& labs, const labs::Sources& sources,
                               const std::filesystem::path& folder);

}  // namespace glassbox::app
