// The report as one HTML page that needs no network and no other file.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/stereo/findings.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

struct StereoPageOrigin {
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
};

// A page has about ten pictures. An error if they would be too large for a browser.
Result<void> check_page_size(int width, int height);

// `report` is the JSON of stereo_json, which follows the scene's name and the picture's size.
Result<std::string> make_stereo_page(const StereoFindings& found,
                                     const nlohmann::ordered_json& report,
                                     const StereoPageOrigin& origin);

}  // namespace glassbox::app
