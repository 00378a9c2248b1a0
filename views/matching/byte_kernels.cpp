#include "views/matching/byte_kernels.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include <glassbox/raster/lanes/compiled_targets.h>

// Highway compiles this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "views/matching/byte_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::views::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::CappedTag<std::uint8_t, 32>;
using ByteVector = hn::Vec<Bytes>;

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE ByteVector bits_of(ByteVector byte) {
  return hn::Set(Bytes(), std::uint8_t(std::popcount(hn::GetLane(byte))));
}

HWY_INLINE ByteVector least_of(ByteVector byte) {
  return byte;
}

#else

using Words = hn::Repartition<std::uint16_t, Bytes>;

// The number of 1 bits in each byte, from a table for half a byte (4 bits).
HWY_INLINE ByteVector bits_of(ByteVector bytes) {
  alignas(16) constexpr std::uint8_t kBits[16] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
  const Bytes d;
  const Words words;
  const auto table = hn::LoadDup128(d, kBits), half = hn::Set(d, std::uint8_t(15));
  const auto high = hn::BitCast(d, hn::ShiftRight<4>(hn::BitCast(words, bytes)));
  return hn::Add(hn::TableLookupBytes(table, hn::And(bytes, half)),
                 hn::TableLookupBytes(table, hn::And(high, half)));
}

// The smallest of all bytes, copied into every lane.
HWY_INLINE ByteVector least_of(ByteVector bytes) {
  const Bytes d;
  const Words words;
  const auto pairs = hn::BitCast(words, bytes);
  const auto even = hn::And(pairs, hn::Set(words, std::uint16_t(255)));
  const auto least = hn::MinOfLanes(words, hn::Min(even, hn::ShiftRight<8>(pairs)));
  return hn::BitCast(d, hn::Or(least, hn::ShiftLeft<8>(least)));
}

#endif

// What a path needs for its step from one pixel to the next. The new value is cost + min(before,
// before at a neighbouring disparity + p1, least before + jump) - least before, where `before` are
// the values at the previous pixel; from_any is least before + jump, and `base` is least before.
struct Step {
  ByteVector p1, from_any, base;
};

HWY_INLINE Step step_of(ByteVector p1, ByteVector least, std::uint8_t jump) {
  return {p1, hn::SaturatedAdd(least, hn::Set(Bytes(), jump)), least};
}

HWY_INLINE ByteVector step(const Step& step, ByteVector cost, ByteVector less, ByteVector same,
                           ByteVector more) {
  const auto beside = hn::SaturatedAdd(hn::Min(less, more), step.p1);
  const auto best = hn::Min(hn::Min(same, step.from_any), beside);
  return hn::SaturatedAdd(cost, hn::SaturatedSub(best, step.base));
}

// Calls one(row, column) for each neighbour in the census window; `one` returns 0 or 255 in each
// lane. Column 0 is three pixels to the left of the centre. x is the centre of the first lane.
template <class One>
HWY_INLINE void neighbours_of(int x, const CensusPointers<std::uint8_t>& out, const One& one) {
  const Bytes d;
  auto byte = hn::Zero(d);
  int bit = 0;
  for (std::size_t row = 0; row < 5; ++row) {
    for (int column = 0; column < 7; ++column) {
      if (row == 2 && (column == 0 || column == 3 || column == 6)) continue;
      byte = hn::Sub(hn::Add(byte, byte), one(row, column));
      if (++bit % 8 == 0) hn::StoreU(byte, d, out[std::size_t(bit / 8 - 1)] + x);
    }
  }
}

HWY_INLINE ByteVector difference(ByteVector a, ByteVector b) {
  return hn::Or(hn::SaturatedSub(a, b), hn::SaturatedSub(b, a));
}

void darker(const CensusRows& grey, int width, const CensusPointers<std::uint8_t>& out) {
  const Bytes d;
  for (int x = 0; x < width; x += int(hn::Lanes(d))) {
    const auto centre = hn::LoadU(d, grey[2] + x + 3);
    neighbours_of(x, out, [&](std::size_t row, int column) HWY_ATTR {
      return hn::VecFromMask(d, hn::Lt(hn::LoadU(d, grey[row] + x + column), centre));
    });
  }
}

