#include "study/experiments/kernels/reciprocal_kernels.h"

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "study/experiments/kernels/reciprocal_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace glassbox::study::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D, class V>
V newton(D d, V w, V x) {
  return hn::Mul(x, hn::Sub(hn::Set(d, 2.0f), hn::Mul(w, x)));
}

template <class D, class V>
V newton_root(D d, V w, V y) {
  const V half = hn::Mul(hn::Set(d, 0.5f), w);
  return hn::Mul(y, hn::Sub(hn::Set(d, 1.5f), hn::Mul(hn::Mul(half, y), y)));
}

template <class D, class V>
V magic(D d, V w) {
  const hn::RebindToUnsigned<D> bits;
  return hn::BitCast(d,
                     hn::Sub(hn::Set(bits, 0x5f3759dfu), hn::ShiftRight<1>(hn::BitCast(bits, w))));
}

template <Reciprocal kMethod, class D, class V>
V reciprocal(D d, V w) {
  const V one = hn::Set(d, 1.0f);
  if constexpr (kMethod == Reciprocal::kDivide) return hn::Div(one, w);
  if constexpr (kMethod == Reciprocal::kApproximate) return hn::ApproximateReciprocal(w);
  if constexpr (kMethod == Reciprocal::kNewton) return newton(d, w, hn::ApproximateReciprocal(w));
  if constexpr (kMethod == Reciprocal::kRootDivide) return hn::Div(one, hn::Sqrt(w));
  if constexpr (kMethod == Reciprocal::kRootApproximate) return hn::ApproximateReciprocalSqrt(w);
  if constexpr (kMethod == Reciprocal::kRootNewton)
    return newton_root(d, w, hn::ApproximateReciprocalSqrt(w));
  if constexpr (kMethod == Reciprocal::kMagic) return magic(d, w);
  if constexpr (kMethod == Reciprocal::kMagicNewton) return newton_root(d, w, magic(d, w));
}

template <Reciprocal kMethod>
void all_reciprocals(const float* w, float* out, std::size_t count) {
  const hn::ScalableTag<float> d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
    hn::StoreU(reciprocal<kMethod>(d, hn::LoadU(d, w + i)), d, out + i);
}

void choose_reciprocal(Reciprocal method, const float* w, float* out, std::size_t count) {
  using R = Reciprocal;
  switch (method) {
    case R::kDivide:
      return all_reciprocals<R::kDivide>(w, out, count);
    case R::kApproximate:
      return all_reciprocals<R::kApproximate>(w, out, count);
    case R::kNewton:
      return all_reciprocals<R::kNewton>(w, out, count);
    case R::kRootDivide:
      return all_reciprocals<R::kRootDivide>(w, out, count);
    case R::kRootApproximate:
      return all_reciprocals<R::kRootApproximate>(w, out, count);
    case R::kRootNewton:
      return all_reciprocals<R::kRootNewton>(w, out, count);
    case R::kMagic:
      return all_reciprocals<R::kMagic>(w, out, count);
    case R::kMagicNewton:
      return all_reciprocals<R::kMagicNewton>(w, out, count);
  }
}

// ---- perspective: 8 lanes at most, so that the shortest span has whole vectors ----

using Tag = hn::CappedTag<float, 8>;
using V = hn::Vec<Tag>;

void look_up(V u, const std::int32_t* texture, std::int32_t* out) {
  const hn::RebindToSigned<Tag> integers;
  const auto index = hn::ConvertTo(integers, u);
  const auto inside =
      hn::Max(hn::Zero(integers), hn::Min(index, hn::Set(integers, std::int32_t(kLinePixels - 1))));
  hn::StoreU(hn::GatherIndex(integers, texture, inside), integers, out);
}

