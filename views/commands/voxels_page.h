// The voxels as one HTML page that needs no other file. The reader can turn and slice them, and ask
// for each voxel why it is there.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "views/commands/voxels_report.h"

#include <glassbox/base/error.h>

namespace glassbox::views {

struct VoxelsPageOrigin {
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
};

// Makes the page. `json` is the JSON of voxels_json. The report must have the verdicts. An error if
// there are too many voxels, pictures or pixels for a browser.
Result<std::string> make_voxels_page(const VoxelsInput& input,
                                     const views::ColoringRequest& request,
                                     const VoxelsReport& report, const nlohmann::ordered_json& json,
                                     const VoxelsPageOrigin& origin);

}  // namespace glassbox::views
