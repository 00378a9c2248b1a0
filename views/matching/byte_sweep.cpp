#include "views/matching/byte_sweep.h"

#include <algorithm>
#include <array>
#include <span>

#include <tbb/parallel_for.h>

#include "views/matching/byte_kernels.h"
#include "views/matching/census.h"
#include "views/matching/paths.h"

namespace glassbox::views {

namespace {

// A differing bit of two census words costs 1. Words of unrelated pixels differ in 16 of 32 bits on
// average, with a standard deviation of about 3, so differences of more than 24 bits need not be
// told apart. The penalties are about 1/16 of those of the other sweeps, where a bit costs 16.
constexpr int kMaxBits = 24;
constexpr Penalties kPenalties{.p1 = 6, .p2 = 60, .p2_least = 12, .half_at = 10};
constexpr int kPaths = 3;
static_assert(kDisparityLanes % kByteLanes == 0);
static_assert(kPaths * (kMaxBits + kPenalties.p2) < kNoMatchCost);

constexpr int kLanes = kByteLanes;

using Line = CacheAlignedVector<std::uint8_t>;

// Sweeps a band of rows, one row after the other, with memory for a single row.
class Band {
public:
  Band(const ColorPlanes& left, const CensusPlanes& left_words, const CensusPlanes& right_words,
       const MatchSettings& settings)
      : picture_(left),
        left_words_(left_words),
        right_words_(right_words),
        settings_(settings),
        kernels_(byte_kernels(settings.target)),
        width_(std::size_t(left.width)),
        stride_((settings.range.count() + kLanes - 1) / kLanes * kLanes),
        // The index, in the reversed right row, of the pixel that the left row's last pixel matches
        // at disparity number 0: `first` entries after the right row's last pixel.
        origin_(std::max(0, -settings.range.first) + settings.range.first) {
    const auto stride = std::size_t(stride_);
    const auto reversed = width_ + std::size_t(std::abs(settings.range.first)) + stride;
    for (Line& bytes : right_) bytes.resize(reversed);
    for (Line* line : {&outside_, &right_least_, &right_low_, &right_high_})
      line->resize(reversed, kNoMatchCost);
    std::fill_n(outside_.begin() + (origin_ - settings.range.first), width_, std::uint8_t(0));
    past_range_.resize(stride);
    std::fill(past_range_.begin() + settings.range.count(), past_range_.end(), kNoMatchCost);
    best_mask_.resize(2 * stride + 3);
    std::fill_n(best_mask_.begin() + stride_, 3, kNoMatchCost);
    costs_.resize(width_ * stride);
    sums_.resize(width_ * stride);
    // Before the first row, the path values are 0, so that a path's first value is its cost alone.
    // Outside of the range of disparities they are kNoMatchCost.
    above_.resize(kLanes + width_ * cell(), kNoMatchCost);
    for (std::size_t x = 0; x < width_; ++x) {
      std::fill_n(above_.begin() + std::ptrdiff_t(kLanes + x * cell()), stride, std::uint8_t(0));
    }
    least_above_.resize(width_);
    along_.resize(stride + 2 * kLanes, kNoMatchCost);
    best_.resize(width_);
    least_.resize(width_);
    second_.resize(width_);
    const auto jumps = jump_penalties(kPenalties);
    std::ranges::copy(jumps, jumps_.begin());
  }

  // `whole` is false for the rows above the band, where only the paths downwards are needed.
  void sweep(int y, bool begins, bool whole) {
    take_right_row(y);
    const ByteRow row = row_of(y, begins);
    kernels_.sweep_right(row);
    if (whole) kernels_.sweep_left(row);
  }

