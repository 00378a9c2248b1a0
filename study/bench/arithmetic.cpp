#include "study/bench/arithmetic.h"

#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "study/bench/arithmetic.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::study::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Computes sixteen chains of operations that do not depend on each other, to keep the processor
// busy: an operation takes about four cycles, and a processor can start two operations in each
// cycle.
std::int64_t chains(std::int64_t rounds, float& result) {
  const hn::CappedTag<float, 16> tag;
  using Vector = hn::Vec<decltype(tag)>;
  constexpr std::size_t kChains = 16;
  const Vector half = hn::Set(tag, 0.5f), one = hn::Set(tag, 1.0f);
  Vector chain[kChains];
  for (std::size_t i = 0; i < kChains; ++i) chain[i] = hn::Set(tag, float(i));
  for (std::int64_t round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < kChains; ++i) chain[i] = hn::Add(hn::Mul(chain[i], half), one);
  }
  Vector sum = hn::Zero(tag);
  for (const Vector& end : chain) sum = hn::Add(sum, end);
  result = hn::GetLane(sum);
  return rounds * std::int64_t(2 * kChains * hn::Lanes(tag));
}

}  // namespace glassbox::study::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glassbox::study {

HWY_EXPORT(chains);

std::int64_t do_arithmetic(std::int64_t rounds, float& result) {
  return HWY_DYNAMIC_DISPATCH(chains)(rounds, result);
}

}  // namespace glassbox::study

#endif
