#include "tests/raster/lanes/probes.h"

#include <algorithm>
#include <bit>

#include <glassbox/raster/lanes/compiled_targets.h>

// This file is compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/raster/lanes/probes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <glassbox/raster/lanes/depth-inl.h>
#include <glassbox/raster/lanes/samples-inl.h>
#include <glassbox/raster/lanes/texture-inl.h>
#include <glassbox/raster/lanes/transfer-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {
namespace probes {

// The entries from `i` on, one for each lane; the last entry is repeated where there are no more.
template <class T>
T entry(std::span<const T> from, std::size_t i) {
  return from[std::min(i, from.size() - 1)];
}
template <class T>
HWY_INLINE auto load(std::span<const T> from, std::size_t i) {
  HWY_ALIGN T lanes[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) lanes[k] = entry(from, i + k);
  return HWY_NAMESPACE::load(lanes);
}
template <class V, class T>
HWY_INLINE void store(V v, T* to, std::size_t i, std::size_t size) {
  HWY_ALIGN T lanes[kLanes];
  HWY_NAMESPACE::store(v, lanes);
  for (std::size_t k = 0; k < kLanes && i + k < size; ++k) to[i + k] = lanes[k];
}

inline void snap_all(std::span<const float> pixels, std::int32_t* subpixels) {
  for (std::size_t i = 0; i < pixels.size(); i += kLanes) {
    store(snap(load(pixels, i)), subpixels, i, pixels.size());
  }
}

inline void encode_all(Transfer transfer, std::span<const float> linear, std::int32_t* bytes) {
  for (std::size_t i = 0; i < linear.size(); i += kLanes) {
    store(encode(transfer, load(linear, i)), bytes, i, linear.size());
  }
}

inline void decode_all(Transfer transfer, std::span<const std::int32_t> bytes, float* linear) {
  for (std::size_t i = 0; i < bytes.size(); i += kLanes) {
    store(decode(transfer, load(bytes, i)), linear, i, bytes.size());
  }
}

inline void depth_code_all(DepthFormat format, std::span<const float> depths, std::int32_t* codes) {
  with_code(format, [&](const auto& code_of) HWY_ATTR {
    for (std::size_t i = 0; i < depths.size(); i += kLanes) {
      store(code_of(load(depths, i)), codes, i, depths.size());
    }
  });
}

HWY_INLINE std::array<Floats, 3> load_triple(std::span<const std::array<float, 3>> from,
                                             std::size_t i) {
  HWY_ALIGN float c[3][kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) c[axis][k] = entry(from, i + k)[axis];
  }
  return {hn::LoadU(kF, c[0]), hn::LoadU(kF, c[1]), hn::LoadU(kF, c[2])};
}
HWY_INLINE void store_components(const std::array<Floats, 3>& v, float (&to)[3][kLanes]) {
  for (std::size_t axis = 0; axis < 3; ++axis) hn::StoreU(v[axis].v, kF, to[axis]);
}

inline void sample_all(const MipChain& texture, const Sampler& sampler,
                       std::span<const TexCoord> at, std::span<const float> levels, Rgba* colors) {
  const TextureInLanes<AllChannels> texels(texture, AllChannels());
  for (std::size_t i = 0; i < at.size(); i += kLanes) {
    HWY_ALIGN float u[kLanes], v[kLanes];
    for (std::size_t k = 0; k < kLanes; ++k) u[k] = entry(at, i + k).u, v[k] = entry(at, i + k).v;
    const std::array<Floats, 2> texcoord{HWY_NAMESPACE::load(u), HWY_NAMESPACE::load(v)};
    const Int16x4 sampled = samples_base_only(sampler)
                                ? sample_base(texels, sampler, texcoord)
                                : sample_texture(texels, sampler, texcoord, load(levels, i));
    float channels[3][kLanes], alpha[kLanes];
    store_components(color_of(sampled), channels);
    hn::StoreU(alpha_of(sampled).v, kF, alpha);
    for (std::size_t k = 0; k < kLanes && i + k < at.size(); ++k) {
      colors[i + k] = {channels[0][k], channels[1][k], channels[2][k], alpha[k]};
    }
  }
}

