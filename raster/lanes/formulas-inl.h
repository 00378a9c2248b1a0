// The formulas of the stages, compiled for vectors.

#if defined(GLASSBOX_FORMULAS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_FORMULAS_INL_H_
#undef GLASSBOX_FORMULAS_INL_H_
#else
#define GLASSBOX_FORMULAS_INL_H_
#endif

#include <glassbox/raster/lanes/doubles-inl.h>
#include <glassbox/raster/lanes/int16x4-inl.h>
#include <glassbox/raster/shading.h>
#include <glassbox/raster/stages.h>
#include <glassbox/raster/texture.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Compilers find these functions too large for the loop over the pixels and would call them; they
// must be inlined all the same.
template <Number F>
HWY_INLINE F wrap_coordinate(Wrap wrap, F t);
template <WholeNumber I, class Size>
HWY_INLINE I wrap_texel(Wrap wrap, I i, Size size);
template <WholeNumber I, class Size>
HWY_INLINE std::array<I, 2> wrap_neighbours(Wrap wrap, I i, Size size);
template <Number F, class Texture, class Size>
HWY_INLINE auto sample_nearest(const Texture& texture, const Sampler& sampler,
                               const TextureLevelOf<Size>& level, F u, F v);
template <Number F, class Texture, class Size>
HWY_INLINE auto sample_linear(const Texture& texture, const Sampler& sampler,
                              const TextureLevelOf<Size>& level, F u, F v);
template <Number F, class Texture, class Size>
HWY_INLINE auto sample_level(const Texture& texture, const Sampler& sampler, Filter filter,
                             const TextureLevelOf<Size>& level, F u, F v);
template <class Fragment>
HWY_INLINE bool is_texel_alone(const Fragment& at);
template <class Fragment>
HWY_INLINE auto surface_color(const Fragment& at);
template <class Fragment, class Normal>
HWY_INLINE auto light_at(const Fragment& at, const Normal& normal);
template <class Fragment, class Color>
HWY_INLINE Color lit_color(const Fragment& at, const Color& surface);
template <class Fragment>
HWY_INLINE auto emitted_light(const Fragment& at);
template <class Fragment, class Color>
HWY_INLINE Color shaded_color(const Fragment& at, const Color& surface);
// This function is not inlined: it is large, so the call itself costs little.
template <Number F, class Texture>
HWY_NOINLINE auto sample_texture(const Texture& texture, const Sampler& sampler,
                                 const std::array<F, 2>& texcoord, F level_of_detail);

#include <glassbox/base/formulas/common.h>
#include <glassbox/base/formulas/transform_row.h>
#include <glassbox/pipeline/formulas/vertex.h>
#include <glassbox/raster/formulas/blend.h>
#include <glassbox/raster/formulas/corners.h>
#include <glassbox/raster/formulas/depth.h>
#include <glassbox/raster/formulas/edges.h>
#include <glassbox/raster/formulas/interpolate.h>
#include <glassbox/raster/formulas/snap.h>
#include <glassbox/raster/formulas/surface.h>
#include <glassbox/raster/formulas/texture.h>

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
