// A pixel's history as a table for a terminal.
#pragma once

#include <string>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/history.h>

namespace glassbox::app {

// One row per event. Of the triangles that miss the pixel's centre, only the few nearest, or all.
std::string history_text(const Scene& scene, const PixelHistory& history, bool all_misses);

}  // namespace glassbox::app
