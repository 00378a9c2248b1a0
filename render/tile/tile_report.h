// What the tile engine did for a picture, beside the statistics that both engines keep.
#pragma once

#include <cstdint>
#include <vector>

namespace glassbox {

struct TileReport {
  // Time in which a thread was at work, by stage, in milliseconds.
  struct Thread {
    double vertex_ms = 0, triangle_ms = 0, fragment_ms = 0;
  };
  std::vector<Thread> threads;  // those that took part

  std::uint64_t rounds = 0, tiles = 0;
  std::uint64_t triangles = 0;  // of the draws that were drawn
  // Draws that were drawn; and runs of them, of one mesh each, that went through the stages together.
  std::uint64_t draws = 0, runs = 0;
  std::uint64_t list_entries = 0;     // primitives in the tiles' lists, once for each tile
  std::uint64_t large_triangles = 0;  // set up one by one
  std::uint64_t plane_bytes = 0;      // of the framebuffer's planes
  // Of the scene; and those whose levels exist, because a pixel of this picture or one before has looked at them.
  std::uint64_t textures = 0, textures_made = 0;
};

}  // namespace glassbox
