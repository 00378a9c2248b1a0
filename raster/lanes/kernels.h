// The vectorised stages, compiled for each instruction set: the interface that the tile engine
// calls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glassbox/raster/lanes/tables.h>
#include <glassbox/raster/lanes/target.h>
#include <glassbox/raster/lanes/tile_buffer.h>

namespace glassbox {

struct Kernels {
  void (*transform_vertices)(const VertexJob& job);
  void (*transform_normals)(const NormalJob& job);
  void (*transform_positions)(const EyePositionJob& job);
  // Writes the selected triangles to `selected`, which has room for job.count + kMostLanes, and
  // returns their number.
  std::size_t (*select_triangles)(const SelectJob& job, const BinColumns& selected,
                                  SelectCounts& counts);
  // Draws into each of `tiles`, which cover the same part of the screen: one for each sample of a
  // pixel.
  void (*draw_small)(const SmallJob& job, const std::uint32_t* triangles, std::size_t count,
                     std::span<TileBuffer> tiles, FragmentCounts& counts);
  void (*draw_large)(const TriangleSetup& setup, Reference reference, TileBuffer& tile,
                     FragmentCounts& counts);
  // The same for a draw whose alpha is tested.
  void (*draw_small_masked)(const SmallJob& job, const AlphaTest& test,
                            const std::uint32_t* triangles, std::size_t count, TileBuffer& tile,
                            FragmentCounts& counts);
  void (*draw_large_masked)(const LargeTriangle& triangle, const AlphaTest& test,
                            Reference reference, TileBuffer& tile, FragmentCounts& counts);
  // The same for an opaque or alpha-tested draw, behind given depths. The tile's points are pixel
  // centres.
  void (*draw_small_behind)(const SmallJob& job, const BehindTest& test,
                            const std::uint32_t* triangles, std::size_t count, TileBuffer& tile,
                            FragmentCounts& counts);
  void (*draw_large_behind)(const LargeTriangle& triangle, const BehindTest& test,
                            Reference reference, TileBuffer& tile, FragmentCounts& counts);
  // For a blended draw: into the picture, which must already have the colours of what was drawn
  // before.
  void (*draw_small_blended)(const SmallJob& job, const BlendJob& blend,
                             const std::uint32_t* triangles, std::size_t count, TileBuffer& tile,
                             FragmentCounts& counts);
  void (*draw_large_blended)(const LargeTriangle& triangle, const BlendJob& blend,
                             Reference reference, TileBuffer& tile, FragmentCounts& counts);
  // `tiles`: one for each of job.points, or a single one for pixel centres.
  void (*resolve_tile)(const ResolveJob& job, std::span<TileBuffer> tiles);
};

// `target` is one of available_targets().
const Kernels& kernels(Target target);

}  // namespace glassbox
