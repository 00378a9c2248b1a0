// Images on surfaces: mip chains, and samples from them.
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

// Linear light and alpha as whole numbers, kFullTexel for 1.
struct Texel {
  std::int16_t r = 0, g = 0, b = 0, a = 0;
  friend bool operator==(const Texel&, const Texel&) = default;
};
// 128 * 255: what is stored linearly, as alpha always is, becomes 128 times its byte, exactly.
inline constexpr int kFullTexel = 32640;

// In linear light, and as bytes: an image's own texels give its own bytes.
Rgba light_of(const Texel& texel);
Rgba8 stored_texel(const Texel& texel, Transfer transfer);

// An image and its halvings down to one texel: level k is max(1, size >> k) on each side. Fewer than 2^28 texels in all: the
// largest images that are loaded have 2^26, and a chain at most twice as many.
struct MipChain {
  int width = 0, height = 0;        // of level 0
  std::vector<std::int32_t> first;  // by level: the number of its first texel
  std::vector<Texel> texels;        // level by level, row by row from the top

  int last_level() const { return int(first.size()) - 1; }
};

// The image's texels within 1/2 of their linear light in units of 1/kFullTexel; those of a level are the means of the texels that
// they cover in the level before, rounded to nearest. The chain stops after the first level when the sampler never looks at the
// others.
MipChain make_mip_chain(const Image<Rgba8>& image, Transfer transfer, bool first_level_only);

// The chain of an image, which must stay where it is, made when somebody asks for it first: what is not seen costs nothing.
class LazyMipChain {
public:
  LazyMipChain(const Image<Rgba8>& image, Transfer transfer, bool first_level_only)
      : image_(image), transfer_(transfer), first_level_only_(first_level_only) {}

  // By any thread; the others wait for the one that makes it.
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
  mutable std::atomic<const MipChain*> made_ = nullptr;  // &chain_ once it is there
};

// How fast texture coordinates change from pixel to pixel: the derivatives of (u, v) along screen x and y, per pixel.
template <class F>
struct TextureGradientOf {
  std::array<F, 2> along_x{};
  std::array<F, 2> along_y{};
};
using TextureGradient = TextureGradientOf<float>;

// The plane equations of 1/w, u/w and v/w over the screen, from which the derivatives at a pixel follow analytically
// (Heckbert and Moreton 1991). Coordinates are taken relative to vertex 0, so large ones lose nothing (C-67).
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

// log2 of the longer side of a pixel's footprint, in texels of level 0; at most 0 where the texture is magnified.
float level_of_detail(const TextureGradient& gradient, int width, int height);

// The base level, by one filter, whatever the level of detail.
inline bool samples_base_only(const Sampler& sampler) {
  return sampler.mip == MipFilter::kNone && sampler.magnify == sampler.minify;
}

// One filtered sample, in linear light. Coordinates are wrapped before they are scaled. Anything finite or not is
// legal; a coordinate that is not finite counts as 0. Filtering is that of whole numbers (raster/formulas/texture.h): at most
// 4.5/kFullTexel from the mean of the texels by exact weights, and what one texel decides alone is that texel.
Rgba sample(const MipChain& texture, const Sampler& sampler, const std::array<float, 2>& texcoord,
            float level_of_detail);

}  // namespace glassbox
