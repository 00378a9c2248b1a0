// What the tile engine did, for people and for machines: time thread by thread, and the bytes of its tables.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/render/engine/settings.h>
#include <glassbox/render/engine/statistics.h>
#include <glassbox/render/tile/tile_report.h>

namespace glassbox::app {

// Tables that a stage reads and writes, each counted once: not what stays in a core's cache, such as a tile's own buffer, and not
// how often caches fetch the same line.
struct StageBytes {
  std::uint64_t read = 0, written = 0;
};
struct TileBytes {
  StageBytes vertices;   // positions and normals as modelled; entries of the screen, eye space
  StageBytes triangles;  // indices and entries of the screen; lists of the tiles, large triangles
  StageBytes fragments;  // those lists, entries and indices again; the planes of the framebuffer
};
TileBytes bytes_moved(const Statistics& statistics, const TileReport& report);

std::string tile_text(const Statistics& statistics, const TileReport& report);
nlohmann::ordered_json to_json(const Statistics& statistics, const TileReport& report);

}  // namespace glassbox::app
