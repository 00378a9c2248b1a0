// What went into every stage and what came out.
#pragma once

#include <cstdint>

namespace glassbox {

struct Statistics {
  // Assembly.
  std::uint64_t instances = 0;
  std::uint64_t triangles = 0;   // numbered: those without area included
  std::uint64_t degenerate = 0;  // without area as modelled: never drawn
  std::uint64_t left_out =
      0;  // of draws, and of clusters, that the plan leaves out: no stage sees them
  std::uint64_t lines = 0;  // wireframe edges are not counted here
  std::uint64_t points = 0;

  // Clusters of triangles that were asked about together (render/plan/cluster_cull.h).
  std::uint64_t clusters = 0, clusters_outside = 0, clusters_turned_away = 0;
  std::uint64_t left_out_in_clusters = 0;  // triangles of the last two, among those left out

  // Vertex stage.
  std::uint64_t vertices = 0;       // positions carried to clip space
  std::uint64_t moved_in_x = 0;     // taken over from a pair's first eye, but for x
  std::uint64_t plane_tests = 0;    // positions asked whether clipping has to look at them
  std::uint64_t normals = 0;        // carried to eye space, of vertices and of faces
  std::uint64_t eye_positions = 0;  // positions carried to eye space

  // Culling in object space, where it was asked for.
  std::uint64_t culled_early = 0;  // facing the wrong way for certain: not clipped

  // Clipping. Triangles in = left out + culled early + rejected + clipped away + clipped + whole.
  std::uint64_t rejected = 0;      // all corners outside one plane
  std::uint64_t clipped_away = 0;  // nothing left after clipping
  std::uint64_t clipped = 0;       // cut, something left
  // Triangles that go on: whole ones, and the fans of the cut ones.
  std::uint64_t after_clipping = 0;

  // Setup. after_clipping = zero_area + culled + set_up.
  std::uint64_t zero_area = 0;  // after snapping
  std::uint64_t culled = 0;     // facing the wrong way
  std::uint64_t set_up = 0;

  // Fragments; with several samples to a pixel, the tile engine counts them sample by sample. covered = depth_failed + discarded + written.
  std::uint64_t covered = 0;
  std::uint64_t depth_failed = 0;
  std::uint64_t discarded = 0;  // by the alpha mask
  std::uint64_t written = 0;
  std::uint64_t blended = 0;  // of the written ones

  // Wall-clock time of this run, in milliseconds.
  double prepare_ms = 0;   // triangulation, matrices
  double vertex_ms = 0;    // object -> clip
  double triangle_ms = 0;  // clip, divide, viewport, setup, cull
  double fragment_ms = 0;  // coverage, depth, shading, blending; levels of textures, once
};

}  // namespace glassbox
