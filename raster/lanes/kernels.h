// The stages over lanes, compiled for each instruction set: what the tile engine calls.
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
  // Writes to `selected`, which has room for job.count + kMostLanes, and returns how many there are.
  std::size_t (*select_triangles)(const SelectJob& job, const BinColumns& selected,
                                  SelectCounts& counts);
  // Into each of `tiles`, which are of the same part of the screen: a pixel's samples.
  void (*draw_small)(const SmallJob& job, const std::uint32_t* triangles, std::size_t count,
                     std::span<TileBuffer> tiles, FragmentCounts& counts);
  void (*draw_large)(const TriangleSetup& setup, Reference reference, TileBuffer& tile,
                     FragmentCounts& counts);
  // The same of a draw whose alpha is tested.
  void (*draw_small_masked)(const SmallJob& job, const AlphaTest& test,
                            const std::uint32_t* triangles, std::size_t count, TileBuffer& tile,
                            FragmentCounts& counts);
  void (*draw_large_masked)(const LargeTriangle& triangle, const AlphaTest& test,
                            Reference reference, TileBuffer& tile, FragmentCounts& counts);
  // Of one that is opaque or tested, behind what is given. The tile's points are centres.
  void (*draw_small_behind)(const SmallJob& job, const BehindTest& test,
                            const std::uint32_t* triangles, std::size_t count, TileBuffer& tile,
                            FragmentCounts& counts);
  void (*draw_large_behind)(const LargeTriangle& triangle, const BehindTest& test,
                            Reference reference, TileBuffer& tile, FragmentCounts& counts);
  // Of a draw that is blended: into the picture, where the colours of what was drawn before have to be.
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
