// Options that name the files of a report.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"

namespace glassbox {

// Adds --json FILE|-, which writes `what` as JSON.
CLI::Option* add_json_output(CLI::App& command, std::optional<std::string>& target,
                             const std::string& what = "the printed output");

// Adds --html FILE, which writes a page. `help` is the option's text in --help.
CLI::Option* add_html_output(CLI::App& command, std::optional<std::string>& target,
                             const std::string& help);

// Adds --max-mb N: an output of more megabytes is refused; `of` says which output. (32 bits,
// because CLI11 would wrap a negative number of 64 bits around.)
CLI::Option* add_max_megabytes(CLI::App& command, std::uint32_t& target, const std::string& of);

}  // namespace glassbox
