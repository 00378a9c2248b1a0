// The voxels as one HTML page that needs nothing else: turned, sliced, and asked why they are there.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/views/voxels_report.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

struct VoxelsPageOrigin {
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
};

// `json` is voxels_json's; the report has the verdicts. Refused: more voxels, pictures or pixels than a browser likes to open.
Result<std::string> make_voxels_page(const VoxelsInput& input,
                                     const views::ColoringRequest& request,
                                     const VoxelsReport& report, const nlohmann::ordered_json& json,
                                     const VoxelsPageOrigin& origin);

}  // namespace glassbox::app
