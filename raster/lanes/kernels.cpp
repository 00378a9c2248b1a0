#include <glassbox/raster/lanes/kernels.h>

#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <glassbox/raster/lanes/channels-inl.h>
#include <glassbox/raster/lanes/kernel_functions-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

void resolve_tile(const ResolveJob& job, std::span<TileBuffer> tiles) {
  if (job.points.empty() && TwoChannels::are_enough_for(job)) {
    resolve_two_channels(job, tiles);
  } else {
    resolve_all_channels(job, tiles);
  }
}

extern const Kernels kKernels;
const Kernels kKernels{.transform_vertices = transform_vertices,
                       .transform_normals = transform_normals,
                       .transform_positions = transform_positions,
                       .select_triangles = select_triangles,
                       .draw_small = draw_small,
                       .draw_large = draw_large,
                       .masked = {draw_small, draw_large},
                       .behind = {draw_small, draw_large},
                       .blended = {draw_small, draw_large},
                       .resolve_tile = resolve_tile};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();
