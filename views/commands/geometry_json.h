// The report on two views as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "views/commands/geometry_report.h"

namespace glassbox::views {

// Matrices are written by rows. Names say which numbers are px or degrees. What was not found is
// null.
nlohmann::ordered_json geometry_json(const GeometryInput& input, const GeometryReport& report);

}  // namespace glassbox::views
