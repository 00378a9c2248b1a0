#include "views/layers/eye_kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "views/layers/eye_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::views::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using EyeF = hn::CappedTag<float, 16>;
using EyeI = hn::RebindToSigned<EyeF>;
using EyeU = hn::RebindToUnsigned<EyeF>;
constexpr int kMaxEyeLanes = 16;

// Two neighbouring pixels belong to one surface if the warp changes the distance of their centres,
// 1 px, by less than half a pixel.
constexpr float kMinStep = 0.5f, kMaxStep = 1.5f;
// px; on a steep surface, the centres of neighbouring pixels may be this far apart.
constexpr float kSteepStep = 4;

constexpr std::uint32_t kFields = 0x00ff00ff, kHalves = 0x00800080;

HWY_INLINE std::uint32_t mixed(std::uint32_t a, std::uint32_t b, std::uint32_t of_b) {
  const std::uint32_t of_a = 256 - of_b;
  const std::uint32_t even = (a & kFields) * of_a + (b & kFields) * of_b + kHalves;
  const std::uint32_t odd = (a >> 8 & kFields) * of_a + (b >> 8 & kFields) * of_b + kHalves;
  return (even >> 8 & kFields) | (odd & ~kFields);
}

// Computes the nearness from depth codes.
class Nearness {
public:
  explicit Nearness(const EyeShift& shift)
      : format_(shift.format),
        offset_(shift.offset),
        slope_(format_ == DepthFormat::kUnorm24 || format_ == DepthFormat::kUnorm16
                   ? shift.slope / float(unorm_depth_steps(format_))
                   : shift.slope) {}

  template <class Codes>
  HWY_INLINE auto of(Codes codes) const {
    const EyeF f;
    const EyeU u;
    const auto linear = hn::Add(hn::Set(f, offset_), hn::Mul(hn::Set(f, slope_), depth_of(codes)));
    const auto empty = hn::RebindMask(f, hn::Eq(codes, hn::Set(u, kEmptyDepth)));
    return hn::IfThenElse(empty, hn::Zero(f), hn::Max(linear, hn::Zero(f)));
  }

private:
  template <class Codes>
  HWY_INLINE hn::Vec<EyeF> depth_of(Codes codes) const {
    const EyeF f;
    const EyeI d;
    const EyeU u;
    constexpr std::uint32_t kOne = 0x3f800000;  // the bits of the float 1
    if (format_ == DepthFormat::kFloat32) return hn::BitCast(f, codes);
    if (format_ == DepthFormat::kFloat32Reversed)
      return hn::BitCast(f, hn::Sub(hn::Set(u, kOne), codes));
    return hn::ConvertTo(f, hn::BitCast(d, codes));
  }

  DepthFormat format_;
  float offset_, slope_;
};

// One row that is being warped. The centre of pixel i moves to place[i].
struct RowWarp {
  const float* place;
  const float* nearness;
  const Rgba8* color;
  int width;
  bool is_first;
  EyeTarget to;