template <Reciprocal kMethod>
void line_by_pixels(const PerspectiveLine& line, const std::int32_t* texture, std::int32_t* out) {
  const Tag d;
  const float q0 = line.inverse_w0, q1 = line.inverse_w1;
  const V p0 = hn::Set(d, line.u0 * q0), p1 = hn::Set(d, line.u1 * q1);
  const V centres = hn::Iota(d, 0.5f), share = hn::Set(d, 1.0f / float(line.pixels));
  for (int x = 0; x < line.pixels; x += int(hn::Lanes(d))) {
    const V far = hn::Mul(hn::Add(centres, hn::Set(d, float(x))), share);
    const V near = hn::Sub(hn::Set(d, 1.0f), far);
    const V q = hn::Add(hn::Mul(near, hn::Set(d, q0)), hn::Mul(far, hn::Set(d, q1)));
    const V p = hn::Add(hn::Mul(near, p0), hn::Mul(far, p1));
    if constexpr (kMethod == Reciprocal::kDivide) {
      look_up(hn::Div(p, q), texture, out + x);
    } else {
      look_up(hn::Mul(p, reciprocal<kMethod>(d, q)), texture, out + x);
    }
  }
}

template <int kSpan>
void line_by_spans(const PerspectiveLine& line, const std::int32_t* texture, std::int32_t* out) {
  const Tag d;
  const float q0 = line.inverse_w0, q1 = line.inverse_w1;
  const float p0 = line.u0 * q0, p1 = line.u1 * q1;
  const V centres = hn::Iota(d, 0.5f);
  const float share = 1.0f / float(line.pixels);
  float start = line.u0;
  for (int x = 0; x < line.pixels; x += kSpan) {
    const int length = std::min(kSpan, line.pixels - x);
    const float far = float(x + length) * share, near = 1.0f - far;
    const float end = (near * p0 + far * p1) / (near * q0 + far * q1);
    const float step = (end - start) * (length == kSpan ? 1.0f / kSpan : 1.0f / float(length));
    for (int i = 0; i < length; i += int(hn::Lanes(d))) {
      const V u = hn::Add(hn::Set(d, start),
                          hn::Mul(hn::Add(centres, hn::Set(d, float(i))), hn::Set(d, step)));
      look_up(u, texture, out + x + i);
    }
    start = end;
  }
}

using DrawLine = void (*)(const PerspectiveLine&, const std::int32_t*, std::int32_t*);

DrawLine line_function(Perspective method) {
  switch (method) {
    case Perspective::kDivide:
      return line_by_pixels<Reciprocal::kDivide>;
    case Perspective::kNewton:
      return line_by_pixels<Reciprocal::kNewton>;
    case Perspective::kApproximate:
      return line_by_pixels<Reciprocal::kApproximate>;
    case Perspective::kEvery8:
      return line_by_spans<8>;
    case Perspective::kEvery16:
      return line_by_spans<16>;
    case Perspective::kEvery32:
      return line_by_spans<32>;
    case Perspective::kAffine:
      break;
  }
  return line_by_spans<kLinePixels>;
}

void all_lines(Perspective method, const PerspectiveLine* lines, std::size_t count,
               const std::int32_t* texture, std::int32_t* out) {
  const DrawLine draw = line_function(method);
  for (std::size_t i = 0; i < count; ++i) draw(lines[i], texture, out + i * kLinePixels);
}

}  // namespace glassbox::study::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glassbox::study {

HWY_EXPORT(choose_reciprocal);
HWY_EXPORT(all_lines);

void reciprocals(Reciprocal method, std::span<const float> w, std::span<float> out) {
  HWY_DYNAMIC_DISPATCH(choose_reciprocal)(method, w.data(), out.data(), w.size());
}

void draw_lines(Perspective method, std::span<const PerspectiveLine> lines,
                std::span<const std::int32_t> texture, std::span<std::int32_t> out) {
  HWY_DYNAMIC_DISPATCH(all_lines)(method, lines.data(), lines.size(), texture.data(), out.data());
}

}  // namespace glassbox::study

#endif
