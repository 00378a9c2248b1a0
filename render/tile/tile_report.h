// The work of the tile engine for a picture, in addition to the statistics that both engines count.
#pragma once

#include <cstdint>
#include <vector>

namespace glassbox {

struct TileReport {
  // How long a thread was working in each stage, in milliseconds.
  struct Thread {
    double vertex_ms = 0, triangle_ms = 0, fragment_ms = 0;
  };
  std::vector<Thread> threads;  // the threads that took part

  std::uint64_t rounds = 0, tiles = 0;
  std::uint64_t triangles = 0;  // triangles of the draws that were drawn
  // Draws that were drawn, and runs of draws of one mesh that went through the stages together.
  std::uint64_t draws = 0, runs = 0;
  std::uint64_t list_entries = 0;     // primitives in the tiles' lists, counted once for each tile
  std::uint64_t large_triangles = 0;  // set up one by one
  std::uint64_t plane_bytes = 0;      // size of the framebuffer's images
  // The number of the scene's textures; and of those whose mip chains exist, because a pixel of
  // this picture or an earlier one has sampled them.
  std::uint64_t textures = 0, textures_made = 0;
};

}  // namespace glassbox
