#include "views/voxels/kernels.h"

#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "views/voxels/kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::views::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kMaxLanes>;
using Ints = hn::RebindToSigned<Floats>;

template <bool kSpread>
HWY_INLINE void sum_lanes(const RowPicture* pictures, int picture_count, int first, int at,
                          float most_deviations, const RowSums& out) {
  const Floats d;
  const Ints i;
  const auto none = hn::Zero(d);
  const auto place = hn::ConvertTo(d, hn::Iota(i, first + at));
  const auto channel = hn::Set(i, 1023);
  auto count = hn::Zero(i), a = hn::Zero(i), b = hn::Zero(i), c = hn::Zero(i);
  auto squares = hn::Zero(i), spread = hn::Zero(i), least = hn::Set(i, 0x7fffffff);
  auto background = hn::MaskFromVec(hn::Zero(i)), bad = background;
  for (int p = 0; p < picture_count; ++p) {
    const RowPicture& picture = pictures[p];
    const auto w = hn::Add(hn::Set(d, picture.w), hn::Mul(place, hn::Set(d, picture.dw)));
    const auto inverse = hn::Div(hn::Set(d, 1.0f), w);
    const auto u =
        hn::Mul(hn::Add(hn::Set(d, picture.x), hn::Mul(place, hn::Set(d, picture.dx))), inverse);
    const auto v =
        hn::Mul(hn::Add(hn::Set(d, picture.y), hn::Mul(place, hn::Set(d, picture.dy))), inverse);
    const auto inside =
        hn::And(hn::And(hn::And(hn::Ge(u, none), hn::Lt(u, hn::Set(d, picture.width))),
                        hn::And(hn::Ge(v, none), hn::Lt(v, hn::Set(d, picture.height)))),
                hn::Gt(w, none));
    const auto column = hn::ConvertTo(i, hn::IfThenElseZero(inside, u));
    const auto row = hn::ConvertTo(i, hn::IfThenElseZero(inside, v));
    const auto pixel = hn::Add(hn::Mul(row, hn::Set(i, picture.stride)), column);
    const auto word = hn::GatherIndex(i, picture.words, pixel);
    const auto is_inside = hn::RebindMask(i, inside);
    const auto is_dead = hn::Or(background, bad);
    const auto is_beside = hn::AndNot(is_inside, hn::Lt(hn::Set(i, picture.beside), hn::Zero(i)));
    const auto is_background =
        hn::Or(is_beside, hn::And(is_inside, hn::TestBit(word, hn::Set(i, std::int32_t(1) << 30))));
    background = hn::Or(background, hn::AndNot(is_dead, is_background));
    const auto is_open = hn::AndNot(hn::Or(is_background, hn::Lt(word, hn::Zero(i))), is_inside);
    const auto open = hn::IfThenElseZero(is_open, word);
    count = hn::Sub(count, hn::VecFromMask(i, is_open));
    const auto one = hn::And(open, channel), two = hn::And(hn::ShiftRight<10>(open), channel);
    const auto three = hn::And(hn::ShiftRight<20>(open), channel);
    a = hn::Add(a, one);
    b = hn::Add(b, two);
    c = hn::Add(c, three);
    squares = hn::Add(
        squares, hn::Add(hn::Add(hn::Mul(one, one), hn::Mul(two, two)), hn::Mul(three, three)));
    if (kSpread) {
      const auto here = hn::GatherIndex(i, picture.spread, pixel);
      spread = hn::Add(spread, hn::IfThenElseZero(is_open, here));
      least = hn::IfThenElse(is_open, hn::Min(least, here), least);
    }
    if (picture.is_trial) {
      const auto k = hn::ConvertTo(d, count), fa = hn::ConvertTo(d, a), fb = hn::ConvertTo(d, b),
                 fc = hn::ConvertTo(d, c);
      const auto of_means = hn::Add(hn::Add(hn::Mul(fa, fa), hn::Mul(fb, fb)), hn::Mul(fc, fc));
      const auto all = hn::Mul(hn::Mul(k, hn::ConvertTo(d, squares)), hn::Set(d, kShareKept));
      const auto beyond = hn::Gt(hn::Sub(all, of_means), hn::Mul(k, hn::Set(d, most_deviations)));
      bad = hn::Or(bad, hn::AndNot(background, hn::RebindMask(i, beyond)));
    }
    if (hn::AllTrue(i, hn::Or(background, bad))) break;
  }
  count = hn::IfThenElse(background, hn::Set(i, kIsBackground), count);
  count = hn::IfThenElse(bad, hn::Set(i, kIsInconsistent), count);
  hn::StoreU(count, i, out.count + at);
  hn::StoreU(a, i, out.a + at);
  hn::StoreU(b, i, out.b + at);
  hn::StoreU(c, i, out.c + at);
  hn::StoreU(squares, i, out.squares + at);
  if (kSpread) {
    hn::StoreU(spread, i, out.spread + at);
    hn::StoreU(least, i, out.least_spread + at);
  }
}

template <bool kSpread>
void sum_all(const RowPicture* pictures, int picture_count, int first, int count,
             float most_deviations, const RowSums& out) {
  const int lanes = int(hn::Lanes(Floats()));
  for (int at = 0; at < count; at += lanes) {
    sum_lanes<kSpread>(pictures, picture_count, first, at, most_deviations, out);
  }
}

void sum_row(const RowPicture* pictures, int picture_count, int first, int count,
             float most_deviations, const RowSums& out) {
  if (picture_count > 0 && pictures[0].spread != nullptr) {
    sum_all<true>(pictures, picture_count, first, count, most_deviations, out);
  } else {
    sum_all<false>(pictures, picture_count, first, count, most_deviations, out);
  }
}

const VoxelKernels kKernels{sum_row};

}  // namespace glassbox::views::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glassbox::views {

const VoxelKernels& voxel_kernels(Target target) {
#include <glassbox/raster/lanes/kernels_of_target-inl.h>
}

}  // namespace glassbox::views

#endif
