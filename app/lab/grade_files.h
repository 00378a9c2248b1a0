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

// results.json to `output`, and what GitHub Classroom takes to `classroom` unless that is empty. Each is whole or not there.
Result<void> write_results(const std::string& output, const std::string& classroom,
                           const nlohmann::ordered_json& results);

// Of every folder in `results`, by name. A results.json that cannot be read counts as unfinished.
Result<std::vector<labs::grading::Row>> read_results(const std::filesystem::path& results);

// The lab whose student.h lies in the folder; null if it is none.
const labs::Lab* lab_of_folder(const std::vector<labs::Lab>& labs, const labs::Sources& sources,
                               const std::filesystem::path& folder);

}  // namespace glassbox::app