  std::uint32_t color_of(int i) const { return std::bit_cast<std::uint32_t>(color[i]); }
  bool is_there(int i) const { return is_first || nearness[i] > 0; }
  // Whether neither pixel i nor pixel i + 1 is empty. (Empty pixels of the first layer show the
  // background, which is a surface.)
  bool both_there(int i) const { return i >= 0 && i + 1 < width && is_there(i) && is_there(i + 1); }
  float step(int i) const { return place[i + 1] - place[i]; }
  // Whether pixels i and i + 1 belong to one surface: either they stay close together, or they move
  // apart as much as the pair of pixels beside them does, as on a steep surface.
  bool joined(int i) const {
    if (!both_there(i)) return false;
    const float own = step(i);
    if (own > kMinStep && own < kMaxStep) return true;
    if (!(own > kMinStep && own < kSteepStep)) return false;
    const auto as_steep = [&](int k) {
      return both_there(k) && std::abs(step(k) - own) * 4 <= own;
    };
    return as_steep(i - 1) || as_steep(i + 1);
  }
  void put(float x, int from, std::uint32_t shown) const {
    if (!(x >= 0) || !(x < float(width))) return;
    const std::uint32_t near = std::bit_cast<std::uint32_t>(nearness[from]) + 1;
    const auto at = int(x);
    if (near <= to.nearness[at]) return;
    to.nearness[at] = near;
    to.color[at] = shown;
  }
  // Draws pixel i. On one surface, a pixel between two warped centres gets a mixture of both
  // colours. At the edge of a surface, the pixel that contains the last warped centre gets its
  // colour.
  void warp_pixel(int i) const {
    if (!is_there(i)) return;
    const float at = place[i];
    const float nearest = std::floor(at);
    if (!joined(i - 1) && nearest + 0.5f < at) put(nearest, i, color_of(i));
    if (!joined(i)) {
      if (nearest + 0.5f >= at) put(nearest, i, color_of(i));
      return;
    }
    warp_mixed_pixels(i, std::ceil(at - 0.5f));
  }
  // Puts mixtures of pixels i and i + 1 into the pixels from x on whose centres are before the
  // warped centre of pixel i + 1.
  void warp_mixed_pixels(int i, float x) const {
    const float at = place[i], next = place[i + 1];
    for (; x + 0.5f < next; x += 1) {
      const float share = (x + 0.5f - at) / (next - at);
      const auto of_next = std::uint32_t(int(share * 256 + 0.5f));
      put(x, i, mixed(color_of(i), color_of(i + 1), of_next));
    }
  }
};

// Gives the background's colour to those of the pixels [begin, end) that are still holes.
void fill_empty(const EyeTarget& target, int begin, int end, std::uint32_t color) {
  const EyeU u;
  const int lanes = int(hn::Lanes(u));
  for (; begin + lanes <= end; begin += lanes) {
    const auto there = hn::LoadU(u, target.nearness + begin);
    const auto is_hole = hn::Eq(there, hn::Zero(u));
    hn::StoreU(hn::IfThenElse(is_hole, hn::Set(u, 1), there), u, target.nearness + begin);
    hn::StoreU(hn::IfThenElse(is_hole, hn::Set(u, color), hn::LoadU(u, target.color + begin)), u,
               target.color + begin);
  }
  for (; begin < end; ++begin) {
    if (target.nearness[begin] != 0) continue;
    target.nearness[begin] = 1;
    target.color[begin] = color;
  }
}