void similar(const std::array<CensusRows, 3>& channels, std::uint8_t limit, std::uint8_t least,
             int width, const CensusPointers<std::uint8_t>& out) {
  const Bytes d;
  const auto most = hn::Set(d, limit);
  for (int x = 0; x < width; x += int(hn::Lanes(d))) {
    const auto r = hn::LoadU(d, channels[0][2] + x + 3), g = hn::LoadU(d, channels[1][2] + x + 3),
               b = hn::LoadU(d, channels[2][2] + x + 3);
    neighbours_of(x, out, [&](std::size_t row, int column) HWY_ATTR {
      const auto off = [&](const CensusRows& rows, ByteVector centre) HWY_ATTR {
        return difference(hn::LoadU(d, rows[row] + x + column), centre);
      };
      const auto farthest =
          hn::Max(hn::Max(off(channels[0], r), off(channels[1], g)), off(channels[2], b));
      return hn::VecFromMask(d, hn::Eq(hn::Max(farthest, most), most));
    });
    auto count = hn::Zero(d);
    for (std::uint8_t* bytes : out) count = hn::Add(count, bits_of(hn::LoadU(d, bytes + x)));
    const auto too_few = hn::VecFromMask(d, hn::Lt(count, hn::Set(d, least)));
    for (std::uint8_t* bytes : out) {
      hn::StoreU(hn::Or(hn::LoadU(d, bytes + x), too_few), d, bytes + x);
    }
  }
}

void color_costs(const ColorRow& row) {
  const Bytes d;
  const int lanes = int(hn::Lanes(d));
  const auto most_bits = hn::Set(d, row.most_bits), most_color = hn::Set(d, row.most_color);
  for (int x = 0; x < row.width; ++x) {
    const auto place = std::ptrdiff_t(row.width - 1 - x);
    std::uint16_t* costs = row.costs + std::ptrdiff_t(x) * row.stride;
    alignas(64) std::uint8_t bits_out[kByteLanes], color_out[kByteLanes];
    for (int i = 0; i < row.stride; i += lanes) {
      auto bits = hn::Zero(d), color = hn::Zero(d);
      for (std::size_t k = 0; k < kCensusBytes; ++k) {
        const auto differ =
            hn::Xor(hn::Set(d, row.left[k][x]), hn::LoadU(d, row.right[k] + place + i));
        const auto both = hn::And(hn::Set(d, row.left_similar[k][x]),
                                  hn::LoadU(d, row.right_similar[k] + place + i));
        bits = hn::Add(bits, bits_of(hn::And(differ, both)));
      }
      for (std::size_t k = 0; k < 3; ++k) {
        color = hn::SaturatedAdd(color, difference(hn::Set(d, row.left_color[k][x]),
                                                   hn::LoadU(d, row.right_color[k] + place + i)));
      }
      hn::Store(hn::Min(bits, most_bits), d, bits_out);
      hn::Store(hn::Min(color, most_color), d, color_out);
      for (int lane = 0; lane < lanes; ++lane) {
        costs[i + lane] =
            std::uint16_t(row.census_weight * bits_out[lane] + row.color_weight * color_out[lane]);
      }
    }
  }
}

void sweep_right(const ByteRow& row) {
  const Bytes d;
  const int lanes = int(hn::Lanes(d));
  const auto most = hn::Set(d, row.most_bits), p1 = hn::Set(d, row.p1);
  std::uint8_t* along = row.along;
  std::fill_n(along, row.stride, std::uint8_t(0));
  auto least_along = hn::Zero(d);
  for (int x = 0; x < row.width; ++x) {
    const auto place = std::ptrdiff_t(row.width - 1 - x);
    const auto at = std::ptrdiff_t(x) * row.stride;
    const auto a = hn::Set(d, row.left[0][x]), b = hn::Set(d, row.left[1][x]),
               c = hn::Set(d, row.left[2][x]), e = hn::Set(d, row.left[3][x]);
    const int grey = row.grey[x];
    const int beside = row.grey[std::max(x - 1, 0)];
    const Step from_left = step_of(p1, least_along, row.jumps[std::abs(grey - beside)]);
    const Step from_above = step_of(p1, hn::Set(d, row.least_above[x]),
                                    row.jumps[std::abs(grey - int(row.grey_above[x]))]);
    std::uint8_t* above = row.above + std::ptrdiff_t(x) * row.cell;
    // The values at the next smaller disparity for each lane: they are read before a block
    // overwrites them, and used for the block after it.
    auto less_along = hn::LoadU(d, along - 1), less_above = hn::LoadU(d, above - 1);
    least_along = hn::Set(d, kNoMatchCost);
    auto least_above = least_along;
    for (int i = 0; i < row.stride; i += lanes) {
      const auto bits_of_block = [&](int byte, ByteVector own) HWY_ATTR {
        return bits_of(hn::Xor(own, hn::LoadU(d, row.right[std::size_t(byte)] + place + i)));
      };
      const auto bits = hn::Add(hn::Add(bits_of_block(0, a), bits_of_block(1, b)),
                                hn::Add(bits_of_block(2, c), bits_of_block(3, e)));
      const auto no_match =
          hn::Or(hn::LoadU(d, row.outside + place + i), hn::LoadU(d, row.past_range + i));
      const auto cost = hn::Or(hn::Min(bits, most), no_match);
      hn::StoreU(cost, d, row.costs + at + i);

      const auto value_along =
          step(from_left, cost, less_along, hn::LoadU(d, along + i), hn::LoadU(d, along + i + 1));
      less_along = hn::LoadU(d, along + i + lanes - 1);
      hn::StoreU(value_along, d, along + i);
      least_along = hn::Min(least_along, value_along);

      const auto value_above =
          step(from_above, cost, less_above, hn::LoadU(d, above + i), hn::LoadU(d, above + i + 1));
      less_above = hn::LoadU(d, above + i + lanes - 1);
      hn::StoreU(value_above, d, above + i);
      least_above = hn::Min(least_above, value_above);

      hn::StoreU(hn::SaturatedAdd(value_along, value_above), d, row.sums + at + i);
    }
    least_along = least_of(least_along);
    row.least_above[x] = hn::GetLane(least_of(least_above));
  }
}

