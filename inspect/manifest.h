// The manifest of an inspector page: what the page's script knows of the run besides the columns,
// namely matrices, the parameters they are made from, and counts.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "inspect/page.h"

#include <glassbox/render/trace/columns.h>

namespace glassbox::inspect {

nlohmann::ordered_json manifest_of(const Scene& scene, const Camera& camera, const View& view,
                                   const RenderSettings& settings, const InspectOptions& options,
                                   const ColumnRun& run);

}  // namespace glassbox::inspect
