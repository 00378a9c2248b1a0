// A pixel's history as a table for a terminal.
#pragma once

#include <string>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/history.h>

namespace glassbox::app {

// One row for each event; of the triangles that miss the pixel's centre the nearest few, or all.
std::string history_text(const Scene& scene, const PixelHistory& history, bool all_misses);

}  // namespace glassbox::app
