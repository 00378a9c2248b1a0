#include "views/voxels/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glassbox/base/elementary.h>

#include "views/voxels/blocks.h"

namespace glassbox::views {

namespace {

// An order of the pictures in steps of about 0.38 of their number (the golden section), so that the
// first few pictures look from all around.
std::vector<std::size_t> scattered_order(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::size_t step = std::max<std::size_t>(1, std::size_t(double(count) * 0.381966));
  while (std::gcd(step, count) != 1) ++step;
  for (std::size_t i = 0; i < count; ++i) order[i] = i * step % count;
  return order;
}

constexpr int kPart = 16;  // voxels along a run for which background and hiding are tested together

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

std::vector<double> likelihood_ratios(const ColoringSettings& settings) {
  if (settings.consistency != Consistency::kLikelihood) return {};
  std::vector<double> ratios(kExactRatios + 1, 0);
  for (std::size_t k = 2; k <= kExactRatios; ++k) {
    const double degrees = 3 * double(k - 1);
    ratios[k] = chi_squared_quantile(degrees, settings.significance) / degrees;
  }
  return ratios;
}

// The results of one thread for a few runs.
struct Sweep::Block {
  std::vector<VoxelPosition> colored;
  std::vector<VoxelObservation> observations;
  std::vector<std::size_t> places;  // of the coloured voxels, as indices into the layer's verdicts
  std::vector<RowPicture> rows, active_rows;
  std::vector<std::int32_t> sums[7];
  // Indices into active_: the pictures in which some voxel of the part may be visible.
  std::vector<std::size_t> open;
};

// Voxels from .. from + count - 1 of a run, whose verdicts begin at `at`. `rows` has the run's row
// in each of the pictures of active_.
struct Sweep::Part {
  const VoxelRun& run;
  int from, count;
  std::size_t at;
  const RowPicture* rows;
};

Sweep::Sweep(const VoxelGrid& grid, std::vector<PackedPicture>& pictures,
             const ColoringSettings& settings, const std::vector<double>& ratios)
    : grid_(grid),
      pictures_(pictures),
      settings_(settings),
      order_(scattered_order(pictures.size())),
      ratios_(ratios) {
  for (const PackedPicture& picture : pictures_) {
    lenses_.push_back(grid_picture(grid_, picture));
    tiles_.emplace_back(picture);
  }
  // A voxel may be given up early only if no later picture can make it acceptable again. So the
  // bound is the largest sum of deviations that is allowed for any number of pixels up to the
  // number of pictures.
  double most = 0;
  for (std::size_t k = 2; k <= std::min(kExactRatios, pictures_.size()); ++k)
    most = std::max(most, 3 * double(k - 1) * limit(std::int64_t(k)));
  const bool may_end_early = settings_.consistency != Consistency::kAdaptive &&
                             settings_.edge == 0 && settings_.sampled == Footprint::kCentre &&
                             pictures_.size() <= kExactRatios;
  most_deviations_ = may_end_early && most < double(std::numeric_limits<float>::max())
                         ? float(most) * (1 + 0x1p-20f)
                         : std::numeric_limits<float>::infinity();
}

// The largest allowed variance for this many pixels, in squared codes (packed_picture.h). For more
// than 256 pixels the cube root of the quantile is treated as normally distributed (Wilson and
// Hilferty 1931), fitted to the quantile for 256.
double Sweep::limit(std::int64_t pixels) const {
  if (settings_.consistency != Consistency::kLikelihood) {
    const double threshold = settings_.threshold * kCodesPerLevel;
    return threshold * threshold;
  }
  const double noise = settings_.noise * kCodesPerLevel, variance = noise * noise;
  if (pixels <= std::int64_t(kExactRatios)) return variance * ratios_[std::size_t(pixels)];
  const auto spread = [](double degrees) { return 2 / (9 * degrees); };
  const double known = 3 * double(kExactRatios - 1), degrees = 3 * double(pixels - 1);
  const double normal = (cube_root(ratios_.back()) - 1 + spread(known)) / std::sqrt(spread(known));
  const double root = 1 - spread(degrees) + normal * std::sqrt(spread(degrees));
  return variance * root * root * root;
}

Verdict Sweep::classify_voxel(const VoxelObservation& seen) const {
  if (seen.is_background) return Verdict::kBackground;
  if (seen.is_inconsistent) return Verdict::kInconsistent;
  if (seen.views == 0) return Verdict::kHidden;
  if (seen.views == 1)
    return settings_.alone == SingleViewPolicy::kKeep ? Verdict::kColored : Verdict::kAlone;
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

void Sweep::add_colored(const VoxelRun& run, int i, const VoxelObservation& seen,
                        Block& block) const {
  block.colored.push_back(run.at(i));
  block.observations.push_back(seen);
  block.observations.back().color = mean_color(run, i, seen);
}

Rgba8 Sweep::mean_color(const VoxelRun& run, int i, const VoxelObservation& seen) const {
  double sums[3] = {0, 0, 0};
  double count = double(seen.sums.count);
  if (settings_.space == ColorSpace::kRgb) {
    for (int k = 0; k < 3; ++k) sums[k] = double(seen.sums.channel[k]) / kCodesPerLevel;
  } else {
    count = 0;
    for (const std::size_t p : active_) {
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

// Whether the whole box is background in one of the pictures that are looked at before the first
// comparison of colours. (In later pictures, inconsistent colours could be found before the
// background.)
bool Sweep::is_background(const VoxelBox& box) const {
  const bool has_trials = most_deviations_ < std::numeric_limits<float>::infinity();
  const std::size_t first = has_trials ? std::size_t(kPicturesBetweenTrials) : active_.size();
  for (std::size_t i = 0; i < std::min(first, active_.size()); ++i) {
    const std::size_t p = active_[i];
    const auto rect = rect_of(lenses_[p], box);
    if (rect && tiles_[p].is_background(*rect)) return true;
  }
  return false;
}

void Sweep::find_undecided(const VoxelBox& box, std::vector<std::size_t>& open) const {
  open.clear();
  for (std::size_t i = 0; i < active_.size(); ++i) {
    const std::size_t p = active_[i];
    const auto rect = rect_of(lenses_[p], box);
    if (!rect || !tiles_[p].is_hidden(*rect)) open.push_back(i);
  }
}

namespace {

VoxelBox box_of_runs(std::span<const VoxelRun> runs) {
  VoxelBox box{runs.front().first, runs.front().first};
  for (const VoxelRun& run : runs) {
    const VoxelPosition last = run.at(run.count - 1);
    box.low = {std::min(box.low.x, run.first.x), std::min(box.low.y, run.first.y),
               std::min(box.low.z, run.first.z)};
    box.high = {std::max(box.high.x, last.x), std::max(box.high.y, last.y),
                std::max(box.high.z, last.z)};
  }
  return box;
}

std::int64_t voxels_of(const VoxelBox& box) {
  return std::int64_t(box.high.x - box.low.x + 1) * (box.high.y - box.low.y + 1) *
         (box.high.z - box.low.z + 1);
}

}  // namespace

// Classifies the runs in parts of kPart voxels: neighbouring voxels have neighbouring pixels, which
// are still in the cache, and a part that is entirely background or hidden needs no look-up of its
// voxels.
void Sweep::classify_runs(std::span<const VoxelRun> runs, std::size_t first_run, Block& block) {
  block.rows.clear();
  std::int64_t voxels = 0;
  bool is_one_axis = true;
  for (const VoxelRun& run : runs) {
    for (const std::size_t p : active_)
      block.rows.push_back(row_of(lenses_[p], pictures_[p], run.first, run.axis));
    voxels += run.count;
    is_one_axis = is_one_axis && run.axis == runs.front().axis;
  }
  const auto part_of = [&](std::size_t r, int from, int count) {
    return Part{runs[r], from, count, first_of_run_[first_run + r],
                block.rows.data() + r * active_.size()};
  };
  const VoxelBox box = box_of_runs(runs);
  // If runs are short or far apart, testing the box around them saves little, so each run is tested
  // by itself. Runs in the cells of a coarser level are like that.
  constexpr std::int64_t kMaxEmpty = 2, kMinParts = 4;
  if (!is_one_axis || voxels_of(box) > kMaxEmpty * voxels ||
      voxels < kMinParts * kPart * std::int64_t(runs.size())) {
    block.open.resize(active_.size());
    std::iota(block.open.begin(), block.open.end(), std::size_t(0));
    for (std::size_t r = 0; r < runs.size(); ++r)
      classify_part(part_of(r, 0, runs[r].count), block);
    return;
  }
  const int axis = runs.front().axis;
  const int begin = VoxelRun{box.low, axis, 0}.begin(), end = VoxelRun{box.high, axis, 0}.begin();
  for (int from = begin; from <= end; from += kPart) {
    const int last = std::min(from + kPart - 1, end);
    const auto along = [&](VoxelPosition at, int place) {
      (axis == 0 ? at.x : axis == 1 ? at.y : at.z) = place;
      return at;
    };
    const VoxelBox part{along(box.low, from), along(box.high, last)};
    const bool all_background = is_background(part);
    if (!all_background) find_undecided(part, block.open);
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const int low = std::max(from, runs[r].begin()) - runs[r].begin();
      const int high = std::min(last, runs[r].begin() + runs[r].count - 1) - runs[r].begin();
      if (high < low) continue;
      if (all_background) {
        std::fill_n(verdicts_.begin() + std::ptrdiff_t(first_of_run_[first_run + r]) + low,
                    high - low + 1, Verdict::kBackground);
      } else if (!block.open.empty()) {  // else hidden, which is the initial verdict
        classify_part(part_of(r, low, high - low + 1), block);
      }
    }
  }
}

// Puts the coloured voxels, which were found part by part, back into the order of the runs.
void Sweep::put_in_order(Block& block) {
  std::vector<std::size_t> order(block.places.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::sort(order, {}, [&](std::size_t i) { return block.places[i]; });
  std::vector<VoxelPosition> colored;
  std::vector<VoxelObservation> observations;
  for (const std::size_t i : order) {
    colored.push_back(block.colored[i]);
    observations.push_back(block.observations[i]);
  }
  block.colored = std::move(colored);
  block.observations = std::move(observations);
}

void Sweep::classify_part(const Part& part, Block& block) {
  // Leaves out pictures in which nothing of the part is visible. The colours are still tested after
  // the same pictures as without this, so that the verdicts are the same.
  block.active_rows.clear();
  std::size_t trial = 0;
  for (const std::size_t i : block.open) {
    const std::size_t its_trial = i / std::size_t(kPicturesBetweenTrials);
    if (!block.active_rows.empty()) block.active_rows.back().is_trial = its_trial != trial;
    trial = its_trial;
    block.active_rows.push_back(part.rows[i]);
  }
  if (!block.active_rows.empty()) {
    block.active_rows.back().is_trial =
        (trial + 1) * std::size_t(kPicturesBetweenTrials) <= active_.size();
  }
  for (auto& sums : block.sums) {
    if (sums.size() < std::size_t(part.count + kMaxLanes))
      sums.resize(std::size_t(part.count + kMaxLanes));
  }
  const RowSums out{block.sums[0].data(), block.sums[1].data(), block.sums[2].data(),
                    block.sums[3].data(), block.sums[4].data(), block.sums[5].data(),
                    block.sums[6].data()};
  voxel_kernels(settings_.target)
      .sum_row(block.active_rows.data(), int(block.active_rows.size()),
               part.run.begin() + part.from, part.count, most_deviations_, out);
  const bool has_spread = wants_spread(settings_);
  for (int i = 0; i < part.count; ++i) {
    Verdict& verdict = verdicts_[part.at + std::size_t(part.from + i)];
    if (out.count[i] <= 0) {
      verdict = out.count[i] == kIsBackground     ? Verdict::kBackground
                : out.count[i] == kIsInconsistent ? Verdict::kInconsistent
                                                  : Verdict::kHidden;
      continue;
    }
    VoxelObservation seen;
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
    verdict = classify_voxel(seen);
    if (verdict != Verdict::kColored) continue;
    block.places.push_back(part.at + std::size_t(part.from + i));
    add_colored(part.run, part.from + i, seen, block);
  }
}

// Looks up one voxel in all pictures, with any footprint.
VoxelObservation Sweep::look_up(const VoxelRun& run, int i) const {
  VoxelObservation seen;
  const int first = run.begin();
  int asked = 0;
  for (const std::size_t p : active_) {
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
      add_word(here, word);
      if (!picture.spread.empty()) spread = picture.spread[pixel];
    });
    if (is_framed ? !has_object : picture.shows_whole_object) {
      seen.is_background = true;
      return seen;
    }
    if (here.count > 0) {
      // M is the mean over the pictures of the deviation within each picture. If the voxel covers
      // several pixels of a picture, it is the deviation of these pixels; a single pixel has none,
      // so the deviation around it is used.
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

void Sweep::hide(std::size_t p, const RowPicture& row, int place) {
  PackedPicture& picture = pictures_[p];
  for_each_pixel(lenses_[p], projected(row, place), settings_.hidden, [&](int x, int y) {
    std::uint32_t& word =
        picture.words[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
    if ((word & (kHidden | kBackground)) == 0) tiles_[p].hide(x, y);
    word |= kHidden;
  });
}

void Sweep::classify_voxels(const VoxelRun& run, std::size_t at, Block& block,
                            Occluders occluders) {
  for (int i = 0; i < run.count; ++i) {
    const VoxelObservation seen = look_up(run, i);
    Verdict& verdict = verdicts_[at + std::size_t(i)];
    verdict = classify_voxel(seen);
    if (verdict == Verdict::kColored) add_colored(run, i, seen, block);
    if (settings_.update == OcclusionUpdate::kVoxel && is_occluder(verdict, occluders)) {
      for (const std::size_t p : active_)
        hide(p, row_of(lenses_[p], run.first, run.axis), run.begin() + i);
    }
  }
}

void Sweep::classify_layer(std::span<const VoxelRun> runs, Occluders occluders) {
  // If a voxel depends on what the previous one hides, the voxels cannot be classified in parallel.
  const bool in_turn = settings_.update == OcclusionUpdate::kVoxel;
  constexpr std::size_t kRunsOfBlock = 8;
  const std::size_t of_block = in_turn ? std::max<std::size_t>(runs.size(), 1) : kRunsOfBlock;
  std::vector<Block> blocks((runs.size() + of_block - 1) / of_block);
  const bool by_row = settings_.sampled == Footprint::kCentre && !in_turn;
  for_blocks(blocks.size(), settings_.threads, [&](std::size_t b) {
    Block& block = blocks[b];
    const std::size_t begin = b * of_block, end = std::min(begin + of_block, runs.size());
    if (by_row) {
      classify_runs(runs.subspan(begin, end - begin), begin, block);
      put_in_order(block);
      return;
    }
    for (std::size_t r = begin; r < end; ++r)
      classify_voxels(runs[r], first_of_run_[r], block, occluders);
  });
  colored_.clear();
  observations_.clear();
  for (const Block& block : blocks) {
    colored_.insert(colored_.end(), block.colored.begin(), block.colored.end());
    observations_.insert(observations_.end(), block.observations.begin(), block.observations.end());
  }
}

void Sweep::hide_layer(std::span<const VoxelRun> runs, Occluders occluders) {
  struct Occluder {
    std::size_t run;
    int i;
  };
  std::vector<Occluder> hiding_voxels;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (int i = 0; i < runs[r].count; ++i) {
      if (is_occluder(verdicts_[first_of_run_[r] + std::size_t(i)], occluders))
        hiding_voxels.push_back({r, i});
    }
  }
  if (hiding_voxels.empty()) return;
  for_blocks(active_.size(), settings_.threads, [&](std::size_t index) {
    const std::size_t p = active_[index];
    RowPicture row{};
    std::size_t row_is_of = runs.size();
    int first = 0;
    for (const Occluder& occluder : hiding_voxels) {
      const VoxelRun& run = runs[occluder.run];
      if (occluder.run != row_is_of) {
        row = row_of(lenses_[p], run.first, run.axis);
        row_is_of = occluder.run;
        first = run.begin();
      }
      hide(p, row, first + occluder.i);
    }
  });
}

void Sweep::layer(std::span<const VoxelRun> runs, std::span<const std::uint8_t> active,
                  Occluders occluders) {
  active_.clear();
  for (const std::size_t p : order_)
    if (active.empty() || active[p] != 0) active_.push_back(p);
  first_of_run_.clear();
  std::size_t voxels = 0;
  for (const VoxelRun& run : runs) {
    first_of_run_.push_back(voxels);
    voxels += std::size_t(run.count);
  }
  verdicts_.assign(voxels, Verdict::kHidden);
  classify_layer(runs, occluders);
  if (settings_.update == OcclusionUpdate::kLayer) hide_layer(runs, occluders);
}

}  // namespace glassbox::views
