#include <glassbox/compare/pixels/differences.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glassbox/base/rounding.h>
#include <glassbox/compare/pixels/moved_edge.h>
#include <glassbox/compare/pixels/perceived_distance.h>
#include <glassbox/compare/pixels/regions.h>

namespace glassbox {
namespace {

template <class Sample>
std::uint32_t steps_between(Sample a, Sample b, bool) {
  return a < b ? std::uint32_t(b - a) : std::uint32_t(a - b);
}
std::uint32_t steps_between(float a, float b, bool nan_equals_nan) {
  return ulp_distance(a, b, nan_equals_nan);
}

template <class Sample>
bool has_nan(const Sample*, std::size_t) {
  return false;
}
bool has_nan(const float* samples, std::size_t count) {
  return std::any_of(samples, samples + count, [](float sample) { return std::isnan(sample); });
}

// Whether the samples are known to be the same from their bytes alone: where NaN differs from
// itself, it must not be among them.
template <class Sample>
bool same_samples(const Sample* reference, const Sample* test, std::size_t count,
                  bool nan_equals_nan) {
  return std::memcmp(reference, test, count * sizeof(Sample)) == 0 &&
         (nan_equals_nan || !has_nan(reference, count));
}

template <int kChannels, class Sample>
void compare_pixels(const Sample* reference, const Sample* test, bool nan_equals_nan,
                    std::span<std::uint32_t> steps) {
  for (std::uint32_t& largest : steps) {
    largest = 0;
    for (int channel = 0; channel < kChannels; ++channel) {
      largest = std::max(largest, steps_between(*reference++, *test++, nan_equals_nan));
    }
  }
}

// Compares a row in blocks of pixels: most blocks are the same in both pictures, which memcmp finds
// many bytes at a time.
template <int kChannels, class Sample>
void compare_row(const Sample* reference, const Sample* test, bool nan_equals_nan,
                 std::span<std::uint32_t> steps) {
  constexpr std::size_t kBlock = 16;  // px
  for (std::size_t x = 0; x < steps.size(); x += kBlock) {
    const auto block = steps.subspan(x, std::min(kBlock, steps.size() - x));
    const Sample *from = reference + x * kChannels, *to = test + x * kChannels;
    if (same_samples(from, to, block.size() * kChannels, nan_equals_nan)) {
      std::fill(block.begin(), block.end(), 0u);
    } else {
      compare_pixels<kChannels>(from, to, nan_equals_nan, block);
    }
  }
}

// A loop over a number of channels that the compiler knows is several times as fast.
template <class Sample>
void compare_row(const Sample* reference, const Sample* test, int channels, bool nan_equals_nan,
                 std::span<std::uint32_t> steps) {
  switch (channels) {
    case 1:
      return compare_row<1>(reference, test, nan_equals_nan, steps);
    case 2:
      return compare_row<2>(reference, test, nan_equals_nan, steps);
    case 3:
      return compare_row<3>(reference, test, nan_equals_nan, steps);
    default:
      return compare_row<4>(reference, test, nan_equals_nan, steps);
  }
}

void exclude_row(const Selection& selection, int y, std::span<std::uint32_t> steps) {
  if (selection.includes_all()) return;
  for (std::size_t x = 0; x < steps.size(); ++x) {
    if (!selection.compares(int(x), y)) steps[x] = 0;
  }
}

// Counts the pixels of a row that are set aside, and clears their steps.
void set_aside(std::span<const PixelKind> kinds, std::span<std::uint32_t> steps,
               Differences& found) {
  for (std::size_t x = 0; x < steps.size(); ++x) {
    if (kinds[x] != PixelKind::kMovedEdge && kinds[x] != PixelKind::kBelowThreshold) continue;
    auto& count = kinds[x] == PixelKind::kMovedEdge ? found.moved_edges : found.below_threshold;
    ++count.pixels;
    count.largest = std::max(count.largest, steps[x]);
    steps[x] = 0;
  }
}

void grow(PixelBox& box, int x, int y) {
  if (box.width == 0) {
    box = {x, y, 1, 1};
    return;
  }
  const int right = std::max(box.x + box.width, x + 1);
  const int bottom = std::max(box.y + box.height, y + 1);
  box.x = std::min(box.x, x);
  box.y = std::min(box.y, y);
  box.width = right - box.x;
  box.height = bottom - box.y;
}

}  // namespace

std::uint32_t ulp_distance(float a, float b, bool nan_equals_nan) {
  if (std::isnan(a) || std::isnan(b)) {
    return nan_equals_nan && std::isnan(a) && std::isnan(b) ? 0 : kUnbounded;
  }
  // Here -0 and +0 are two different floats, one ulp apart.
  const bool across_zero = std::signbit(a) != std::signbit(b);
  if (a == b && !across_zero) return 0;
  if (std::isinf(a) || std::isinf(b)) return kUnbounded;
  // At most 2 * 0x7f7fffff + 1 between the two largest finite floats: below kUnbounded.
  return std::uint32_t(ulp_distance(a, b)) + (across_zero ? 1 : 0);
}

bool row_differences(const PicturePair& pair, int y, std::span<std::uint32_t> steps) {
  const auto row_samples = std::size_t(pair.reference.width) * std::size_t(pair.reference.channels);
  return std::visit(
      [&](const auto& samples) {
        using Samples = std::decay_t<decltype(samples)>;
        const auto* reference = samples.data() + std::size_t(y) * row_samples;
        const auto* test =
            std::get<Samples>(pair.test.samples).data() + std::size_t(y) * row_samples;
        if (same_samples(reference, test, row_samples, pair.nan_equals_nan)) {
          std::fill(steps.begin(), steps.end(), 0u);
          return false;
        }
        compare_row(reference, test, pair.reference.channels, pair.nan_equals_nan, steps);
        exclude_row(pair.selection, y, steps);
        return true;
      },
      pair.reference.samples);
}

DifferenceRows::DifferenceRows(const PicturePair& pair)
    : pair_(pair),
      rows_together_(pair.set_aside.moved_edges && pair.kinds.empty() ? kMovedEdgeRows : 1) {
  const int rows = std::min(rows_together_, pair.reference.height);
  const std::size_t pixels = std::size_t(rows) * std::size_t(pair.reference.width);
  steps_.resize(pixels);
  kinds_.resize(pixels);
  may_differ_.resize(std::size_t(rows));
}

bool DifferenceRows::next() {
  ++y_;
  if (y_ == pair_.reference.height) return false;
  if (row() == 0) compute_together();
  return true;
}

void DifferenceRows::compute_together() {
  const int rows = std::min(rows_together_, pair_.reference.height - y_);
  for (int row = 0; row < rows; ++row) {
    may_differ_[std::size_t(row)] = row_differences(pair_, y_ + row, row_of(steps_, row));
  }
  if (pair_.kinds.empty()) return find_kinds(rows);
  const auto first = std::size_t(y_) * std::size_t(pair_.reference.width);
  std::ranges::copy(pair_.kinds.subspan(first, kinds_.size()), kinds_.begin());
}

void DifferenceRows::find_kinds(int rows) {
  for (int row = 0; row < rows; ++row) {
    const auto steps = row_of(steps_, row);
    const auto kinds = row_of(kinds_, row);
    std::transform(steps.begin(), steps.end(), kinds.begin(), [](std::uint32_t step) {
      return step == 0 ? PixelKind::kSame : PixelKind::kDifferent;
    });
    if (pair_.set_aside.threshold) mark_below_threshold(pair_, y_ + row, kinds);
  }
  if (!pair_.set_aside.moved_edges) return;
  const std::size_t pixels = std::size_t(rows) * std::size_t(pair_.reference.width);
  mark_moved_edges(pair_, y_, std::span(kinds_).first(pixels));
}

Differences find_differences(const PicturePair& pair, std::vector<PixelKind>* kinds,
                             std::size_t kept_regions) {
  Differences found;
  if (kinds != nullptr) kinds->clear();
  found.compared = pair.selection.compared_pixels();
  RegionFinder regions(pair.reference.width, kept_regions);
  for (DifferenceRows rows(pair); rows.next();) {
    const auto steps = rows.steps();
    if (kinds != nullptr) kinds->insert(kinds->end(), rows.kinds().begin(), rows.kinds().end());
    if (rows.may_differ() && !pair.set_aside.empty()) set_aside(rows.kinds(), steps, found);
    regions.add_row(rows.y(), steps);
    if (!rows.may_differ()) continue;
    for (int x = 0; x < pair.reference.width; ++x) {
      if (steps[std::size_t(x)] == 0) continue;
      if (found.differing++ == 0) found.first = {x, rows.y()};
      found.largest = std::max(found.largest, steps[std::size_t(x)]);
      grow(found.box, x, rows.y());
    }
  }
  found.regions = regions.worst();
  found.region_count = regions.count();
  return found;
}

}  // namespace glassbox
