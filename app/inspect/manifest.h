// What the script of an inspector page knows of the run besides its columns: matrices, the parameters they come from, counts.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/inspect/page.h"

#include <glassbox/render/trace/columns.h>

namespace glassbox::app {

nlohmann::ordered_json manifest_of(const Scene& scene, const Camera& camera, const View& view,
                                   const RenderSettings& settings, const InspectOptions& options,
                                   const ColumnRun& run);

}  // namespace glassbox::app
