#include <glassbox/compare/metrics/ssim.h>

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <glassbox/base/elementary.h>
#include <glassbox/compare/metrics/affected_box.h>
#include <glassbox/compare/metrics/filter.h>
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
GLASSBOX_INLINE double similarity(double sum, double difference, double sum_square,
                                  double difference_square) {
  const double mean_s = sum * sum;
  const double mean_d = difference * difference;
  const double variance_s = sum_square - mean_s;
  const double variance_d = difference_square - mean_d;
  return (((mean_s - mean_d) / 2 + kC1) * ((variance_s - variance_d) / 2 + kC2)) /
         (((mean_s + mean_d) / 2 + kC1) * ((variance_s + variance_d) / 2 + kC2));
}

// Scales a sample to [0, 1].
double unit(std::uint8_t sample) {
  static constexpr auto kUnits = [] {
    std::array<double, 256> units{};
    for (std::size_t i = 0; i < units.size(); ++i) units[i] = double(i) / 255;
    return units;
  }();
  return kUnits[sample];
}
double unit(std::uint16_t sample) {
  return double(sample) / 65535;
}
double unit(float sample) {
  return double(sample);
}

// Loads the sums and the differences of the samples x, x + 1, ... of one channel of a row. Pixels
// that are not compared come from the reference.
void load(const PicturePair& pair, int x, int y, int count, int channel, Parts<Row>& row) {
  const auto channels = std::size_t(pair.reference.channels);
  const std::size_t first =
      (std::size_t(y) * std::size_t(pair.reference.width) + std::size_t(x)) * channels +
      std::size_t(channel);
  std::visit(
      [&](const auto& reference) {
        const auto& test = std::get<std::decay_t<decltype(reference)>>(pair.test.samples);
        const bool whole = pair.selection.includes_all();
        for (std::size_t i = 0; i < std::size_t(count); ++i) {
          const std::size_t at = first + i * channels;
          const auto& other = whole || pair.selection.compares(x + int(i), y) ? test : reference;
          const double r = unit(reference[at]);
          const double t = unit(other[at]);
          row[kSum][i] = r + t;
          row[kDifference][i] = r - t;
        }
      },
      pair.reference.samples);
}

// Filters a row, whose sums and differences are loaded, along x into row y of the planes.
GLASSBOX_WIDE void filter_across(const Window& window, int width, int y, Parts<Row>& row,
                                 Parts<Plane>& planes) {
  auto& [sum, difference, sum_square, difference_square] = row;
  for (std::size_t i = 0; i < std::size_t(width + 2 * kRadius); ++i) {
    sum_square[i] = sum[i] * sum[i];
    difference_square[i] = difference[i] * difference[i];
  }
  for (std::size_t part = 0; part < row.size(); ++part) {
    filter_even<1>(row[part].data() + kRadius, width, window, 1.0,
                   planes[part].data() + y * kStride);
  }
}

// Computes the similarities of the windows whose centres are in row y of the box into row[kSum].
GLASSBOX_WIDE void compute_similarities(const Window& window, int width, int y,
                                        const Parts<Plane>& planes, Parts<Row>& row) {
  for (std::size_t part = 0; part < row.size(); ++part) {
    filter_even<kStride>(planes[part].data() + (y + kRadius) * kStride, width, window, 1.0,
                         row[part].data());
  }
  auto& [sum, difference, sum_square, difference_square] = row;
  for (std::size_t x = 0; x < std::size_t(width); ++x) {
    sum[x] = similarity(sum[x], difference[x], sum_square[x], difference_square[x]);
  }
}

struct Totals {
  FixedSum sum;
  double smallest = 1;
  void add(double value, std::uint64_t times = 1) {
    sum.add(value, times);
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
      const PixelBox box = affected_box(pair, tile, kRadius, {channel, 1});
      // A window without a difference has mean_d = variance_d = 0, so its similarity is 1.
      totals_.add(1, compared_pixels(pair.selection, tile) - compared_pixels(pair.selection, box));
      if (box.width > 0) add(pair, box, channel);
    }
  }
  const Totals& totals() const { return totals_; }

private:
  void add(const PicturePair& pair, const PixelBox& box, int channel) {
    for (int y = 0; y < box.height + 2 * kRadius; ++y) {
      load(pair, box.x - kRadius, box.y + y - kRadius, box.width + 2 * kRadius, channel, row_);
      filter_across(window_, box.width, y, row_, planes_);
    }
    for (int y = 0; y < box.height; ++y) {
      compute_similarities(window_, box.width, y, planes_, row_);
      Totals of_row;
      for (int x = 0; x < box.width; ++x) {
        if (pair.selection.compares(box.x + x, box.y + y)) of_row.add(row_[kSum][std::size_t(x)]);
      }
      totals_.add(of_row);
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
