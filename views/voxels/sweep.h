// Sweeps over layers of voxels, those nearest to the cameras first: combines what all pictures show
// of each voxel, and marks what it then hides (S1-18, S1-21, S1-31).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "views/voxels/footprint.h"
#include "views/voxels/grid.h"
#include "views/voxels/kernels.h"
#include "views/voxels/packed_picture.h"
#include "views/voxels/statistics.h"
#include "views/voxels/tiles.h"

namespace glassbox::views {

enum class Verdict : std::uint8_t {
  kBackground,  // a picture shows background there, or contains the whole object but not this voxel
  // No picture sees it: coloured voxels are in front of it, or it is outside of all pictures.
  kHidden,
  kAlone,         // only one picture sees it, so that colours cannot be compared
  kInconsistent,  // the pictures show different colours
  kColored,
};
inline constexpr int kVerdicts = 5;
std::string_view name_of(Verdict verdict);
using VerdictCounts = std::array<std::int64_t, kVerdicts>;

// `count` voxels from `first` on, along an axis of the grid.
struct VoxelRun {
  VoxelPosition first;
  int axis = 0;
  int count = 0;

  // The coordinate of the first voxel along the axis.
  int begin() const { return axis == 0 ? first.x : axis == 1 ? first.y : first.z; }
  VoxelPosition at(int i) const {
    VoxelPosition voxel = first;
    (axis == 0 ? voxel.x : axis == 1 ? voxel.y : voxel.z) += i;
    return voxel;
  }
};

struct ColoredVoxel {
  VoxelPosition at;
  Rgba8 color;              // the mean of its pixels
  std::uint16_t views = 0;  // pictures that see it
  float deviation = 0;  // standard deviation of its colours, pooled over the channels, in levels
  friend bool operator==(const ColoredVoxel&, const ColoredVoxel&) = default;
};

// The voxels that hide what is behind them: the coloured ones (voxel colouring), or all that are
// not proved empty (space carving).
enum class Occluders { kColored, kNotCarved };

// For the likelihood ratio (Consistency::kLikelihood): the chi-squared quantile for K pixels
// divided by its degrees of freedom, for K = 0 .. kExactRatios. Empty for other tests. A request
// computes it once for all of its sweeps.
inline constexpr std::size_t kExactRatios = 256;
std::vector<double> likelihood_ratios(const ColoringSettings& settings);

class Sweep {
public:
  // All arguments must outlive the sweep, which sets the hidden bits of the pictures. `ratios` is
  // likelihood_ratios(settings).
  Sweep(const VoxelGrid& grid, std::vector<PackedPicture>& pictures,
        const ColoringSettings& settings, const std::vector<double>& ratios);

  // Classifies the voxels of one layer, and then hides what is behind them. The verdicts are in the
  // order of the runs. Pictures that are not `active` (one flag each; empty: all are) are not
  // looked at, and nothing is hidden in them.
  void layer(std::span<const VoxelRun> runs, std::span<const std::uint8_t> active,
             Occluders occluders);

  std::span<const Verdict> verdicts() const { return verdicts_; }  // of the last layer
  // The observations and the positions of the last layer's coloured voxels.
  const std::vector<VoxelObservation>& observations() const { return observations_; }
  const std::vector<VoxelPosition>& colored() const { return colored_; }

private:
  struct Block;
  struct Part;
  Verdict classify_voxel(const VoxelObservation& seen) const;
  double limit(std::int64_t pixels) const;
  VoxelObservation look_up(const VoxelRun& run, int i) const;
  bool is_background(const VoxelBox& box) const;
  void find_undecided(const VoxelBox& box, std::vector<std::size_t>& open) const;
  void classify_runs(std::span<const VoxelRun> runs, std::size_t first_run, Block& block);
  void classify_part(const Part& part, Block& block);
  static void put_in_order(Block& block);
  void classify_voxels(const VoxelRun& run, std::size_t at, Block& block, Occluders occluders);
  void add_colored(const VoxelRun& run, int i, const VoxelObservation& seen, Block& block) const;
  Rgba8 mean_color(const VoxelRun& run, int i, const VoxelObservation& seen) const;
  void classify_layer(std::span<const VoxelRun> runs, Occluders occluders);
  void hide_layer(std::span<const VoxelRun> runs, Occluders occluders);
  void hide(std::size_t picture, const RowPicture& row, int place);

  const VoxelGrid& grid_;
  std::vector<PackedPicture>& pictures_;
  const ColoringSettings& settings_;
  std::vector<GridPicture> lenses_;
  // The order in which pictures are looked at: different directions of view come early.
  std::vector<std::size_t> order_;
  std::vector<std::size_t> active_;  // those of order_ that are active
  const std::vector<double>& ratios_;
  std::vector<PixelTiles> tiles_;
  float most_deviations_ = 0;
  std::vector<Verdict> verdicts_;
  std::vector<std::size_t> first_of_run_;
  std::vector<VoxelPosition> colored_;
  std::vector<VoxelObservation> observations_;
};

}  // namespace glassbox::views
