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
  if (job.points.empty() && TwoChannels::have_all_of(job)) {
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
                       .draw_small_masked = draw_small_masked,
                       .draw_large_masked = draw_large_masked,
                       .draw_small_behind = draw_small_behind,
                       .draw_large_behind = draw_large_behind,
                       .draw_small_blended = draw_small_blended,
                       .draw_large_blended = draw_large_blended,
                       .resolve_tile = resolve_tile};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();