inline void mean_color_all(Transfer transfer, std::span<const Rgba8> samples, std::size_t count,
                           Rgba8* means) {
  const std::size_t pixels = samples.size() / count;
  for (std::size_t i = 0; i < pixels; i += kLanes) {
    SampleColors colors;
    for (std::size_t s = 0; s < count; ++s) {
      for (std::size_t k = 0; k < kLanes; ++k) {
        const std::size_t pixel = std::min(i + k, pixels - 1);
        colors.at(s)[k] = std::bit_cast<std::int32_t>(samples[pixel * count + s]);
      }
    }
    HWY_ALIGN std::int32_t mean[kLanes];
    store(HWY_NAMESPACE::mean_color(transfer, colors, count, 0), mean);
    for (std::size_t k = 0; k < kLanes && i + k < pixels; ++k) {
      means[i + k] = std::bit_cast<Rgba8>(mean[k]);
    }
  }
}

inline void level_of_detail_all(int width, int height, std::span<const TextureGradient> gradients,
                                float* levels) {
  for (std::size_t i = 0; i < gradients.size(); i += kLanes) {
    HWY_ALIGN float c[4][kLanes];
    for (std::size_t k = 0; k < kLanes; ++k) {
      const TextureGradient& g = entry(gradients, i + k);
      c[0][k] = g.along_x[0], c[1][k] = g.along_x[1];
      c[2][k] = g.along_y[0], c[3][k] = g.along_y[1];
    }
    const TextureGradientOf<Floats> gradient{{hn::LoadU(kF, c[0]), hn::LoadU(kF, c[1])},
                                             {hn::LoadU(kF, c[2]), hn::LoadU(kF, c[3])}};
    store(level_of_detail(gradient, width, height), levels, i, gradients.size());
  }
}

inline void illuminate_all(const Lighting& lighting, int shininess, bool highlights,
                           std::span<const std::array<float, 3>> positions,
                           std::span<const std::array<float, 3>> normals, Reflection* reflections) {
  for (std::size_t i = 0; i < positions.size(); i += kLanes) {
    const ReflectionOf<Floats> light = reflected_light(
        lighting, load_triple(positions, i), load_triple(normals, i), shininess, highlights);
    float diffuse[3][kLanes], specular[3][kLanes];
    store_components(light.diffuse, diffuse);
    store_components(light.specular, specular);
    for (std::size_t k = 0; k < kLanes && i + k < positions.size(); ++k) {
      reflections[i + k] = {{diffuse[0][k], diffuse[1][k], diffuse[2][k]},
                            {specular[0][k], specular[1][k], specular[2][k]}};
    }
  }
}

const test::LaneProbes kProbes{snap_all,   encode_all,     decode_all,          depth_code_all,
                               sample_all, mean_color_all, level_of_detail_all, illuminate_all};

}  // namespace probes
}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glassbox::test {

const LaneProbes& lane_probes(Target target) {
  switch (target) {
#if (HWY_TARGETS & HWY_AVX3) != 0
    case Target::kAvx512:
      return N_AVX3::probes::kProbes;
#endif
#if (HWY_TARGETS & HWY_AVX2) != 0
    case Target::kAvx2:
      return N_AVX2::probes::kProbes;
#endif
#if (HWY_TARGETS & HWY_SSE4) != 0
    case Target::kSse4:
      return N_SSE4::probes::kProbes;
#endif
#if (HWY_TARGETS & HWY_NEON) != 0
    case Target::kNeon:
      return N_NEON::probes::kProbes;
#endif
    default:
#if (HWY_TARGETS & HWY_EMU128) != 0
      return N_EMU128::probes::kProbes;
#else
      return N_SCALAR::probes::kProbes;
#endif
  }
}

}  // namespace glassbox::test

#endif
