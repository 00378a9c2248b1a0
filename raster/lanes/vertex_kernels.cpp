// Transforms many vertices at once: positions from object space to the snapped screen, normals and
// positions to eye space.

#include <cstring>
#include <limits>

#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vertex_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <glassbox/raster/lanes/formulas-inl.h>
#include <glassbox/raster/lanes/kernel_functions-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

using Float3 = std::array<Floats, 3>;

// Loads three floats of each of `count` <= kLanes records; the remaining lanes are zero.
HWY_INLINE Float3 load_triples(const float* from, std::size_t count) {
  Float3 p;
  if (count == kLanes) {
    hn::LoadInterleaved3(kF, from, p[0].v, p[1].v, p[2].v);
    return p;
  }
  HWY_ALIGN float padded[3 * kLanes] = {};
  for (std::size_t i = 0; i < 3 * count; ++i) padded[i] = from[i];
  hn::LoadInterleaved3(kF, padded, p[0].v, p[1].v, p[2].v);
  return p;
}
HWY_INLINE void store_triples(const Float3& p, float* to, std::size_t count) {
  if (count == kLanes) {
    hn::StoreInterleaved3(p[0].v, p[1].v, p[2].v, kF, to);
    return;
  }
  HWY_ALIGN float padded[3 * kLanes];
  hn::StoreInterleaved3(p[0].v, p[1].v, p[2].v, kF, padded);
  for (std::size_t i = 0; i < 3 * count; ++i) to[i] = padded[i];
}

// Calls work(i, count) for consecutive runs of at most kLanes of `size` entries.
template <class Work>
HWY_INLINE void in_lanes(std::size_t size, const Work& work) {
  std::size_t i = 0;
  for (; i + kLanes <= size; i += kLanes) work(i, kLanes);
  if (i < size) work(i, size - i);
}

template <class Matrix>
HWY_INLINE Floats transform_row(const Matrix& m, int row, const Float3& p) {
  return transform_row(m, row, p[0], p[1], p[2]);
}

HWY_INLINE Float3 broadcast(const Vector<Object>& v) {
  return {Floats(v.x), Floats(v.y), Floats(v.z)};
}

// ---- to the screen ----

struct ClipFloats {
  Floats x, y, z, w;
};

// Whether p is inside every plane that rendering clips by, with a margin for the guard band. The
// result is false for NaN and infinity. This function tests all planes except the two of the guard
// band that limit x.
HWY_INLINE FloatMask surely_inside_but_for_x(const VertexJob& job, const ClipFloats& p) {
  const FloatMask depth = p.z >= 0.0f && p.z <= p.w * job.far_factor;
  const FloatMask eye = p.w >= job.smallest_w && p.w <= std::numeric_limits<float>::max() / 4;
  return depth && eye && abs(p.y) <= p.w * job.band_y;
}
HWY_INLINE FloatMask surely_inside_in_x(const VertexJob& job, Floats x, Floats w) {
  return abs(x) <= w * job.band_x;
}

// Stores entries of the screen's table for `count` <= kLanes vertices.
HWY_INLINE void store_entries(Ints x, Ints y, Floats z, Floats inverse_w, SnappedEntry* entries,
                              std::size_t count) {
  auto* to = reinterpret_cast<float*>(&entries->x);
  if (count == kLanes) {
    hn::StoreInterleaved4(float_of(x).v, float_of(y).v, z.v, inverse_w.v, kF, to);
    return;
  }
  HWY_ALIGN float padded[4 * kLanes];
  hn::StoreInterleaved4(float_of(x).v, float_of(y).v, z.v, inverse_w.v, kF, padded);
  std::memcpy(to, padded, count * sizeof(SnappedEntry));
}

template <bool kTestPlanes, bool kDivide>
HWY_INLINE void transform_vertices_with(const VertexJob& job) {
  const Viewport port = job.viewport;  // a copy, so that it is not reloaded after each store
  const Float3 anchor = broadcast(job.anchor);
  in_lanes(job.positions.size(), [&](std::size_t i, std::size_t count) HWY_ATTR {
    const Float3 p = difference(load_triples(&job.positions[i].x, count), anchor);
    const ClipFloats clip{transform_row(job.clip_from_anchored, 0, p),
                          transform_row(job.clip_from_anchored, 1, p),
                          transform_row(job.clip_from_anchored, 2, p),
                          kDivide ? transform_row(job.clip_from_anchored, 3, p) : Floats(1.0f)};
    FloatMask inside;
    if constexpr (kTestPlanes) inside = surely_inside_but_for_x(job, clip);
    // Positions that are not inside are not used; dividing by 1 avoids invalid operations.
    Floats w = clip.w;
    if constexpr (kTestPlanes) w = select(inside, clip.w, 1.0f);
    const auto over_w = [&](Floats v) HWY_ATTR { return kDivide ? v / w : v; };
    Floats y = over_w(clip.y);
    if constexpr (kTestPlanes) y = select(inside, y, 0.0f);
    const Ints screen_y = snap(to_pixels(y, port.bottom, port.top));
    const Floats z = over_w(clip.z), inverse_w = over_w(1.0f);
    const auto snapped_x = [&](Floats x)
                               HWY_ATTR { return snap(to_pixels(x, port.left, port.right)); };
    const auto store_for_eye = [&](Floats clip_x, SnappedEntry* screen) HWY_ATTR {
      Ints screen_x;
      if constexpr (kTestPlanes) {
        const FloatMask seen = inside && surely_inside_in_x(job, clip_x, clip.w);
        screen_x =
            select(int_mask(seen), snapped_x(select(seen, over_w(clip_x), 0.0f)), kNeedsClipping);
      } else {
        screen_x = snapped_x(over_w(clip_x));
      }
      store_entries(screen_x, screen_y, z, inverse_w, screen + i, count);
    };
    store_for_eye(clip.x, job.screen);
    if (job.other_screen != nullptr) {
      store_for_eye(transform_row(*job.other_clip_from_anchored, 0, p), job.other_screen);
    }
  });
}

void transform_vertices(const VertexJob& job) {
  if (job.test_planes) {
    job.divide ? transform_vertices_with<true, true>(job)
               : transform_vertices_with<true, false>(job);
  } else {
    job.divide ? transform_vertices_with<false, true>(job)
               : transform_vertices_with<false, false>(job);
  }
}

// ---- to eye space ----

void transform_normals(const NormalJob& job) {
  const auto& m = job.eye_from_object;
  in_lanes(job.normals.size(), [&](std::size_t i, std::size_t count) HWY_ATTR {
    const Float3 n = load_triples(&job.normals[i].x, count);
    const Float3 eye{transform_normal_row(m, 0, n), transform_normal_row(m, 1, n),
                     transform_normal_row(m, 2, n)};
    store_triples(unit_normal(eye), &job.eye[i].x, count);
  });
}

void transform_positions(const EyePositionJob& job) {
  const Float3 anchor = broadcast(job.anchor);
  in_lanes(job.positions.size(), [&](std::size_t i, std::size_t count) HWY_ATTR {
    const Float3 p = difference(load_triples(&job.positions[i].x, count), anchor);
    store_triples(
        {transform_row(job.eye_from_anchored, 0, p), transform_row(job.eye_from_anchored, 1, p),
         transform_row(job.eye_from_anchored, 2, p)},
        &job.eye[i].x, count);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();
