// The report of two views as one HTML page that needs nothing else: both pictures, a point in one and its line in the other.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/views/geometry_input.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

struct GeometryPageOrigin {
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
};

// `report` is geometry_json's. Refused: an input without pictures, and pictures larger than a browser likes to open. The page has
// the first 2000 matches.
Result<std::string> make_geometry_page(const GeometryInput& input,
                                       const nlohmann::ordered_json& report,
                                       const GeometryPageOrigin& origin);

}  // namespace glassbox::app
