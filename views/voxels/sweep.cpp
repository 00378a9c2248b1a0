#include "views/voxels/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "views/voxels/blocks.h"

namespace glassbox::views {

namespace {

constexpr std::size_t kExactLimits = 256;

// T^2 by K in codes (packed_picture.h). K = 0 and 1 decide nothing.
std::vector<double> limits_of(const ColoringSettings& settings) {
  std::vector<double> limits(kExactLimits + 1);
  const double threshold = settings.threshold * kCodesPerLevel;
  const double noise = settings.noise * kCodesPerLevel;
  for (std::size_t k = 2; k <= kExactLimits; ++k) {
    const double degrees = 3 * double(k - 1);
    limits[k] = settings.consistency == Consistency::kLikelihood
                    ? noise * noise * chi_squared_quantile(degrees, settings.significance) / degrees
                    : threshold * threshold;
  }
  return limits;
}

// Steps of about the golden section, so that the first few pictures look from all around.
std::vector<std::size_t> scattered(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::size_t step = std::max<std::size_t>(1, std::size_t(double(count) * 0.381966));
  while (std::gcd(step, count) != 1) ++step;
  for (std::size_t i = 0; i < count; ++i) order[i] = i * step % count;
  return order;
}

bool is_occluder(Verdict verdict, Occluders occluders) {
  if (verdict == Verdict::kColored) return true;
  return occluders == Occluders::kNotCarved &&
         (verdict == Verdict::kHidden || verdict == Verdict::kAlone);
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::string_view kNames[kVerdicts] = {"background", "hidden", "alone", "inconsistent",
                                                  "coloured"};
  return kNames[std::size_t(verdict)];
}

// What one thread finds in a few runs.
struct Sweep::Block {
  std::vector<VoxelAt> colored;
  std::vector<Seen> seen;
  std::vector<RowPicture> rows;
  std::vector<std::int32_t> sums[7];
};

Sweep::Sweep(const VoxelGrid& grid, std::vector<PackedPicture>& pictures,
             const ColoringSettings& settings)
    : grid_(grid),
      pictures_(pictures),
      settings_(settings),
      order_(scattered(pictures.size())),
      limits_(limits_of(settings)) {
  for (const PackedPicture& picture : pictures_) lenses_.push_back(grid_picture(grid_, picture));
  // Deviations may only be given up early where nothing that comes later can excuse them.
  double most = 0;
  for (std::size_t k = 2; k <= kExactLimits; ++k)
    most = std::max(most, 3 * double(k - 1) * limits_[k]);
  const bool may_end_early = settings_.consistency != Consistency::kAdaptive &&
                             settings_.edge == 0 && settings_.sampled == Footprint::kCentre &&
                             pictures_.size() <= kExactLimits;
  most_deviations_ = may_end_early && most < double(std::numeric_limits<float>::max())
                         ? float(most) * (1 + 0x1p-20f)
                         : std::numeric_limits<float>::infinity();
}

// Beyond 256 pixels the cube root of the quantile is normal (Wilson and Hilferty 1931), with the quantile of 256 for its own.
double Sweep::limit(std::int64_t pixels) const {
  if (pixels <= std::int64_t(kExactLimits)) return limits_[std::size_t(pixels)];
  if (settings_.consistency != Consistency::kLikelihood) return limits_.back();
  const double noise = settings_.noise * kCodesPerLevel, variance = noise * noise;
  const auto spread = [](double degrees) { return 2 / (9 * degrees); };
  const double known = 3 * double(kExactLimits - 1), degrees = 3 * double(pixels - 1);
  const double normal =
      (std::cbrt(limits_.back() / variance) - 1 + spread(known)) / std::sqrt(spread(known));
  const double root = 1 - spread(degrees) + normal * std::sqrt(spread(degrees));
  return variance * root * root * root;
}

Verdict Sweep::judge(const Seen& seen) const {
  if (seen.is_background) return Verdict::kBackground;
  if (seen.is_inconsistent) return Verdict::kInconsistent;
  if (seen.views == 0) return Verdict::kHidden;
  if (seen.views == 1) return settings_.alone == Alone::kKeep ? Verdict::kColored : Verdict::kAlone;
  double most = 0;
  if (settings_.consistency == Consistency::kAdaptive) {
    const double threshold =
        settings_.k1 * (seen.spread / seen.views) + settings_.k2 * kCodesPerLevel;
    most = threshold * threshold;
  } else {
    most = limit(seen.sums.count);
  }
  if (seen.sums.variance() < most) return Verdict::kColored;
  const bool is_edge = settings_.edge > 0 && seen.least_spread >= settings_.edge * kCodesPerLevel;
  return is_edge ? Verdict::kColored : Verdict::kInconsistent;
}

void Sweep::keep(const VoxelRun& run, int i, const Seen& seen, Block& block) const {
  block.colored.push_back(run.at(i));
  block.seen.push_back(seen);
  block.seen.back().color = mean_color(run, i, seen);
}

Rgba8 Sweep::mean_color(const VoxelRun& run, int i, const Seen& seen) const {
  double sums[3] = {0, 0, 0};
  double count = double(seen.sums.count);
  if (settings_.space == ColorSpace::kRgb) {
    for (int k = 0; k < 3; ++k) sums[k] = double(seen.sums.channel[k]) / kCodesPerLevel;
  } else {
    count = 0;
    for (const std::size_t p : asked_) {
      const PackedPicture& picture = pictures_[p];
      const RowPicture row = row_of(lenses_[p], picture, run.first, run.axis);
      for_each_pixel(
          lenses_[p], projected(row, run.begin() + i), settings_.sampled, [&](int x, int y) {
            const std::size_t pixel = std::size_t(y) * std::size_t(picture.width) + std::size_t(x);
            if ((picture.words[pixel] & (kHidden | kBackground)) != 0) return;
            const Rgba8& color = picture.rgb[pixel];
            sums[0] += color.r;
            sums[1] += color.g;
            sums[2] += color.b;
            ++count;
          });
    }
  }
  const auto mean = [&](double sum) {
    return std::uint8_t(std::clamp(std::floor(sum / count + 0.5), 0.0, 255.0));
  };
  return {mean(sums[0]), mean(sums[1]), mean(sums[2]), 255};
}

void Sweep::judge_row(const VoxelRun& run, std::size_t at, Block& block) {
  block.rows.clear();
  for (const std::size_t p : asked_)
    block.rows.push_back(row_of(lenses_[p], pictures_[p], run.first, run.axis));
  for (auto& sums : block.sums) sums.resize(std::size_t(run.count + kMostLanes));
  const RowSums out{block.sums[0].data(), block.sums[1].data(), block.sums[2].data(),
                    block.sums[3].data(), block.sums[4].data(), block.sums[5].data(),
                    block.sums[6].data()};
  const int first = run.begin();
  voxel_kernels(settings_.target)
      .sum_row(block.rows.data(), int(block.rows.size()), first, run.count, most_deviations_, out);
  const bool has_spread = wants_spread(settings_);
  for (int i = 0; i < run.count; ++i) {
    Verdict& verdict = verdicts_[at + std::size_t(i)];
    if (out.count[i] <= 0) {
      verdict = out.count[i] == kIsBackground     ? Verdict::kBackground
                : out.count[i] == kIsInconsistent ? Verdict::kInconsistent
                                                  : Verdict::kHidden;
      continue;
    }
    Seen seen;
    seen.sums.count = out.count[i];
    seen.sums.channel[0] = out.a[i];
    seen.sums.channel[1] = out.b[i];
    seen.sums.channel[2] = out.c[i];
    seen.sums.squares = out.squares[i];
    seen.views = out.count[i];
    if (has_spread) {
      seen.spread = out.spread[i];
      seen.least_spread = out.least_spread[i];
    }
    verdict = judge(seen);
    if (verdict == Verdict::kColored) keep(run, i, seen, block);
  }
}

// One voxel in all pictures, with whatever footprint.
Seen Sweep::look_up(const VoxelRun& run, int i) const {
  Seen seen;
  const int first = run.begin();
  int asked = 0;
  for (const std::size_t p : asked_) {
    const PackedPicture& picture = pictures_[p];
    const GridPicture& lens = lenses_[p];
    const RowPicture row = row_of(lens, picture, run.first, run.axis);
    ColorSums here;
    bool is_framed = false, has_object = false;
    double spread = 0;
    for_each_pixel(lens, projected(row, first + i), settings_.sampled, [&](int x, int y) {
      const std::size_t pixel = std::size_t(y) * std::size_t(picture.width) + std::size_t(x);
      const std::uint32_t word = picture.words[pixel];
      is_framed = true;
      if ((word & kBackground) != 0) return;
      has_object = true;
      if ((word & kHidden) != 0) return;
      here.add(word & kChannelMask, word >> kChannelBits & kChannelMask,
               word >> (2 * kChannelBits) & kChannelMask);
      if (!picture.spread.empty()) spread = picture.spread[pixel];
    });
    if (is_framed ? !has_object : picture.has_whole) {
      seen.is_background = true;
      return seen;
    }
    if (here.count > 0) {
      // Within several pixels their own deviation is M's, as it is defined; one pixel has none, and is asked for those around it.
      if (here.count > 1) spread = std::sqrt(here.variance());
      seen.least_spread = seen.views == 0 ? spread : std::min(seen.least_spread, spread);
      seen.spread += spread;
      seen.sums.add(here);
      ++seen.views;
    }
    const ColorSums& sums = seen.sums;
    if (++asked % kPicturesBetweenTrials == 0 && sums.count > 0 &&
        sums.deviations() > double(most_deviations_)) {
      seen.is_inconsistent = true;
      return seen;
    }
  }
  return seen;
}

void Sweep::hide(std::size_t p, const VoxelRun& run, int i) {
  PackedPicture& picture = pictures_[p];
  const RowPicture row = row_of(lenses_[p], picture, run.first, run.axis);
  const int first = run.begin();
  for_each_pixel(lenses_[p], projected(row, first + i), settings_.hidden, [&](int x, int y) {
    picture.words[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)] |= kHidden;
  });
}

void Sweep::judge_voxels(const VoxelRun& run, std::size_t at, Block& block, Occluders occluders) {
  for (int i = 0; i < run.count; ++i) {
    const Seen seen = look_up(run, i);
    Verdict& verdict = verdicts_[at + std::size_t(i)];
    verdict = judge(seen);
    if (verdict == Verdict::kColored) keep(run, i, seen, block);
    if (settings_.update == Update::kVoxel && is_occluder(verdict, occluders)) {
      for (const std::size_t p : asked_) hide(p, run, i);
    }
  }
}

void Sweep::judge_layer(std::span<const VoxelRun> runs, Occluders occluders) {
  // A voxel that is judged by what the one before it hides cannot be judged beside it.
  const bool in_turn = settings_.update == Update::kVoxel;
  constexpr std::size_t kRunsOfBlock = 8;
  const std::size_t of_block = in_turn ? std::max<std::size_t>(runs.size(), 1) : kRunsOfBlock;
  std::vector<Block> blocks((runs.size() + of_block - 1) / of_block);
  const bool by_row = settings_.sampled == Footprint::kCentre && !in_turn;
  for_blocks(blocks.size(), settings_.threads, [&](std::size_t b) {
    Block& block = blocks[b];
    for (std::size_t r = b * of_block; r < std::min((b + 1) * of_block, runs.size()); ++r) {
      if (by_row) {
        judge_row(runs[r], first_of_run_[r], block);
      } else {
        judge_voxels(runs[r], first_of_run_[r], block, occluders);
      }
    }
  });
  colored_.clear();
  seen_.clear();
  for (const Block& block : blocks) {
    colored_.insert(colored_.end(), block.colored.begin(), block.colored.end());
    seen_.insert(seen_.end(), block.seen.begin(), block.seen.end());
  }
}

void Sweep::hide_layer(std::span<const VoxelRun> runs, Occluders occluders) {
  struct Hider {
    std::size_t run;
    int i;
  };
  std::vector<Hider> hiders;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (int i = 0; i < runs[r].count; ++i) {
      if (is_occluder(verdicts_[first_of_run_[r] + std::size_t(i)], occluders))
        hiders.push_back({r, i});
    }
  }
  if (hiders.empty()) return;
  for_blocks(asked_.size(), settings_.threads, [&](std::size_t index) {
    const std::size_t p = asked_[index];
    PackedPicture& picture = pictures_[p];
    RowPicture row{};
    std::size_t row_is_of = runs.size();
    int first = 0;
    for (const Hider& hider : hiders) {
      const VoxelRun& run = runs[hider.run];
      if (hider.run != row_is_of) {
        row = row_of(lenses_[p], picture, run.first, run.axis);
        row_is_of = hider.run;
        first = run.begin();
      }
      for_each_pixel(
          lenses_[p], projected(row, first + hider.i), settings_.hidden, [&](int x, int y) {
            picture.words[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)] |= kHidden;
          });
    }
  });
}

void Sweep::layer(std::span<const VoxelRun> runs, std::span<const std::uint8_t> active,
                  Occluders occluders) {
  asked_.clear();
  for (const std::size_t p : order_)
    if (active.empty() || active[p] != 0) asked_.push_back(p);
  first_of_run_.clear();
  std::size_t voxels = 0;
  for (const VoxelRun& run : runs) {
    first_of_run_.push_back(voxels);
    voxels += std::size_t(run.count);
  }
  verdicts_.assign(voxels, Verdict::kHidden);
  judge_layer(runs, occluders);
  if (settings_.update == Update::kLayer) hide_layer(runs, occluders);
}

}  // namespace glassbox::views