void sweep_left(const ByteRow& row) {
  const Bytes d;
  const int lanes = int(hn::Lanes(d));
  const auto p1 = hn::Set(d, row.p1);
  std::uint8_t* along = row.along;
  std::fill_n(along, row.stride, std::uint8_t(0));
  auto least = hn::Zero(d);
  for (int x = row.width - 1; x >= 0; --x) {
    const auto at = std::ptrdiff_t(x) * row.stride;
    const int beside = row.grey[std::min(x + 1, row.width - 1)];
    const Step from_right = step_of(p1, least, row.jumps[std::abs(int(row.grey[x]) - beside)]);
    auto less = hn::LoadU(d, along - 1);
    least = hn::Set(d, kNoMatchCost);
    for (int i = 0; i < row.stride; i += lanes) {
      const auto value = step(from_right, hn::LoadU(d, row.costs + at + i), less,
                              hn::LoadU(d, along + i), hn::LoadU(d, along + i + 1));
      less = hn::LoadU(d, along + i + lanes - 1);
      hn::StoreU(value, d, along + i);
      least = hn::Min(least, value);
      std::uint8_t* sums = row.sums + at + i;
      hn::StoreU(hn::SaturatedAdd(hn::LoadU(d, sums), value), d, sums);
    }
    least = least_of(least);
  }
}

void winners(const ByteRow& row, const ByteWinners& out) {
  const Bytes d;
  const int lanes = int(hn::Lanes(d));
  const auto numbers = hn::Iota(d, std::uint8_t(0));
  for (int x = 0; x < row.width; ++x) {
    const std::uint8_t* sums = row.sums + std::ptrdiff_t(x) * row.stride;
    const auto place = std::ptrdiff_t(row.width - 1 - x);
    auto least = hn::Set(d, kNoMatchCost);
    for (int i = 0; i < row.stride; i += lanes) {
      const auto sum = hn::LoadU(d, sums + i);
      least = hn::Min(least, sum);
      std::uint8_t *right = out.right_least + place + i, *low = out.right_low + place + i,
                   *high = out.right_high + place + i;
      const auto before = hn::LoadU(d, right);
      const auto is_less = hn::Lt(sum, before);
      hn::StoreU(hn::Min(sum, before), d, right);
      const auto number = hn::Add(numbers, hn::Set(d, std::uint8_t(i & 255)));
      hn::StoreU(hn::IfThenElse(is_less, number, hn::LoadU(d, low)), d, low);
      if (row.stride <= 256) continue;
      const auto block = hn::Set(d, std::uint8_t(i >> 8));
      hn::StoreU(hn::IfThenElse(is_less, block, hn::LoadU(d, high)), d, high);
    }
    least = least_of(least);
    int best = 0;
    for (int i = 0; i < row.stride; i += lanes) {
      const auto found = hn::FindFirstTrue(d, hn::Eq(hn::LoadU(d, sums + i), least));
      if (found < 0) continue;
      best = i + int(found);
      break;
    }
    auto second = hn::Set(d, kNoMatchCost);
    const std::uint8_t* best_mask = out.best_mask + row.stride + 1 - best;
    for (int i = 0; i < row.stride; i += lanes) {
      second = hn::Min(second, hn::Or(hn::LoadU(d, sums + i), hn::LoadU(d, best_mask + i)));
    }
    out.best[x] = std::uint16_t(best);
    out.least[x] = hn::GetLane(least);
    out.second[x] = hn::GetLane(least_of(second));
  }
}

const ByteKernels kKernels{darker, similar, color_costs, sweep_right, sweep_left, winners};

}  // namespace glassbox::views::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glassbox::views {

const ByteKernels& byte_kernels(Target target) {
#include <glassbox/raster/lanes/kernels_of_target-inl.h>
}

}  // namespace glassbox::views

#endif
