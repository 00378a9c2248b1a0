#include "views/matching/kernels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glassbox/raster/lanes/compiled_targets.h>

// This file is compiled once for each instruction set. Loops without intrinsics are vectorised by
// the compiler.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "views/matching/kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::views::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The number of 1 bits in a word, added up in fields of 2, 4 and 8 bits, because older processors
// have no instruction that counts them.
inline std::uint32_t bits_of(std::uint32_t word) {
  word -= (word >> 1) & 0x55555555u;
  word = (word & 0x33333333u) + ((word >> 2) & 0x33333333u);
  word = (word + (word >> 4)) & 0x0f0f0f0fu;
  word += word >> 8;
  word += word >> 16;
  return word & 63u;
}

void census_costs(std::uint32_t left, const std::uint32_t* HWY_RESTRICT right, int count,
                  int weight, std::uint16_t* HWY_RESTRICT out) {
  for (int i = 0; i < count; ++i) {
    out[i] = std::uint16_t(weight * int(bits_of(left ^ right[i])));
  }
}

void grey_costs(std::uint8_t left, const std::uint8_t* HWY_RESTRICT right, int count, int weight,
                std::uint16_t* HWY_RESTRICT out) {
  for (int i = 0; i < count; ++i) {
    out[i] = std::uint16_t(weight * std::abs(int(left) - int(right[i])));
  }
}

void running_sum(const std::uint32_t* HWY_RESTRICT before, const std::uint16_t* HWY_RESTRICT costs,
                 int count, std::uint32_t* HWY_RESTRICT sums) {
  for (int i = 0; i < count; ++i) sums[i] = before[i] + costs[i];
}

void mean(const std::uint32_t* HWY_RESTRICT before, const std::uint32_t* HWY_RESTRICT after,
          float inverse, int count, std::uint16_t* HWY_RESTRICT costs) {
  for (int i = 0; i < count; ++i) {
    costs[i] = std::uint16_t(int(float(int(after[i] - before[i])) * inverse + 0.5f));
  }
}

template <bool kBeginsSums>
HWY_INLINE std::uint16_t path_step(const std::uint16_t* HWY_RESTRICT costs,
                                   const std::uint16_t* HWY_RESTRICT before, std::uint16_t least,
                                   std::uint16_t p1, std::uint16_t jump, int count,
                                   std::uint16_t* HWY_RESTRICT out,
                                   std::uint16_t* HWY_RESTRICT sums) {
  const hn::CappedTag<std::uint16_t, 32> d;
  const int lanes = int(hn::Lanes(d));
  const auto step = hn::Set(d, p1), from_any = hn::Set(d, std::uint16_t(least + jump));
  const auto base = hn::Set(d, least);
  auto smallest = hn::Set(d, std::uint16_t(65535));
  for (int i = 0; i < count; i += lanes) {
    const auto same = hn::LoadU(d, before + i);
    const auto beside = hn::Min(hn::LoadU(d, before + i - 1), hn::LoadU(d, before + i + 1));
    const auto best = hn::Min(hn::Min(same, from_any), hn::SaturatedAdd(beside, step));
    const auto value = hn::Add(hn::LoadU(d, costs + i), hn::Sub(best, base));
    hn::StoreU(value, d, out + i);
    hn::StoreU(kBeginsSums ? value : hn::Add(hn::LoadU(d, sums + i), value), d, sums + i);
    smallest = hn::Min(smallest, value);
  }
  return hn::GetLane(hn::MinOfLanes(d, smallest));
}

template <bool kBeginsSums>
void path_row_of(const MatchKernels::PathRow& row) {
  for (int i = 0; i < row.width; ++i) {
    const int x = row.leftwards ? row.width - 1 - i : i, from = x - row.from;
    const bool begins = !row.before || from < 0 || from >= row.width;
    const int change = begins ? 0 : std::abs(int(row.grey[x]) - int(row.grey_before[from]));
    const auto at = std::ptrdiff_t(x) * row.stride;
    row.least[x] = path_step<kBeginsSums>(
        row.costs + at, begins ? row.nothing : row.before + std::ptrdiff_t(from) * row.cell,
        begins ? std::uint16_t(0) : row.least_before[from], row.p1, row.jumps[change], row.stride,
        row.values + std::ptrdiff_t(x) * row.cell, row.sums + at);
  }
}

void path_row(const MatchKernels::PathRow& row) {
  row.begins_sums ? path_row_of<true>(row) : path_row_of<false>(row);
}

void add(const std::uint16_t* HWY_RESTRICT more, int count, std::uint16_t* HWY_RESTRICT sums) {
  for (int i = 0; i < count; ++i) sums[i] = std::uint16_t(sums[i] + more[i]);
}

std::uint16_t least(const std::uint16_t* values, int count) {
  std::uint16_t result = 65535;
  for (int i = 0; i < count; ++i) result = values[i] < result ? values[i] : result;
  return result;
}

void keep_less(const std::uint16_t* HWY_RESTRICT values, int count,
               std::uint16_t* HWY_RESTRICT best, std::uint16_t* HWY_RESTRICT which,
               int first_which) {
  for (int i = 0; i < count; ++i) {
    const bool less = values[i] < best[i];
    which[i] = less ? std::uint16_t(first_which + i) : which[i];
    best[i] = less ? values[i] : best[i];
  }
}

void add_near(const float* own, const float* values, int count, float near,
              float* HWY_RESTRICT sums, float* HWY_RESTRICT counts) {
  const hn::CappedTag<float, 16> d;
  const int lanes = int(hn::Lanes(d));
  const auto limit = hn::Set(d, near), one = hn::Set(d, 1.0f);
  int i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto off = hn::Sub(hn::LoadU(d, values + i), hn::LoadU(d, own + i));
    const auto is_near = hn::Lt(hn::Abs(off), limit);
    hn::StoreU(hn::Add(hn::LoadU(d, sums + i), hn::IfThenElseZero(is_near, off)), d, sums + i);
    hn::StoreU(hn::Add(hn::LoadU(d, counts + i), hn::IfThenElseZero(is_near, one)), d, counts + i);
  }
  for (; i < count; ++i) {
    const float off = values[i] - own[i];
    const bool is_near = std::abs(off) < near;
    sums[i] += is_near ? off : 0.0f;
    counts[i] += is_near ? 1.0f : 0.0f;
  }
}

const MatchKernels kKernels{census_costs, grey_costs, running_sum, mean,    path_row,
                            add,          least,      keep_less,   add_near};

}  // namespace glassbox::views::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glassbox::views {

const MatchKernels& match_kernels(Target target) {
#include <glassbox/raster/lanes/kernels_of_target-inl.h>
}

}  // namespace glassbox::views

#endif
