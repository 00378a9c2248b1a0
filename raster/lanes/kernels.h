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

// The indices, in a SmallJob's tables, of the triangles to draw.
using TriangleNumbers = std::span<const std::uint32_t>;

// The kernels that draw small and large triangles if not all fragments are kept, or if they are
// blended. `Test` says what becomes of a fragment that passes the depth test.
template <class Test>
struct DrawKernels {
  void (*small)(const SmallJob& job, const Test& test, TriangleNumbers triangles, TileBuffer& tile,
                FragmentCounts& counts);
  void (*large)(const LargeTriangle& triangle, const Test& test, Reference reference,
                TileBuffer& tile, FragmentCounts& counts);
};

struct Kernels {
  void (*transform_vertices)(const VertexJob& job);
  void (*transform_normals)(const NormalJob& job);
  void (*transform_positions)(const EyePositionJob& job);
  // Writes the selected triangles to `selected`, which has room for job.count + kMaxLanes, and
  // returns their number.
  std::size_t (*select_triangles)(const SelectJob& job, const BinColumns& selected,
                                  SelectCounts& counts);
  // For an opaque draw. draw_small draws into each of `tiles`, which cover the same part of the
  // screen: one for each sample of a pixel.
  void (*draw_small)(const SmallJob& job, TriangleNumbers triangles, std::span<TileBuffer> tiles,
                     FragmentCounts& counts);
  void (*draw_large)(const TriangleSetup& setup, Reference reference, TileBuffer& tile,
                     FragmentCounts& counts);
  // For a draw whose alpha is tested.
  DrawKernels<AlphaTest> masked;
  // For an opaque or alpha-tested draw of which only the fragments behind given depths are drawn.
  // The tile's sample points are pixel centres.
  DrawKernels<BehindTest> behind;
  // For a blended draw. It changes the picture, which must already have the colours of everything
  // drawn before.
  DrawKernels<BlendJob> blended;
  // `tiles`: one for each of job.points, or a single one for pixel centres.
  void (*resolve_tile)(const ResolveJob& job, std::span<TileBuffer> tiles);
};

// `target` is one of available_targets().
const Kernels& kernels(Target target);

}  // namespace glassbox
