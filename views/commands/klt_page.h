// The bands and their components as one HTML page that needs no other file. It reconstructs the
// bands from any number of components.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "views/commands/klt_report.h"

#include <glassbox/base/error.h>

namespace glassbox::views {

struct KltPageOrigin {
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
};

// An error if there are too many samples for a browser.
Result<void> check_klt_page(std::uint64_t width, std::uint64_t height, std::uint64_t bands);

// `json` is the JSON of klt_json.
Result<std::string> make_klt_page(const KltInput& input, const KltReport& report,
                                  const nlohmann::ordered_json& json, const KltPageOrigin& origin);

}  // namespace glassbox::views