void warp_row(const EyeShift& shift, const EyeRow& row, float* HWY_RESTRICT scratch,
              const EyeTarget& target) {
  const EyeF f;
  const EyeI d;
  const EyeU u;
  const int lanes = int(hn::Lanes(f));
  float* const place = scratch;
  float* const nearness = scratch + row.width + 64;
  const Nearness nearness_of(shift);
  const auto half = hn::Set(f, 0.5f), one = hn::Set(f, 1.0f), zero = hn::Zero(f);
  const auto* const colors = reinterpret_cast<const std::uint32_t*>(row.color);
  const auto is_empty = [&](int from) HWY_ATTR {
    return hn::Eq(hn::LoadU(u, row.depth + from), hn::Set(u, kEmptyDepth));
  };
  // Whether all pixels of the vector that begins at `from` are empty and, in the first layer, have
  // the colour of pixel `like`. (Empty pixels may have any colour: transparent surfaces store no
  // depth, and neither does an edge that covers some samples of a pixel but not its centre.)
  const auto is_plain = [&](int from, int like) HWY_ATTR {
    if (!row.is_first) return hn::AllTrue(u, is_empty(from));
    const auto same = hn::Eq(hn::LoadU(u, colors + from), hn::Set(u, colors[like]));
    return hn::AllTrue(u, hn::And(is_empty(from), same));
  };
  // Computes the warped places and the nearnesses of the pixels from `begin` to `end`, and of the
  // rest of the last vector.
  const auto fill_places = [&](int begin, int end) HWY_ATTR {
    for (int i = begin; i < end; i += lanes) {
      HWY_ALIGN std::uint32_t rest[kMaxEyeLanes] = {};
      const std::uint32_t* from = row.depth + i;
      if (i + lanes > row.width) {
        std::copy(from, row.depth + row.width, rest);
        from = rest;
      }
      const auto near = nearness_of.of(hn::LoadU(u, from));
      const auto moved =
          hn::Sub(hn::Set(f, shift.at_infinity), hn::Mul(hn::Set(f, shift.by_nearness), near));
      hn::StoreU(near, f, nearness + i);
      hn::StoreU(hn::Add(hn::Add(hn::Iota(f, float(i)), half), moved), f, place + i);
    }
  };
  // Inside a run of plain pixels the warped places are needed only near its ends: the loop below
  // reads at most a vector and two neighbours beyond the end of a surface.
  const int reach = 3 + lanes;
  for (int begin = 0; begin < row.width;) {
    int run = begin;
    while (run + lanes <= row.width && is_plain(run, begin)) run += lanes;
    if (run - begin > 2 * reach) {
      fill_places(begin, begin + reach);
      begin = run - reach;
    }
    const int end = std::max(run, begin + lanes);
    fill_places(begin, end);
    begin = begin + (end - begin + lanes - 1) / lanes * lanes;
  }

  const RowWarp row_warp{place, nearness, row.color, row.width, row.is_first, target};
  row_warp.warp_pixel(0);
  int i = 1;
  const auto least = hn::Set(f, kMinStep), most = hn::Set(f, kMaxStep);
  HWY_ALIGN std::int32_t to[kMaxEyeLanes];
  HWY_ALIGN std::uint32_t color[kMaxEyeLanes];
  HWY_ALIGN std::uint32_t depth[kMaxEyeLanes];
  for (; i + lanes < row.width; i += lanes) {
    if (hn::AllTrue(u, is_empty(i - 1)) && is_plain(i, i) && is_plain(i + 1, i)) {
      // A run of empty pixels, or of background of one colour, is also a run in the other picture,
      // so that its pixels need not be warped one by one.
      const int first = i;
      while (i + 2 * lanes < row.width && is_plain(i + lanes + 1, first)) i += lanes;
      if (row.is_first) {
        const auto pixel_after = [&](int k) {
          const float at = float(k) + 0.5f + shift.at_infinity;
          return int(std::min(std::max(std::ceil(at - 0.5f), 0.0f), float(row.width)));
        };
        fill_empty(target, pixel_after(first), pixel_after(i + lanes), colors[first]);
      }
      continue;
    }
    const auto before = hn::LoadU(f, place + i - 1), at = hn::LoadU(f, place + i),
               next = hn::LoadU(f, place + i + 1), near = hn::LoadU(f, nearness + i);
    const auto step = hn::Sub(next, at), step_before = hn::Sub(at, before);
    const auto x = hn::Ceil(hn::Sub(at, half)), center = hn::Add(x, half);
    auto plain = hn::And(hn::And(hn::Gt(step, least), hn::Lt(step, most)),
                         hn::And(hn::Gt(step_before, least), hn::Lt(step_before, most)));
    if (!row.is_first) {
      plain =
          hn::And(plain, hn::And(hn::Gt(near, zero), hn::Gt(hn::LoadU(f, nearness + i + 1), zero)));
      plain = hn::And(plain, hn::Gt(hn::LoadU(f, nearness + i - 1), zero));
    }
    if (!hn::AllTrue(f, plain)) {
      for (int k = 0; k < lanes; ++k) row_warp.warp_pixel(i + k);
      continue;
    }
    const auto shows = hn::Lt(center, next);
    // If neighbours moved apart, a second centre may be between them. (No two pairs of neighbours
    // on one surface cover the same centre, so their order does not matter.)
    const auto again = hn::Lt(hn::Add(center, one), next);
    if (!hn::AllFalse(f, again)) {
      for (int k = i; k < i + lanes; ++k)
        row_warp.warp_mixed_pixels(k, std::ceil(place[k] - 0.5f) + 1);
    }
    const auto inside =
        hn::And(hn::And(hn::Ge(x, zero), hn::Lt(x, hn::Set(f, float(row.width)))), shows);
    const auto share = hn::Div(hn::Sub(center, at), step);
    const auto of_next =
        hn::BitCast(u, hn::ConvertTo(d, hn::Add(hn::Mul(share, hn::Set(f, 256.0f)), half)));
    const auto of_own = hn::Sub(hn::Set(u, 256), of_next);
    const auto fields = hn::Set(u, kFields), halves = hn::Set(u, kHalves);
    const auto a = hn::LoadU(u, colors + i), b = hn::LoadU(u, colors + i + 1);
    // Mixes two channels at once, each in a field of 16 bits: the largest value is 255 * 256 + 128.
    const auto mix = [&](auto of_a, auto of_b) {
      return hn::Add(hn::Add(hn::Mul(of_a, of_own), hn::Mul(of_b, of_next)), halves);
    };
    const auto even = mix(hn::And(a, fields), hn::And(b, fields));
    const auto odd =
        mix(hn::And(hn::ShiftRight<8>(a), fields), hn::And(hn::ShiftRight<8>(b), fields));
    const auto shown = hn::Or(hn::And(hn::ShiftRight<8>(even), fields), hn::AndNot(fields, odd));
    const auto how_near = hn::Add(hn::BitCast(u, near), hn::Set(u, 1));
    // On most surfaces neighbours remain neighbours, so that they can be stored as one vector.
    const float first = hn::GetLane(x);
    const auto in_line = hn::Eq(x, hn::Add(hn::Set(f, first), hn::Iota(f, 0.0f)));
    if (hn::AllTrue(f, hn::And(in_line, inside))) {
      const int column = int(first);
      const auto there = hn::LoadU(u, target.nearness + column);
      const auto wins = hn::Gt(how_near, there);
      hn::StoreU(hn::IfThenElse(wins, how_near, there), u, target.nearness + column);
      hn::StoreU(hn::IfThenElse(wins, shown, hn::LoadU(u, target.color + column)), u,
                 target.color + column);
      continue;
    }
    hn::Store(shown, u, color);
    hn::Store(how_near, u, depth);
    hn::Store(hn::ConvertTo(d, hn::IfThenElse(inside, x, hn::Set(f, float(row.width)))), d, to);
    for (int k = 0; k < lanes; ++k) {
      if (depth[k] <= target.nearness[to[k]]) continue;
      target.nearness[to[k]] = depth[k];
      target.color[to[k]] = color[k];
    }
  }
  for (; i < row.width; ++i) row_warp.warp_pixel(i);
}

