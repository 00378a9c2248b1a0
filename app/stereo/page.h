// The report as one HTML page that needs nothing else: no network, no other file.
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

// A page has some ten pictures: an error where they would be more than a browser likes to open.
Result<void> check_page_size(int width, int height);

// `report` is stereo_json's, after the scene's name and the picture's size.
Result<std::string> make_stereo_page(const StereoFindings& found,
                                     const nlohmann::ordered_json& report,
                                     const StereoPageOrigin& origin);

}  // namespace glassbox::app
