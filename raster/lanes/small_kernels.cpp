#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "small_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <glassbox/raster/lanes/kernel_functions-inl.h>
#include <glassbox/raster/lanes/small_triangles-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

void draw_small(const SmallJob& job, TriangleNumbers triangles, std::span<TileBuffer> tiles,
                FragmentCounts& counts) {
  draw_small(job, triangles, Opaque(), tiles, counts);
}
void draw_small(const SmallJob& job, const AlphaTest& test, TriangleNumbers triangles,
                TileBuffer& tile, FragmentCounts& counts) {
  draw_small(job, triangles, Masked(test), {&tile, 1}, counts);
}
void draw_small(const SmallJob& job, const BehindTest& test, TriangleNumbers triangles,
                TileBuffer& tile, FragmentCounts& counts) {
  draw_small(job, triangles, Behind(test), {&tile, 1}, counts);
}
void draw_small(const SmallJob& job, const BlendJob& blend, TriangleNumbers triangles,
                TileBuffer& tile, FragmentCounts& counts) {
  draw_small(job, triangles, Blended(blend), {&tile, 1}, counts);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();
