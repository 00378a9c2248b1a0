// The functions behind Kernels, for one instruction set. They are compiled in six sources
// (*_kernels.cpp), several at once: together they take longer to compile than all the other code
// that is needed to draw a picture.

#if defined(GLASSBOX_KERNEL_FUNCTIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_KERNEL_FUNCTIONS_INL_H_
#undef GLASSBOX_KERNEL_FUNCTIONS_INL_H_
#else
#define GLASSBOX_KERNEL_FUNCTIONS_INL_H_
#endif

#include <glassbox/raster/lanes/kernels.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

void transform_vertices(const VertexJob& job);
void transform_normals(const NormalJob& job);
void transform_positions(const EyePositionJob& job);
std::size_t select_triangles(const SelectJob& job, const BinColumns& selected,
                             SelectCounts& counts);

void draw_small(const SmallJob& job, TriangleNumbers triangles, std::span<TileBuffer> tiles,
                FragmentCounts& counts);
void draw_large(const TriangleSetup& setup, Reference reference, TileBuffer& tile,
                FragmentCounts& counts);

// The functions in DrawKernels<Test>, for each kind of test.
void draw_small(const SmallJob& job, const AlphaTest& test, TriangleNumbers triangles,
                TileBuffer& tile, FragmentCounts& counts);
void draw_small(const SmallJob& job, const BehindTest& test, TriangleNumbers triangles,
                TileBuffer& tile, FragmentCounts& counts);
void draw_small(const SmallJob& job, const BlendJob& blend, TriangleNumbers triangles,
                TileBuffer& tile, FragmentCounts& counts);
void draw_large(const LargeTriangle& triangle, const AlphaTest& test, Reference reference,
                TileBuffer& tile, FragmentCounts& counts);
void draw_large(const LargeTriangle& triangle, const BehindTest& test, Reference reference,
                TileBuffer& tile, FragmentCounts& counts);
void draw_large(const LargeTriangle& triangle, const BlendJob& blend, Reference reference,
                TileBuffer& tile, FragmentCounts& counts);

// For an anaglyph's eye (two channels) only pixel centres are resolved.
void resolve_all_channels(const ResolveJob& job, std::span<TileBuffer> tiles);
void resolve_two_channels(const ResolveJob& job, std::span<TileBuffer> tiles);

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
