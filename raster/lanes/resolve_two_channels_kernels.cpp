#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve_two_channels_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <glassbox/raster/lanes/kernel_functions-inl.h>
#include <glassbox/raster/lanes/resolve-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

void resolve_two_channels(const ResolveJob& job, std::span<TileBuffer> tiles) {
  TileResolver<TwoChannels>(job, tiles).resolve();
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();
