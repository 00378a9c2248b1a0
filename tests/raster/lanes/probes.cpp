#include "tests/raster/lanes/probes.h"

#include <algorithm>

#include <glassbox/raster/lanes/compiled_targets.h>

// This file is compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/raster/lanes/probes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <glassbox/raster/lanes/depth-inl.h>
#include <glassbox/raster/lanes/lighting-inl.h>
#include <glassbox/raster/lanes/texture-inl.h>
#include <glassbox/raster/lanes/transfer-inl.h>
#include <glassbox/raster/lanes/vertices-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {
namespace probes {

// Entries from `i` on, one a lane; the last one again where there are no more.
template <class T>
T entry(std::span<const T> from, std::size_t i) {
  return from[std::min(i, from.size() - 1)];
}
template <class D, class T>
HWY_INLINE hn::Vec<D> load(D d, std::span<const T> from, std::size_t i) {
  HWY_ALIGN T lanes[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) lanes[k] = entry(from, i + k);
  return hn::Load(d, lanes);
}
template <class V, class T>
HWY_INLINE void store(V v, T* to, std::size_t i, std::size_t size) {
  const hn::DFromV<V> d;
  HWY_ALIGN hn::TFromD<decltype(d)> lanes[kLanes];
  hn::Store(v, d, lanes);
  for (std::size_t k = 0; k < kLanes && i + k < size; ++k) to[i + k] = lanes[k];
}

inline void snap_all(std::span<const float> pixels, std::int32_t* subpixels) {
  for (std::size_t i = 0; i < pixels.size(); i += kLanes) {
    store(snap(load(kF, pixels, i)), subpixels, i, pixels.size());
  }
}

inline void encode_all(Transfer transfer, std::span<const float> linear, std::int32_t* bytes) {
  for (std::size_t i = 0; i < linear.size(); i += kLanes) {
    store(encode(transfer, load(kF, linear, i)), bytes, i, linear.size());
  }
}

inline void decode_all(Transfer transfer, std::span<const std::int32_t> bytes, float* linear) {
  for (std::size_t i = 0; i < bytes.size(); i += kLanes) {
    store(decode(transfer, load(kI, bytes, i)), linear, i, bytes.size());
  }
}

inline void depth_code_all(DepthFormat format, std::span<const float> depths, std::int32_t* codes) {
  with_code(format, [&](const auto& code_of) HWY_ATTR {
    for (std::size_t i = 0; i < depths.size(); i += kLanes) {
      store(code_of(load(kF, depths, i)), codes, i, depths.size());
    }
  });
}

inline void sample_all(const MipChain& texture, const Sampler& sampler, Transfer transfer,
                       std::span<const TexCoord> at, Rgba* colors) {
  for (std::size_t i = 0; i < at.size(); i += kLanes) {
    HWY_ALIGN float u[kLanes], v[kLanes], r[kLanes], g[kLanes], b[kLanes];
    for (std::size_t k = 0; k < kLanes; ++k) u[k] = entry(at, i + k).u, v[k] = entry(at, i + k).v;
    const RgbLanes rgb = sample_base(texture, sampler, hn::Load(kF, u), hn::Load(kF, v), transfer);
    hn::Store(rgb.r, kF, r);
    hn::Store(rgb.g, kF, g);
    hn::Store(rgb.b, kF, b);
    for (std::size_t k = 0; k < kLanes && i + k < at.size(); ++k) {
      colors[i + k] = {r[k], g[k], b[k], 0};
    }
  }
}

using Float3 = std::array<float, 3>;

HWY_INLINE Vec3 load_vec3(std::span<const Float3> from, std::size_t i) {
  HWY_ALIGN float c[3][kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) c[axis][k] = entry(from, i + k)[axis];
  }
  return {hn::Load(kF, c[0]), hn::Load(kF, c[1]), hn::Load(kF, c[2])};
}
HWY_INLINE void store_vec3(const Vec3& v, float (&to)[3][kLanes]) {
  hn::StoreU(v.x, kF, to[0]);
  hn::StoreU(v.y, kF, to[1]);
  hn::StoreU(v.z, kF, to[2]);
}

inline void illuminate_all(const Lighting& lighting, int shininess, bool highlights,
                           std::span<const Float3> positions, std::span<const Float3> normals,
                           Reflection* reflections) {
  for (std::size_t i = 0; i < positions.size(); i += kLanes) {
    const ReflectionLanes light =
        illuminate(lighting, load_vec3(positions, i), load_vec3(normals, i), shininess, highlights);
    float diffuse[3][kLanes], specular[3][kLanes];
    store_vec3(light.diffuse, diffuse);
    store_vec3(light.specular, specular);
    for (std::size_t k = 0; k < kLanes && i + k < positions.size(); ++k) {
      reflections[i + k] = {{diffuse[0][k], diffuse[1][k], diffuse[2][k]},
                            {specular[0][k], specular[1][k], specular[2][k]}};
    }
  }
}

const test::LaneProbes kProbes{snap_all,       encode_all, decode_all,
                               depth_code_all, sample_all, illuminate_all};

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
