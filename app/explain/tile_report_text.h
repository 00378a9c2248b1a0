// The report on the tile engine's work, as text and as JSON: the time of each thread, and the bytes
// of the tables that it reads and writes.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/render/engine/settings.h>
#include <glassbox/render/engine/statistics.h>
#include <glassbox/render/tile/tile_report.h>

namespace glassbox::app {

// The bytes of the tables that a stage reads and writes, each table counted once. Data that stay in
// a core's cache, such as a tile's own buffer, and repeated fetches of the same cache line are not
// counted.
struct StageBytes {
  std::uint64_t read = 0, written = 0;
};
struct TileBytes {
  // reads positions and normals in object space; writes snapped screen coordinates and eye-space
  // data
  StageBytes vertices;
  // reads indices and screen coordinates; writes the tiles' lists of triangles, and large triangles
  StageBytes triangles;
  // reads the tiles' lists, large triangles, indices and screen coordinates; writes the framebuffer
  StageBytes fragments;
};
TileBytes bytes_moved(const Statistics& statistics, const TileReport& report);

std::string tile_text(const Statistics& statistics, const TileReport& report);
nlohmann::ordered_json to_json(const Statistics& statistics, const TileReport& report);

}  // namespace glassbox::app
