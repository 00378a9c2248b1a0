// Where machine-readable results go: a file, written wholly or not at all, or standard output.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/base/error.h>

namespace glassbox::app {

// `target` is a path, or "-" for standard output.
Result<void> write_json(const std::string& target, const nlohmann::ordered_json& json);

// Writes text to such a target as it is.
Result<void> write_text(const std::string& target, const std::string& text);

// An error if `path` does not end in `extension` (".pfm"), in either case.
Result<void> check_extension(const std::string& path, const std::string& extension);

// What can be known before a long run: an error if the directory of one of the paths does not exist, or if two of them
// are the same file.
Result<void> check_outputs(const std::vector<std::string>& paths);

// The second half of it, also for files in a directory that is made later; and an error if an output is one of `inputs`.
Result<void> check_distinct(const std::vector<std::string>& outputs,
                            const std::vector<std::string>& inputs = {});

// The check of a report's outputs before a long run: its page, an .html file, and its data, which may go to standard output.
Result<void> check_report_outputs(const std::optional<std::string>& page,
                                  const std::optional<std::string>& data);

}  // namespace glassbox::app
