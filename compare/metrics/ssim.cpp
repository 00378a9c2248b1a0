#include <glassbox/compare/metrics/ssim.h>

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <glassbox/base/elementary.h>
#include <glassbox/compare/metrics/filter.h>
#include <glassbox/compare/metrics/samples.h>
#include <glassbox/images/colour/fixed_sum.h>

namespace glassbox {
namespace {

constexpr int kRadius = kSsimWindow / 2;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;

using Window = Taps<double, kRadius>;

Window make_window() {
  constexpr double kDeviation = 1.5;  // px
  Window window;
  double sum = 1;
  for (int r = 1; r <= kRadius; ++r) {
    window[std::size_t(r - 1)] = exponential(-r * r / (2 * kDeviation * kDeviation));
    sum += 2 * window[std::size_t(r - 1)];
  }
  for (double& weight : window) weight /= sum;
  return window;
}

constexpr std::ptrdiff_t kStride = kLargestSsimTile.width + 2 * kRadius;
constexpr std::ptrdiff_t kRows = kLargestSsimTile.height + 2 * kRadius;
using Row = std::array<double, std::size_t(kStride)>;
using Plane = std::array<double, std::size_t(kStride* kRows)>;

// The similarity is computed from the weighted means of four pictures: s = r + t, d = r - t, s^2
// and d^2, where r and t are the samples of the reference and of the test. This suffices because
// r^2 + t^2 = (s^2 + d^2)/2 and 2rt = (s^2 - d^2)/2; the same holds for the squared means and for
// the variances.
enum Part : std::uint8_t { kSum, kDifference, kSumSquare, kDifferenceSquare };
template <class Of>
using Parts = std::array<Of, 4>;

// If the pictures do not differ, numerator and denominator have the same bits, so the result is
// exactly 1.
double similarity(double sum, double difference, double sum_square, double difference_square) {
  const double mean_s = sum * sum;
  const double mean_d = difference * difference;
  const double variance_s = sum_square - mean_s;
  const double variance_d = difference_square - mean_d;
  return (((mean_s - mean_d) / 2 + kC1) * ((variance_s - variance_d) / 2 + kC2)) /
         (((mean_s + mean_d) / 2 + kC1) * ((variance_s + variance_d) / 2 + kC2));
}

// Loads the samples x, x + 1, ... of one channel of a row, scaled to [0, 1]. Pixels that are not
// compared come from the reference.
void load(const PicturePair& pair, int x, int y, int count, int channel, Parts<Row>& row) {
  const double scale = full_scale(pair.reference);
  const auto channels = std::size_t(pair.reference.channels);
  const std::size_t first =
      (std::size_t(y) * std::size_t(pair.reference.width) + std::size_t(x)) * channels +
      std::size_t(channel);
  std::visit(
      [&](const auto& reference) {
        const auto& test = std::get<std::decay_t<decltype(reference)>>(pair.test.samples);
        for (std::size_t i = 0; i < std::size_t(count); ++i) {
          const std::size_t at = first + i * channels;
          const auto& other = pair.selection.compares(x + int(i), y) ? test : reference;
          const double r = double(reference[at]) / scale;
          const double t = double(other[at]) / scale;
          row[kSum][i] = r + t;
          row[kDifference][i] = r - t;
        }
      },
      pair.reference.samples);
  for (std::size_t i = 0; i < std::size_t(count); ++i) {
    row[kSumSquare][i] = row[kSum][i] * row[kSum][i];
    row[kDifferenceSquare][i] = row[kDifference][i] * row[kDifference][i];
  }
}

struct Totals {
  FixedSum sum;
  double smallest = 1;
  void add(double value) {
    sum.add(value);
    smallest = std::min(smallest, value);
  }
  void add(const Totals& other) {
    sum.add(other.sum);
    smallest = std::min(smallest, other.smallest);
  }
};

// A thread's buffers, and the similarities that it has counted so far.
class SsimWorker {
public:
  // Adds the similarities of the windows whose centres are in `tile`.
  void add(const PicturePair& pair, const PixelBox& tile) {
    for (int channel = 0; channel < pair.reference.channels; ++channel) {
      for (int y = 0; y < tile.height + 2 * kRadius; ++y) {
        load(pair, tile.x - kRadius, tile.y + y - kRadius, tile.width + 2 * kRadius, channel, row_);
        for (std::size_t part = 0; part < row_.size(); ++part) {
          filter_even<1>(row_[part].data() + kRadius, tile.width, window_, 1.0,
                         planes_[part].data() + y * kStride);
        }
      }
      for (int y = 0; y < tile.height; ++y) {
        for (std::size_t part = 0; part < row_.size(); ++part) {
          filter_even<kStride>(planes_[part].data() + (y + kRadius) * kStride, tile.width, window_,
                               1.0, row_[part].data());
        }
        add_row(pair.selection, tile, tile.y + y);
      }
    }
  }
  const Totals& totals() const { return totals_; }

private:
  void add_row(const Selection& selection, const PixelBox& tile, int y) {
    auto& [sum, difference, sum_square, difference_square] = row_;
    for (std::size_t x = 0; x < std::size_t(tile.width); ++x) {
      sum[x] = similarity(sum[x], difference[x], sum_square[x], difference_square[x]);
    }
    for (int x = 0; x < tile.width; ++x) {
      if (selection.compares(tile.x + x, y)) totals_.add(sum[std::size_t(x)]);
    }
  }

  Window window_ = make_window();
  Parts<Row> row_;
  Parts<Plane> planes_;  // filtered along x
  Totals totals_;
};

}  // namespace

SsimValues ssim(const PicturePair& pair, TileSize tiles) {
  const int columns = pair.reference.width - 2 * kRadius;
  const int rows = pair.reference.height - 2 * kRadius;
  if (columns <= 0 || rows <= 0) return {};
  tbb::enumerable_thread_specific<std::unique_ptr<SsimWorker>> workers(
      [] { return std::make_unique<SsimWorker>(); });
  for_each_tile(columns, rows, tiles, [&](const PixelBox& tile) {
    workers.local()->add(pair, {tile.x + kRadius, tile.y + kRadius, tile.width, tile.height});
  });
  Totals all;
  for (const auto& worker : workers) all.add(worker->totals());
  if (all.sum.count() == 0) return {};
  return {all.sum.count(), all.sum.mean(), all.smallest};
}

}  // namespace glassbox
