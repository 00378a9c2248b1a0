#include "views/layers/warp_kernels.h"

#include <algorithm>
#include <bit>

#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "views/layers/warp_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::views::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;
using Floats = hn::Vec<F>;
constexpr int kMaxLanes = 16;

// Screen positions of samples i .. i + lanes - 1, after the division by w.
struct ScreenPoints {
  Floats x, y, z, inverse_w;
  hn::Mask<F> before;  // in front of the eye, and inside the block
};

HWY_INLINE Floats along(float start, float right, float depth_step, Floats steps, Floats depth) {
  const F f;
  const auto at = hn::Add(hn::Set(f, start), hn::Mul(steps, hn::Set(f, right)));
  return hn::Add(at, hn::Mul(depth, hn::Set(f, depth_step)));
}

HWY_INLINE ScreenPoints screen_points(const WarpBlock& block, int i) {
  const F f;
  const I d;
  const hn::Rebind<std::uint16_t, I> shorts;
  const auto column = hn::PromoteTo(d, hn::LoadU(shorts, block.column + i));
  const auto steps = hn::ConvertTo(f, hn::Sub(column, hn::Set(d, block.anchor)));
  const auto depth = hn::LoadU(f, block.depth + i);
  const WarpedPoint &start = block.start, &right = block.right, &deep = block.depth_step;
  const auto w = along(start.w, right.w, deep.w, steps, depth);
  const auto inverse = hn::Div(hn::Set(f, 1.0f), w);
  return {hn::Mul(along(start.x, right.x, deep.x, steps, depth), inverse),
          hn::Mul(along(start.y, right.y, deep.y, steps, depth), inverse),
          hn::Mul(along(start.z, right.z, deep.z, steps, depth), inverse), inverse,
          hn::And(hn::Gt(w, hn::Zero(f)), hn::FirstN(f, std::size_t(block.count - i)))};
}

// Whether a sample may be visible: nothing is between the eye and the near plane (depth above 1),
// or beyond the far plane (depth 0 and below).
HWY_INLINE hn::Mask<F> is_in_depth(Floats z) {
  const F f;
  return hn::And(hn::Gt(z, hn::Zero(f)), hn::Le(z, hn::Set(f, kNearestDepth)));
}

HWY_INLINE void count(const WarpBlock& block, int i, hn::Mask<F> before, hn::Mask<F> drawn,
                      BlockCounts& counts) {
  const F f;
  const auto here = std::uint64_t(std::min(int(hn::Lanes(f)), block.count - i));
  const std::uint64_t in_front = hn::CountTrue(f, before);
  counts.behind += here - in_front;
  counts.outside += in_front - hn::CountTrue(f, drawn);
}

void points(const WarpBlock& block, int margin, const KeyCanvas& canvas, BlockCounts& counts) {
  const F f;
  const I d;
  const int lanes = int(hn::Lanes(f));
  const auto least = hn::Set(f, float(-margin));
  const auto past_x = hn::Set(f, float(canvas.width + margin)),
             past_y = hn::Set(f, float(canvas.height + margin));
  const auto stride = hn::Set(d, canvas.stride()), origin = hn::Set(d, canvas.stride() + 1);
  // Samples that are not drawn are written here, which avoids a branch.
  const auto discarded = hn::Set(d, canvas.discard_index());
  HWY_ALIGN std::int32_t place[kMaxLanes];
  HWY_ALIGN std::uint32_t depth[kMaxLanes];
  for (int i = 0; i < block.count; i += lanes) {
    const ScreenPoints at = screen_points(block, i);
    const auto column = hn::Floor(at.x), row = hn::Floor(at.y);
    const auto in_x = hn::And(hn::Ge(column, least), hn::Lt(column, past_x)),
               in_y = hn::And(hn::Ge(row, least), hn::Lt(row, past_y));
    const auto drawn = hn::And(hn::And(in_x, in_y), hn::And(at.before, is_in_depth(at.z)));
    count(block, i, at.before, drawn, counts);
    const auto x = hn::ConvertTo(d, hn::IfThenElseZero(drawn, column)),
               y = hn::ConvertTo(d, hn::IfThenElseZero(drawn, row));
    const auto pixel_place = hn::Add(hn::Mul(y, stride), hn::Add(x, origin));
    hn::Store(hn::IfThenElse(hn::RebindMask(d, drawn), pixel_place, discarded), d, place);
    hn::Store(hn::BitCast(U(), hn::IfThenElseZero(drawn, at.z)), U(), depth);
    const int here = std::min(lanes, block.count - i);
    for (int k = 0; k < here; ++k) {
      SampleKey& pixel = canvas.keys[place[k]];
      const SampleKey key = SampleKey(depth[k]) << 32 | block.color[i + k];
      pixel = key > pixel ? key : pixel;
    }
  }
}

