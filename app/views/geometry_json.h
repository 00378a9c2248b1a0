// The report of two views as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/views/geometry_report.h"

namespace glassbox::app {

// Matrices by rows; px and degrees where names say so; null where nothing was found.
nlohmann::ordered_json geometry_json(const GeometryInput& input, const GeometryReport& report);

}  // namespace glassbox::app
