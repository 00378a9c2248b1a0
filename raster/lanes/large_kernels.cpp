#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "large_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <glassbox/raster/lanes/kernel_functions-inl.h>
#include <glassbox/raster/lanes/large_triangles-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

void draw_large(const TriangleSetup& setup, Reference reference, TileBuffer& tile,
                FragmentCounts& counts) {
  draw_large(setup, nullptr, reference, Opaque(), tile, counts);
}
void draw_large(const LargeTriangle& triangle, const AlphaTest& test, Reference reference,
                TileBuffer& tile, FragmentCounts& counts) {
  const LargeShape shape(triangle);
  draw_large(triangle.setup, &shape, reference, Masked(test), tile, counts);
}
void draw_large(const LargeTriangle& triangle, const BehindTest& test, Reference reference,
                TileBuffer& tile, FragmentCounts& counts) {
  const LargeShape shape(triangle);
  draw_large(triangle.setup, &shape, reference, Behind(test), tile, counts);
}
void draw_large(const LargeTriangle& triangle, const BlendJob& blend, Reference reference,
                TileBuffer& tile, FragmentCounts& counts) {
  const LargeShape shape(triangle);
  const bool colors_alone =
      blend.colors != nullptr && blend.resolve->distance == nullptr && blend.resolve->id == nullptr;
  BlendTable bytes;
  const Blended blended(blend, triangle.one_color && colors_alone ? &bytes : nullptr);
  draw_large(triangle.setup, &shape, reference, blended, tile, counts);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();