void boxes(const WarpBlock& block, const SplatSides& sides, int width, int height,
           const SampleBoxes& to, BlockCounts& counts) {
  const F f;
  const I d;
  const hn::Rebind<std::uint8_t, I> bytes;
  const int lanes = int(hn::Lanes(f));
  const auto half_pixel = hn::Set(f, 0.5f), zero = hn::Zero(f);
  const auto past_x = hn::Set(f, float(width)), past_y = hn::Set(f, float(height));
  for (int i = 0; i < block.count; i += lanes) {
    const ScreenPoints at = screen_points(block, i);
    // What one pixel's step along the sample's surface in the first picture becomes in the second
    // picture. There, the position is X / W (homogeneous coordinates), whose derivative is (X' - X
    // / W * W') / W.
    const auto slope_x = hn::LoadU(f, block.slope_x + i), slope_y = hn::LoadU(f, block.slope_y + i);
    const WarpedPoint &right_step = block.right, &down_step = sides.down, &deep = block.depth_step;
    const auto gain = [&](float step, Floats slope, float by_depth) {
      return hn::Add(hn::Set(f, step), hn::Mul(slope, hn::Set(f, by_depth)));
    };
    const auto w_right = gain(right_step.w, slope_x, deep.w),
               w_down = gain(down_step.w, slope_y, deep.w);
    const auto length = [&](Floats place, Floats along_right, Floats along_down) {
      const auto u = hn::Sub(along_right, hn::Mul(place, w_right)),
                 v = hn::Sub(along_down, hn::Mul(place, w_down));
      const auto sum = hn::Mul(hn::Add(hn::Abs(u), hn::Abs(v)), at.inverse_w);
      return hn::Mul(hn::Set(f, sides.factor), sum);
    };
    const auto wide = length(at.x, gain(right_step.x, slope_x, deep.x),
                             gain(down_step.x, slope_y, deep.x)),
               high = length(at.y, gain(right_step.y, slope_x, deep.y),
                             gain(down_step.y, slope_y, deep.y));
    const auto asked = hn::Max(wide, high);
    const auto half_of = [&](Floats side) {
      const auto clamped = hn::Min(hn::Max(side, hn::Set(f, sides.least)), hn::Set(f, sides.most));
      return hn::Mul(clamped, half_pixel);
    };
    const auto half_x = half_of(wide), half_y = half_of(high);
    const auto left = hn::Floor(hn::Add(hn::Sub(at.x, half_x), half_pixel)),
               top = hn::Floor(hn::Add(hn::Sub(at.y, half_y), half_pixel)),
               right = hn::Floor(hn::Add(hn::Add(at.x, half_x), half_pixel)),
               bottom = hn::Floor(hn::Add(hn::Add(at.y, half_y), half_pixel));
    const auto in_x = hn::And(hn::Lt(left, past_x), hn::Gt(right, zero)),
               in_y = hn::And(hn::Lt(top, past_y), hn::Gt(bottom, zero));
    const auto drawn = hn::And(hn::And(in_x, in_y), hn::And(at.before, is_in_depth(at.z)));
    count(block, i, at.before, drawn, counts);
    counts.oversized +=
        hn::CountTrue(f, hn::And(at.before, hn::Gt(asked, hn::Set(f, sides.oversized_above))));
    const auto pixels = [&](Floats edge, Floats past) {
      return hn::ConvertTo(d, hn::IfThenElseZero(drawn, hn::Min(hn::Max(edge, zero), past)));
    };
    hn::StoreU(pixels(left, past_x), d, to.left + i);
    hn::StoreU(pixels(top, past_y), d, to.top + i);
    hn::StoreU(pixels(right, past_x), d, to.right + i);
    hn::StoreU(pixels(bottom, past_y), d, to.bottom + i);
    hn::StoreU(hn::BitCast(U(), hn::IfThenElseZero(drawn, at.z)), U(), to.depth + i);
    const auto nearest = hn::Floor(hn::Add(hn::Min(asked, hn::Set(f, 255.0f)), half_pixel));
    hn::StoreU(hn::DemoteTo(bytes, hn::ConvertTo(d, hn::IfThenElseZero(drawn, nearest))), bytes,
               to.side + i);
  }
}

using K = hn::ScalableTag<std::int64_t>;

// Keys are below 2^62, because the bits of a float below 2 are a number below 2^30. So a comparison
// as signed numbers gives the same order.
HWY_INLINE hn::Vec<K> greater(hn::Vec<K> a, hn::Vec<K> b) {
  return hn::Max(a, b);
}

void finish_row(std::span<const SampleKey* const> rows, bool widened, int width,
                std::uint32_t background, SampleKey* HWY_RESTRICT scratch,
                Rgba8* HWY_RESTRICT color, float* HWY_RESTRICT depth) {
  const K d;
  const int lanes = int(hn::Lanes(d));
  const auto load = [&](const SampleKey* at) {
    return hn::LoadU(d, reinterpret_cast<const std::int64_t*>(at));
  };
  const SampleKey* row = rows[0];
  if (rows.size() > 1) {
    int x = 0;
    for (; x + lanes <= width + 2; x += lanes) {
      auto most = load(rows[0] + x);
      for (std::size_t i = 1; i < rows.size(); ++i) most = greater(most, load(rows[i] + x));
      hn::StoreU(most, d, reinterpret_cast<std::int64_t*>(scratch + x));
    }
    for (; x < width + 2; ++x) {
      SampleKey most = rows[0][x];
      for (std::size_t i = 1; i < rows.size(); ++i) most = std::max(most, rows[i][x]);
      scratch[x] = most;
    }
    row = scratch;
  }
  const auto show = [&](int x, SampleKey key) {
    const auto shown = std::uint32_t(key == 0 ? background : key);
    const auto bits = std::uint32_t(key >> 32);
    color[x] = std::bit_cast<Rgba8>(shown);
    depth[x] = std::bit_cast<float>(bits);
  };
  if (!widened) {
    for (int x = 0; x < width; ++x) show(x, row[x + 1]);
    return;
  }
  for (int x = 0; x < width; ++x) show(x, std::max(std::max(row[x], row[x + 1]), row[x + 2]));
}

const WarpKernels kKernels{points, boxes, finish_row};

}  // namespace glassbox::views::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glassbox::views {

const WarpKernels& warp_kernels(Target target) {
#include <glassbox/raster/lanes/kernels_of_target-inl.h>
}

}  // namespace glassbox::views

#endif  // HWY_ONCE
