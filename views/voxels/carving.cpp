#include "views/voxels/carving.h"

#include <algorithm>
#include <cmath>

#include "views/voxels/blocks.h"
#include "views/voxels/voxel_layers.h"

namespace glassbox::views {

namespace {

// One bit for each voxel: set if it has not been carved.
class Solid {
public:
  explicit Solid(const VoxelGrid& grid)
      : count_(grid.count), bits_(std::size_t(grid.voxels() + 63) / 64, ~std::uint64_t(0)) {}
  bool has(const VoxelPosition& at) const {
    return (bits_[index(at) / 64] >> (index(at) % 64) & 1) != 0;
  }
  bool is_in(const VoxelPosition& at) const {
    return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < count_[0] && at.y < count_[1] &&
           at.z < count_[2];
  }
  void carve(const VoxelPosition& at) {
    bits_[index(at) / 64] &= ~(std::uint64_t(1) << index(at) % 64);
  }
  // Whether at least one of the six neighbouring voxels is carved or outside of the grid.
  bool is_boundary(const VoxelPosition& at) const {
    for (const VoxelPosition& beside :
         {VoxelPosition{at.x - 1, at.y, at.z}, VoxelPosition{at.x + 1, at.y, at.z},
          VoxelPosition{at.x, at.y - 1, at.z}, VoxelPosition{at.x, at.y + 1, at.z},
          VoxelPosition{at.x, at.y, at.z - 1}, VoxelPosition{at.x, at.y, at.z + 1}}) {
      if (!is_in(beside) || !has(beside)) return true;
    }
    return false;
  }
  // The parts of these runs that have not been carved.
  std::vector<VoxelRun> remaining(const std::vector<VoxelRun>& runs) const {
    std::vector<VoxelRun> left;
    for (const VoxelRun& run : runs) {
      for (int i = 0; i < run.count;) {
        if (!has(run.at(i))) {
          ++i;
          continue;
        }
        const int begin = i;
        while (i < run.count && has(run.at(i))) ++i;
        left.push_back({run.at(begin), run.axis, i - begin});
      }
    }
    return left;
  }

private:
  std::size_t index(const VoxelPosition& at) const { return voxel_index(count_, at); }
  std::array<int, 3> count_;
  std::vector<std::uint64_t> bits_;
};

bool is_carved(Verdict verdict) {
  return verdict == Verdict::kBackground || verdict == Verdict::kInconsistent;
}

// Sweeps once, in one direction. Returns how many voxels it carves.
std::int64_t sweep_once(const VoxelGrid& grid, std::vector<PackedPicture>& pictures,
                        const ColoringRequest& request, const std::vector<double>& ratios,
                        std::array<int, 2> direction, Solid& solid, std::int64_t& examined) {
  for_blocks(pictures.size(), request.settings.threads,
             [&](std::size_t i) { clear_hidden(pictures[i]); });
  Sweep sweep(grid, pictures, request.settings, ratios);
  const PlaneLayers planes(grid, direction);
  std::vector<double> along;  // coordinates of the eyes along the direction, in voxels
  for (const PackedPicture& picture : pictures)
    along.push_back(grid.coordinates(picture.eye)[direction[0]]);
  std::vector<std::uint8_t> active(pictures.size());
  std::int64_t carved = 0;
  for (int k = 0; k < planes.count(); ++k) {
    const int place = planes.coordinate(k);
    for (std::size_t i = 0; i < active.size(); ++i)
      active[i] = direction[1] > 0 ? along[i] <= place : along[i] >= place + 1;
    if (std::ranges::find(active, 1) == active.end()) continue;
    const std::vector<VoxelRun> runs = solid.remaining(planes.runs(k, request.box));
    sweep.layer(runs, active, Occluders::kNotCarved);
    std::size_t at = 0;
    for (const VoxelRun& run : runs) {
      for (int i = 0; i < run.count; ++i, ++at) {
        if (!is_carved(sweep.verdicts()[at])) continue;
        solid.carve(run.at(i));
        ++carved;
      }
    }
    examined += std::int64_t(at);
  }
  return carved;
}

// What the pictures show of a voxel at the surface.
struct SurfaceSum {
  ColorSums sums;
  double rgb[3] = {0, 0, 0};
};

std::vector<VoxelPosition> boundary_of(const VoxelGrid& grid, const Solid& solid) {
  std::vector<VoxelPosition> boundary;
  const PlaneLayers planes(grid, {2, 1});
  for (int k = 0; k < planes.count(); ++k) {
    for (const VoxelRun& run : solid.remaining(planes.runs(k, {}))) {
      for (int i = 0; i < run.count; ++i)
        if (solid.is_boundary(run.at(i))) boundary.push_back(run.at(i));
    }
  }
  return boundary;
}

// For each pixel, the distance of the nearest of these voxels.
std::vector<float> depths_of(const VoxelGrid& grid, const PackedPicture& picture,
                             const std::vector<VoxelPosition>& voxels) {
  const GridPicture lens = grid_picture(grid, picture);
  std::vector<float> depths(picture.words.size(), INFINITY);
  for (const VoxelPosition& at : voxels) {
    const Projected centre = centre_of(lens, at);
    for_each_pixel(lens, centre, Footprint::kBox, [&](int x, int y) {
      float& depth = depths[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
      depth = std::min(depth, centre.w);
    });
  }
  return depths;
}

// Gives each voxel at the surface the mean colour of the pictures that see it. A picture sees a
// voxel if nothing at the pixel of the voxel's centre is nearer by more than the voxel's diagonal.
void color_boundary(std::vector<PackedPicture>& pictures, const ColoringRequest& request,
                    const Solid& solid, Coloring& result) {
  const VoxelGrid& grid = result.grid;
  const std::vector<VoxelPosition> boundary = boundary_of(grid, solid);
  std::vector<SurfaceSum> all(boundary.size());
  const float diagonal = float(grid.size * std::sqrt(3.0));
  for (const PackedPicture& picture : pictures) {
    const std::vector<float> depths = depths_of(grid, picture, boundary);
    const GridPicture lens = grid_picture(grid, picture);
    constexpr std::size_t kOfBlock = 4096;
    for_blocks((boundary.size() + kOfBlock - 1) / kOfBlock, request.settings.threads,
               [&](std::size_t block) {
                 for (std::size_t i = block * kOfBlock;
                      i < std::min((block + 1) * kOfBlock, boundary.size()); ++i) {
                   const VoxelPosition& at = boundary[i];
                   const Projected centre = centre_of(lens, at);
                   const PixelPosition pixel = centre_pixel(centre, lens.width, lens.height);
                   if (pixel.column < 0) continue;
                   const std::size_t index = std::size_t(pixel.row) * std::size_t(picture.width) +
                                             std::size_t(pixel.column);
                   if (centre.w > depths[index] + diagonal) continue;
                   const std::uint32_t word = picture.words[index];
                   if ((word & kBackground) != 0) continue;
                   add_word(all[i].sums, word);
                   const auto [a, b, c] = channels_of(word);
                   const bool is_rgb = picture.rgb.empty();
                   all[i].rgb[0] += is_rgb ? double(a) / kCodesPerLevel : picture.rgb[index].r;
                   all[i].rgb[1] += is_rgb ? double(b) / kCodesPerLevel : picture.rgb[index].g;
                   all[i].rgb[2] += is_rgb ? double(c) / kCodesPerLevel : picture.rgb[index].b;
                 }
               });
  }
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const auto& [sums, rgb] = all[i];
    if (sums.count == 0) {
      ++result.counts[std::size_t(Verdict::kHidden)];
      continue;
    }
    ++result.counts[std::size_t(Verdict::kColored)];
    const auto mean = [count = double(sums.count)](double sum) {
      return std::uint8_t(std::floor(sum / count + 0.5));
    };
    result.voxels.push_back({boundary[i],
                             {mean(rgb[0]), mean(rgb[1]), mean(rgb[2]), 255},
                             std::uint16_t(sums.count),
                             float(std::sqrt(sums.variance()) / kCodesPerLevel)});
  }
}

}  // namespace

double carving_bytes(const VoxelGrid& grid, double surface) {
  // A bit for each voxel, one or more runs for each row of voxels, the indices of a layer's
  // occluders, and the surface's voxels.
  const auto [nx, ny, nz] = grid.count;
  const double layer = std::max({double(nx) * ny, double(ny) * nz, double(nz) * nx});
  return double(grid.voxels()) / 8 + double(ny) * nz * sizeof(VoxelRun) +
         layer * double(sizeof(std::size_t) * 2) +
         surface * double(sizeof(VoxelPosition) + sizeof(SurfaceSum));
}

void carve(std::vector<PackedPicture>& pictures, const ColoringRequest& request, Coloring& result) {
  constexpr std::array<std::array<int, 2>, 6> kDirections{
      {{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}}};
  Solid solid(result.grid);
  const std::vector<double> ratios = likelihood_ratios(request.settings);
  result.is_finished = false;
  for (; !result.is_finished && result.passes < request.most_passes; ++result.passes) {
    std::int64_t carved = 0;
    for (const std::array<int, 2>& direction : kDirections) {
      carved +=
          sweep_once(result.grid, pictures, request, ratios, direction, solid, result.examined);
      result.layers += result.grid.count[std::size_t(direction[0])];
    }
    result.is_finished = carved == 0;
  }
  color_boundary(pictures, request, solid, result);
  const PlaneLayers planes(result.grid, {2, 1});
  for (int k = 0; k < planes.count(); ++k) {
    for (const VoxelRun& run : solid.remaining(planes.runs(k, {}))) result.solid.push_back(run);
  }
}

}  // namespace glassbox::views
