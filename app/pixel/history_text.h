// A pixel's history as a table for a terminal.
#pragma once

#include <string>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/history.h>

namespace glassbox::app {

// One row per event. The few triangles nearest to the pixel's centre that miss it, or all of them.
std::string history_text(const Scene& scene, const PixelHistory& history, bool all_misses);

}  // namespace glassbox::app
