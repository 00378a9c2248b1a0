#include <glassbox/compare/metrics/flip.h>

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <memory>
#include <vector>

#include <glassbox/compare/metrics/affected_box.h>
#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/images/colour/fixed_sum.h>

namespace glassbox {
namespace {

// Counts errors, each rounded to the nearest multiple of 2^-16.
class Histogram {
public:
  void add(float error, std::uint64_t times) {
    counts_[std::size_t(error * float(kBins) + 0.5f)] += std::uint32_t(times);
  }
  void add(const Histogram& other) {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  }
  // The smallest error that at least `rank` of the errors do not exceed.
  double at_rank(std::uint64_t rank) const {
    std::size_t bin = 0;
    for (std::uint64_t seen = counts_[0]; seen < rank; seen += counts_[bin]) ++bin;
    return double(bin) / kBins;
  }

private:
  static constexpr int kBins = 1 << 16;
  std::vector<std::uint32_t> counts_ = std::vector<std::uint32_t>(kBins + 1);
};

// A thread's tile and its counts so far.
struct FlipWorker {
  std::unique_ptr<FlipTile> tile = std::make_unique<FlipTile>();
  FixedSum sum;
  Histogram histogram;
  float largest = 0;

  void count(float error, std::uint64_t times = 1) {
    sum.add(double(error), times);
    histogram.add(error, times);
    largest = std::max(largest, error);
  }
};

using FlipWorkers = tbb::enumerable_thread_specific<FlipWorker>;

FlipErrors combine(const FlipWorkers& workers) {
  FixedSum sum;
  Histogram histogram;
  FlipErrors errors;
  for (const FlipWorker& worker : workers) {
    sum.add(worker.sum);
    histogram.add(worker.histogram);
    errors.max = std::max(errors.max, double(worker.largest));
  }
  errors.pixels = sum.count();
  if (errors.pixels == 0) return errors;
  errors.mean = sum.mean();
  errors.median = histogram.at_rank((errors.pixels + 1) / 2);
  errors.p95 = histogram.at_rank((errors.pixels * 95 + 99) / 100);
  return errors;
}

// The level is rounded up.
std::uint8_t level_of_error(float error) {
  const float level = error * float(kHeatHottest);
  return level_of_ramp(int(level) + (level > float(int(level))));
}

}  // namespace

FlipErrors flip(const PicturePair& pair, TileSize tiles) {
  FlipWorkers workers;
  for_each_tile(pair.reference.width, pair.reference.height, tiles, [&](const PixelBox& tile) {
    FlipWorker& worker = workers.local();
    const PixelBox box = worker.tile->compute(pair, tile);
    for (int y = 0; y < box.height; ++y) {
      const float* error = worker.tile->error().row(y);
      for (int x = 0; x < box.width; ++x) {
        if (pair.selection.compares(box.x + x, box.y + y)) worker.count(error[x]);
      }
    }
    worker.count(0, compared_pixels(pair.selection, tile) - compared_pixels(pair.selection, box));
  });
  return combine(workers);
}

Image<std::uint8_t> flip_heat_map(const PicturePair& pair) {
  Image<std::uint8_t> levels(pair.reference.width, pair.reference.height);
  tbb::enumerable_thread_specific<std::unique_ptr<FlipTile>> tiles(
      [] { return std::make_unique<FlipTile>(); });
  for (int y = 0; y < levels.height; ++y) {
    for (int x = 0; x < levels.width; ++x) {
      levels.at(x, y) = pair.selection.compares(x, y) ? kHeatSame : kHeatNotCompared;
    }
  }
  for_each_tile(levels.width, levels.height, kLargestFlipTile, [&](const PixelBox& tile) {
    FlipTile& computed = *tiles.local();
    const PixelBox box = computed.compute(pair, tile);
    for (int y = 0; y < box.height; ++y) {
      for (int x = 0; x < box.width; ++x) {
        std::uint8_t& level = levels.at(box.x + x, box.y + y);
        if (level != kHeatNotCompared) level = level_of_error(computed.error().row(y)[x]);
      }
    }
  });
  return levels;
}

}  // namespace glassbox
