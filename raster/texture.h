// Textures: mip chains, and samples from them.
#pragma once

#include <array>
#include <atomic>
#include <mutex>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/raster/stages.h>
#include <glassbox/raster/transfer.h>

namespace glassbox {

// One level of a texture: its size, and the number of its first texel in the chain.
template <class I>
struct TextureLevelOf {
  I width, height, first;
};

// Linear light and alpha as integers; kFullTexel means 1.
struct Texel {
  std::int16_t r = 0, g = 0, b = 0, a = 0;
  friend bool operator==(const Texel&, const Texel&) = default;
};
// 128 * 255, so that a byte which is stored linearly (alpha always is) becomes exactly 128 times
// itself.
inline constexpr int kFullTexel = 32640;

// Convert a texel to linear light, and to bytes. Texels of level 0 give the image's own bytes.
Rgba light_of(const Texel& texel);
Rgba8 stored_texel(const Texel& texel, Transfer transfer);

// An image and its repeated halvings down to one texel: level k has max(1, size >> k) texels on
// each side. Fewer than 2^28 texels in all: the largest images that are loaded have 2^26, and a
// chain has at most twice as many.
struct MipChain {
  int width = 0, height = 0;        // of level 0
  std::vector<std::int32_t> first;  // for each level, the number of its first texel
  std::vector<Texel> texels;        // level by level, row by row from the top

  int last_level() const { return int(first.size()) - 1; }
};

// Makes the mip chain. The texels of level 0 are within 1/2 of the image's linear light in units of
// 1/kFullTexel; the texels of every other level are the means of the texels that they cover in the
// level before, rounded to nearest. With `first_level_only` the chain has only level 0, for
// samplers that never use other levels.
MipChain make_mip_chain(const Image<Rgba8>& image, Transfer transfer, bool first_level_only);

// The mip chain of an image, made when it is first needed, so that textures that are not seen cost
// nothing. The image must not move.
class LazyMipChain {
public:
  LazyMipChain(const Image<Rgba8>& image, Transfer transfer, bool first_level_only)
      : image_(image), transfer_(transfer), first_level_only_(first_level_only) {}

  // May be called by any thread; other threads wait for the thread that makes the chain.
  const MipChain& get() const {
    const MipChain* made = made_.load(std::memory_order_acquire);
    if (made == nullptr) [[unlikely]]
      return make();
    return *made;
  }
  bool made() const { return made_ != nullptr; }

private:
  const MipChain& make() const;

  const Image<Rgba8>& image_;
  Transfer transfer_;
  bool first_level_only_;
  mutable std::once_flag once_;
  mutable MipChain chain_;
  mutable std::atomic<const MipChain*> made_ = nullptr;  // &chain_ once it has been made
};

// How fast texture coordinates change from pixel to pixel: the derivatives of (u, v) along screen x
// and y, per pixel.
template <class F>
struct TextureGradientOf {
  std::array<F, 2> along_x{};
  std::array<F, 2> along_y{};
};
using TextureGradient = TextureGradientOf<float>;

// The plane equations of 1/w, u/w and v/w over the screen, from which the exact derivatives at a
// pixel can be computed (Heckbert and Moreton 1991). Texture coordinates are taken relative to
// vertex 0, so large coordinates lose no digits (C-67).
template <class F>
struct TexturePlanesOf {
  std::array<F, 2> origin{};                 // texcoord of vertex 0
  std::array<std::array<F, 2>, 2> over_w{};  // [axis][u, v]: d((u - u0)/w)
  std::array<F, 2> inverse_w{};              // [axis]: d(1/w)
};
using TexturePlanes = TexturePlanesOf<float>;

TexturePlanes texture_planes(const TriangleSetup& triangle,
                             const std::array<std::array<float, 2>, 3>& texcoords);

TextureGradient texture_gradient(const TexturePlanes& planes, const std::array<float, 2>& texcoord,
                                 float inverse_w);

// log2 of the longer side of a pixel's footprint, in texels of level 0; at most 0 where the texture
// is magnified.
float level_of_detail(const TextureGradient& gradient, int width, int height);

// Whether every sample comes from the base level by one filter, for any level of detail.
inline bool samples_base_only(const Sampler& sampler) {
  return sampler.mip == MipFilter::kNone && sampler.magnify == sampler.minify;
}

// Returns one filtered sample, in linear light. Coordinates are wrapped before they are scaled. Any
// coordinate is legal; a coordinate that is not finite is treated as 0. Filtering is done in
// integers (raster/formulas/texture.h): the result differs by at most 4.5/kFullTexel from the
// texels' mean with exact weights, and if only one texel is used, it is exactly that texel.
Rgba sample_mip_chain(const MipChain& texture, const Sampler& sampler,
                      const std::array<float, 2>& texcoord, float level_of_detail);

}  // namespace glassbox