int fill(const EyeTarget& row, int width) {
  const EyeU u;
  const int lanes = int(hn::Lanes(u));
  int holes = 0;
  for (int x = 0; x < width; ++x) {
    if (x + lanes <= width && hn::AllTrue(u, hn::Gt(hn::LoadU(u, row.nearness + x), hn::Zero(u)))) {
      x += lanes - 1;
      continue;
    }
    if (row.nearness[x] != 0) continue;
    int end = x;
    while (end < width && row.nearness[end] == 0) ++end;
    holes += end - x;
    const bool from_right = x == 0 || (end < width && row.nearness[end] < row.nearness[x - 1]);
    // If nothing was warped to the whole row, use pixel 0, which the caller has set.
    const int from = holes == width ? 0 : from_right ? end : x - 1;
    if (from < width) {
      std::fill(row.color + x, row.color + end, row.color[from]);
      std::fill(row.nearness + x, row.nearness + end, row.nearness[from]);
    }
    x = end;
  }
  return holes;
}

const EyeKernels kKernels{warp_row, fill};

}  // namespace glassbox::views::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glassbox::views {

const EyeKernels& eye_kernels(Target target) {
#include <glassbox/raster/lanes/kernels_of_target-inl.h>
}

}  // namespace glassbox::views

#endif  // HWY_ONCE
