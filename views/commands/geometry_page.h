// The report on two views as one HTML page that needs no other file: it shows both pictures, and
// for a point in one its epipolar line in the other.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "views/commands/geometry_input.h"

#include <glassbox/base/error.h>

namespace glassbox::views {

struct GeometryPageOrigin {
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
};

// Makes the page. `report` is the JSON of geometry_json. The page has the first 2000 matches.
// Errors: an input without pictures, and pictures that are too large for a browser.
Result<std::string> make_geometry_page(const GeometryInput& input,
                                       const nlohmann::ordered_json& report,
                                       const GeometryPageOrigin& origin);

}  // namespace glassbox::views
