// The report as JSON, which is also the data for the page's script.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/stereo/findings.h"
#include "app/stereo/text.h"

namespace glassbox::app {

nlohmann::ordered_json stereo_json(const Scene& scene, const StereoFindings& found,
                                   const StereoWords& words);

}  // namespace glassbox::app
