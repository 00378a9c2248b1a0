// Where machine-readable results go: a file, written wholly or not at all, or standard output.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <glassbox/base/error.h>

namespace glassbox::app {

// `target` is a path, or "-" for standard output.
Result<void> write_json(const std::string& target, const nlohmann::ordered_json& json);

}  // namespace glassbox::app
