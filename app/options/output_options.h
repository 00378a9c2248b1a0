// Options that name where a report goes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/options/cli_fwd.h"

namespace glassbox::app {

// --json FILE|-: `what` as JSON.
CLI::Option* add_json_output(CLI::App& command, std::optional<std::string>& target,
                             const std::string& what = "the same");

// --html FILE: a page. `help` says of what.
CLI::Option* add_html_output(CLI::App& command, std::optional<std::string>& target,
                             const std::string& help);

// --max-mb N: more megabytes than that are not written; `of` says of what. (32 bits: CLI11 wraps a negative number of 64.)
CLI::Option* add_max_megabytes(CLI::App& command, std::uint32_t& target, const std::string& of);

}  // namespace glassbox::app
