// A pixel's history as a table for a terminal.
#pragma once

#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/history.h>

namespace glassbox::app {

// The table has one row per event. It lists the few triangles that miss the pixel's centre most
// narrowly, or, if `all_misses`, all that miss it. The notes follow, and then what the pixel shows.
std::string history_text(const Scene& scene, const PixelHistory& history, bool all_misses,
                         const std::vector<std::string>& notes);

}  // namespace glassbox::app
