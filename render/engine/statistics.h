// Counts of the input and output of every stage, and times.
#pragma once

#include <cstdint>

namespace glassbox {

struct Statistics {
  // Counts of the assembly of primitives.
  std::uint64_t instances = 0;
  std::uint64_t triangles = 0;   // all triangles of the draws, also those without area
  std::uint64_t degenerate = 0;  // without area as modelled: never drawn
  // Triangles of draws and clusters that the plan leaves out: no stage processes them.
  std::uint64_t left_out = 0;
  std::uint64_t lines = 0;  // wireframe edges are not counted here
  std::uint64_t points = 0;

  // Clusters (of up to 64 triangles) that were tested, and how many of them were outside the view
  // or turned away (render/plan/cluster_cull.h).
  std::uint64_t clusters = 0, clusters_outside = 0, clusters_turned_away = 0;
  // Triangles of clusters outside or turned away; also in left_out.
  std::uint64_t left_out_in_clusters = 0;

  // Counts of the vertex stage.
  std::uint64_t vertices = 0;       // positions transformed to clip space
  std::uint64_t moved_in_x = 0;     // copied from a pair's first eye, with a new x only
  std::uint64_t plane_tests = 0;    // positions tested for whether they need clipping
  std::uint64_t normals = 0;        // transformed to eye space, of vertices and of faces
  std::uint64_t eye_positions = 0;  // positions transformed to eye space

  // Counts of culling in object space, if it is enabled.
  std::uint64_t culled_early = 0;  // triangles that certainly face the wrong way: not clipped

  // Counts of clipping. triangles - degenerate = left_out + culled_early + rejected + clipped_away
  // + clipped + the number of triangles that stay whole.
  std::uint64_t rejected = 0;      // all corners are outside one plane
  std::uint64_t clipped_away = 0;  // nothing is left after clipping
  std::uint64_t clipped = 0;       // cut, and something is left
  // Triangles after clipping: those that stay whole, and those of the fans into which the clipped
  // polygons are split.
  std::uint64_t after_clipping = 0;

  // Counts of the setup. after_clipping = zero_area + culled + set_up.
  std::uint64_t zero_area = 0;  // no area after snapping
  std::uint64_t culled = 0;     // facing the wrong way
  std::uint64_t set_up = 0;

  // Counts of fragments; with several samples per pixel, the tile engine counts each sample.
  // covered = depth_failed + discarded + written.
  std::uint64_t covered = 0;
  std::uint64_t depth_failed = 0;
  std::uint64_t discarded = 0;  // alpha is below the mask's cutoff
  std::uint64_t written = 0;
  std::uint64_t blended = 0;  // how many of the written ones were blended

  // Wall-clock time of this run, in milliseconds.
  double prepare_ms = 0;   // triangulation, matrices
  double vertex_ms = 0;    // object space to clip space
  double triangle_ms = 0;  // clip, divide, viewport, setup, cull
  double fragment_ms = 0;  // coverage, depth, shading, blending, making mip chains
};

}  // namespace glassbox