  void find_winners(int y, DisparityMaps& winners) {
    std::ranges::fill(right_least_, kNoMatchCost);
    kernels_.winners(row_of(y, true), {best_mask_.data(), best_.data(), least_.data(),
                                       second_.data(), right_least_.data() + origin_,
                                       right_low_.data() + origin_, right_high_.data() + origin_});
    const std::size_t end = std::size_t(origin_ - settings_.range.first) + width_;
    for (std::size_t i = 0; i < width_; ++i) {
      const int x = int(i);
      const std::size_t at = end - 1 - i;
      if (right_least_[at] != kNoMatchCost) {
        const int high = stride_ > 256 ? right_high_[at] : 0;
        winners.right.at(x, y) = float(settings_.range.first + (high << 8) + right_low_[at]);
      }
      if (least_[i] == kNoMatchCost) continue;
      const int best = best_[i], least = least_[i], second = second_[i];
      if (second != kNoMatchCost && second != 0) {
        winners.confidence.at(x, y) = float(second - least) / float(second);
      }
      const std::uint8_t* sums = sums_.data() + i * std::size_t(stride_) + best;
      // A sum of kNoMatchCost marks a disparity without a right pixel; all other sums are less.
      const bool inside = settings_.subpixel && best > 0 && best + 1 < settings_.range.count() &&
                          sums[-1] != kNoMatchCost && sums[1] != kNoMatchCost;
      const float part = inside ? corner(sums[-1], least, sums[1]) : 0.0f;
      winners.left.at(x, y) = float(settings_.range.first + best) + part;
    }
  }

  std::span<const std::uint8_t> sums() const { return sums_; }

private:
  void take_right_row(int y) {
    for (std::size_t k = 0; k < kCensusBytes; ++k) {
      const std::uint8_t* from = right_words_.row(y)[k];
      std::reverse_copy(from, from + width_, right_[k].begin() + (origin_ - settings_.range.first));
    }
  }

  std::size_t cell() const { return std::size_t(stride_) + kLanes; }

  ByteRow row_of(int y, bool begins) {
    const std::uint8_t* grey = picture_.grey.data() + std::size_t(y) * width_;
    ByteRow row{.width = picture_.width,
                .stride = stride_,
                .left = left_words_.row(y),
                .right = {},
                .outside = outside_.data() + origin_,
                .past_range = past_range_.data(),
                .grey = grey,
                .grey_above = begins ? grey : grey - width_,
                .jumps = jumps_.data(),
                .p1 = std::uint8_t(kPenalties.p1),
                .most_bits = kMaxBits,
                .costs = costs_.data(),
                .above = above_.data() + kLanes,
                .least_above = least_above_.data(),
                .cell = int(cell()),
                .along = along_.data() + kLanes,
                .sums = sums_.data()};
    for (std::size_t k = 0; k < kCensusBytes; ++k) {
      row.right[k] = right_[k].data() + origin_;
    }
    return row;
  }

  const ColorPlanes& picture_;
  const CensusPlanes &left_words_, &right_words_;
  const MatchSettings& settings_;
  const ByteKernels& kernels_;
  std::size_t width_;
  int stride_;
  std::ptrdiff_t origin_;
  std::array<std::uint8_t, 256> jumps_;
  std::array<Line, kCensusBytes> right_;
  Line outside_, past_range_, best_mask_, costs_, sums_, above_, least_above_, along_;
  CacheAlignedVector<std::uint16_t> best_;
  Line least_, second_, right_least_, right_low_, right_high_;
};

}  // namespace

bool fits_bytes(const MatchSettings& settings) {
  return sweeps_once(settings) && settings.cost == MatchingCost::kCensus && settings.paths == 4;
}

std::uint64_t bytes_of_byte_band(int width, int stride) {
  // Costs, sums and path values of a row; the memory for single pixels and for the right picture is
  // negligible.
  return std::uint64_t(width) * std::uint64_t(3 * std::int64_t(stride) + kLanes);
}

DisparityMaps sweep_in_bytes(const ColorPlanes& left, const ColorPlanes& right,
                             const MatchSettings& settings, CostVolume* kept) {
  const CensusPlanes left_words = darker_neighbours(left, settings.target),
                     right_words = darker_neighbours(right, settings.target);
  DisparityMaps winners = no_winners(left.width, left.height);
  tbb::parallel_for(0, int(bands_of(left.height)), [&](int number) {
    const BandRows rows = band_rows(number, left.height);
    Band band(left, left_words, right_words, settings);
    for (int y = rows.warm_up; y < rows.end; ++y) {
      band.sweep(y, y == rows.warm_up, y >= rows.begin);
      if (y < rows.begin) continue;
      band.find_winners(y, winners);
      if (kept) std::ranges::copy(band.sums(), kept->at(0, y));
    }
  });
  return winners;
}

}  // namespace glassbox::views
