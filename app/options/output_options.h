// Options that name where a report goes.
#pragma once

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

}  // namespace glassbox::app
