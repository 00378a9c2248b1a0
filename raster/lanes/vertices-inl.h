// Many vertices at a time: object space to the snapped screen, normals and positions to eye space.

#if defined(GLASSBOX_VERTICES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_VERTICES_INL_H_
#undef GLASSBOX_VERTICES_INL_H_
#else
#define GLASSBOX_VERTICES_INL_H_
#endif

#include <cstring>
#include <limits>

#include <glassbox/raster/lanes/lanes-inl.h>
#include <glassbox/raster/lanes/tables.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Three floats of each of `count` <= kLanes records; the lanes beyond are zero.
HWY_INLINE Vec3 load_triples(const float* from, std::size_t count) {
  Vec3 v;
  if (count == kLanes) {
    hn::LoadInterleaved3(kF, from, v.x, v.y, v.z);
    return v;
  }
  HWY_ALIGN float padded[3 * kLanes] = {};
  for (std::size_t i = 0; i < 3 * count; ++i) padded[i] = from[i];
  hn::LoadInterleaved3(kF, padded, v.x, v.y, v.z);
  return v;
}
HWY_INLINE void store_triples(const Vec3& v, float* to, std::size_t count) {
  if (count == kLanes) {
    hn::StoreInterleaved3(v.x, v.y, v.z, kF, to);
    return;
  }
  HWY_ALIGN float padded[3 * kLanes];
  hn::StoreInterleaved3(v.x, v.y, v.z, kF, padded);
  for (std::size_t i = 0; i < 3 * count; ++i) to[i] = padded[i];
}

// Calls work(i, count) for runs of at most kLanes of `size` entries.
template <class Work>
HWY_INLINE void in_lanes(std::size_t size, const Work& work) {
  std::size_t i = 0;
  for (; i + kLanes <= size; i += kLanes) work(i, kLanes);
  if (i < size) work(i, size - i);
}

// As transform_row of base/spaces.h.
template <class Target, class Source>
HWY_INLINE VF transform_row(const Transform<Target, Source, float>& m, int row, const Vec3& p) {
  return hn::Add(hn::Add(hn::Add(hn::Mul(set(m.at(row, 0)), p.x), hn::Mul(set(m.at(row, 1)), p.y)),
                         hn::Mul(set(m.at(row, 2)), p.z)),
                 set(m.at(row, 3)));
}

// As snap() of snap.h, for positions in its range.
HWY_INLINE VI snap(VF pixels) {
  const VF subpixels = hn::Mul(pixels, set(float(kSubpixels)));
  const VF below = hn::Floor(subpixels);
  const MF up = hn::Ge(hn::Sub(subpixels, below), set(0.5f));
  // A mask is -1 where it holds.
  return hn::Sub(hn::ConvertTo(kI, below), hn::VecFromMask(kI, as_int_mask(up)));
}

struct FourLanes {
  VF x, y, z, w;
};

// Inside of every plane that rendering clips by, with room to spare for the guard band. NaN and infinity are not. First all but
// the planes of x.
HWY_INLINE MF surely_inside_but_for_x(const VertexJob& job, const FourLanes& p) {
  const MF depth =
      hn::And(hn::Ge(p.z, hn::Zero(kF)), hn::Le(p.z, hn::Mul(p.w, set(job.far_factor))));
  const MF eye = hn::And(hn::Ge(p.w, set(job.smallest_w)),
                         hn::Le(p.w, set(std::numeric_limits<float>::max() / 4)));
  return hn::And(hn::And(depth, eye), hn::Le(hn::Abs(p.y), hn::Mul(p.w, set(job.band_y))));
}
HWY_INLINE MF surely_inside_in_x(const VertexJob& job, VF x, VF w) {
  return hn::Le(hn::Abs(x), hn::Mul(w, set(job.band_x)));
}

// Four words for each of `count` <= kLanes entries.
HWY_INLINE void store_entries(const FourLanes& v, std::int32_t* to, std::size_t count) {
  if (count == kLanes) {
    hn::StoreInterleaved4(v.x, v.y, v.z, v.w, kF, reinterpret_cast<float*>(to));
    return;
  }
  HWY_ALIGN float padded[4 * kLanes];
  hn::StoreInterleaved4(v.x, v.y, v.z, v.w, kF, padded);
  std::memcpy(to, padded, count * sizeof(SnappedEntry));
}

template <bool kTestPlanes, bool kDivide>
HWY_INLINE void transform_vertices_with(const VertexJob& job) {
  const Viewport& port = job.viewport;
  const VF scale_x = set((port.right - port.left) * 0.5f);
  const VF middle_x = set((port.right + port.left) * 0.5f);
  const VF scale_y = set((port.top - port.bottom) * 0.5f);
  const VF middle_y = set((port.top + port.bottom) * 0.5f);
  const Vec3 anchor{set(job.anchor.x), set(job.anchor.y), set(job.anchor.z)};
  in_lanes(job.positions.size(), [&](std::size_t i, std::size_t count) HWY_ATTR {
    const Vec3 p = subtract(load_triples(&job.positions[i].x, count), anchor);
    const FourLanes clip{transform_row(job.clip_from_anchored, 0, p),
                         transform_row(job.clip_from_anchored, 1, p),
                         transform_row(job.clip_from_anchored, 2, p),
                         kDivide ? transform_row(job.clip_from_anchored, 3, p) : set(1.0f)};
    MF inside;
    if constexpr (kTestPlanes) inside = surely_inside_but_for_x(job, clip);
    // The others' positions are not used; dividing by 1 keeps them from trouble.
    VF w = clip.w;
    if constexpr (kTestPlanes) w = hn::IfThenElse(inside, clip.w, set(1.0f));
    const auto over_w = [&](VF v) HWY_ATTR { return kDivide ? hn::Div(v, w) : v; };
    VF y = over_w(clip.y);
    if constexpr (kTestPlanes) y = hn::IfThenElseZero(inside, y);
    const VI screen_y = snap(hn::Add(hn::Mul(y, scale_y), middle_y));
    const VF z = over_w(clip.z), inverse_w = over_w(set(1.0f));
    const auto snapped_x = [&](VF x)
                               HWY_ATTR { return snap(hn::Add(hn::Mul(x, scale_x), middle_x)); };
    const auto store_for_eye = [&](VF clip_x, SnappedEntry* screen) HWY_ATTR {
      VI screen_x;
      if constexpr (kTestPlanes) {
        const MF seen = hn::And(inside, surely_inside_in_x(job, clip_x, clip.w));
        screen_x =
            hn::IfThenElse(as_int_mask(seen), snapped_x(hn::IfThenElseZero(seen, over_w(clip_x))),
                           set(kNeedsClipping));
      } else {
        screen_x = snapped_x(over_w(clip_x));
      }
      store_entries({hn::BitCast(kF, screen_x), hn::BitCast(kF, screen_y), z, inverse_w},
                    &screen[i].x, count);
    };
    store_for_eye(clip.x, job.screen);
    if (job.other_screen != nullptr) {
      store_for_eye(transform_row(*job.other_clip_from_anchored, 0, p), job.other_screen);
    }
  });
}

inline void transform_vertices(const VertexJob& job) {
  if (job.test_planes) {
    job.divide ? transform_vertices_with<true, true>(job)
               : transform_vertices_with<true, false>(job);
  } else {
    job.divide ? transform_vertices_with<false, true>(job)
               : transform_vertices_with<false, false>(job);
  }
}

// ---- eye space ----

// As normalized() of normal_transform.h.
HWY_INLINE Vec3 normalized_in_double(const Vec3& n) {
  const Doubles x = promote(n.x), y = promote(n.y), z = promote(n.z);
  const Doubles divisor = each_half(
      [](VD dx, VD dy, VD dz) HWY_ATTR {
        const VD length =
            hn::Sqrt(hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz)));
        return hn::IfThenElse(hn::Gt(length, hn::Zero(kD)), length, hn::Set(kD, 1.0));
      },
      x, y, z);
  const auto over = [](VD a, VD b) HWY_ATTR { return hn::Div(a, b); };
  return {round_to_float(each_half(over, x, divisor)), round_to_float(each_half(over, y, divisor)),
          round_to_float(each_half(over, z, divisor))};
}

inline void transform_normals(const NormalJob& job) {
  const auto row = [&](int r, const Vec3& n) HWY_ATTR {
    const auto& m = job.eye_from_object;
    return hn::Add(hn::Add(hn::Mul(set(m.at(r, 0)), n.x), hn::Mul(set(m.at(r, 1)), n.y)),
                   hn::Mul(set(m.at(r, 2)), n.z));
  };
  in_lanes(job.normals.size(), [&](std::size_t i, std::size_t count) HWY_ATTR {
    const Vec3 n = load_triples(&job.normals[i].x, count);
    const Vec3 eye{row(0, n), row(1, n), row(2, n)};
    store_triples(normalized_in_double(eye), &job.eye[i].x, count);
  });
}

inline void transform_positions(const EyePositionJob& job) {
  const Vec3 anchor{set(job.anchor.x), set(job.anchor.y), set(job.anchor.z)};
  in_lanes(job.positions.size(), [&](std::size_t i, std::size_t count) HWY_ATTR {
    const Vec3 p = subtract(load_triples(&job.positions[i].x, count), anchor);
    store_triples(
        {transform_row(job.eye_from_anchored, 0, p), transform_row(job.eye_from_anchored, 1, p),
         transform_row(job.eye_from_anchored, 2, p)},
        &job.eye[i].x, count);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
