// Voxel colouring as beginners first write it, and with steps that are easily forgotten: a loop
// over voxels in layers along z. The colour of a voxel in a picture is that of the pixel that shows
// the voxel's centre.
#pragma once

#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "views/voxels/coloring.h"
#include "views/voxels/footprint.h"

namespace glassbox::study::naive {

// The steps of the loop. Each member has the right value, unless a mutant (deliberately wrong code)
// changes it.
struct SweepRules {
  bool hides = true;             // coloured voxels hide those behind them
  bool nearest_first = true;     // visits the layers in order of distance from the cameras
  bool asks_masks = true;        // rejects voxels that project to the background
  bool below = true;             // true: accepts sigma < T; false: sigma <= T (T is the threshold)
  std::int64_t least_views = 2;  // voxels that fewer views see are left out
};

using VoxelKeys = std::set<std::uint64_t>;

inline VoxelKeys colored_by(const views::PictureSet& set, const views::ColoringRequest& request,
                            const SweepRules& way) {
  const views::VoxelGrid grid =
      views::grid_of(request.box, request.voxel_size, views::Matrix3d::Identity()).value();
  std::vector<std::vector<std::uint8_t>> hidden;
  for (const views::CalibratedPicture& picture : set.pictures)
    hidden.emplace_back(picture.color.pixels.size(), 0);
  VoxelKeys colored;
  for (int k = 0; k < grid.count[2]; ++k) {
    const int z = way.nearest_first ? k : grid.count[2] - 1 - k;
    std::vector<std::uint8_t*> hides;
    for (int y = 0; y < grid.count[1]; ++y) {
      for (int x = 0; x < grid.count[0]; ++x) {
        views::ColorSums sums;
        bool is_background = false;
        std::vector<std::uint8_t*> pixels;
        for (std::size_t p = 0; p < set.pictures.size(); ++p) {
          const views::CalibratedPicture& picture = set.pictures[p];
          const views::Vector3d at = views::project(picture.camera, grid.centre({x, y, z}));
          const int column = int(std::floor(at.x())), row = int(std::floor(at.y()));
          if (column < 0 || row < 0 || column >= picture.color.width || row >= picture.color.height)
            continue;
          const bool has_mask = way.asks_masks && !picture.matte.pixels.empty();
          is_background = is_background || (has_mask && picture.matte.at(column, row) == 0);
          pixels.push_back(&hidden[p][std::size_t(row) * std::size_t(picture.color.width) +
                                      std::size_t(column)]);
          if (*pixels.back() != 0) continue;
          const Rgba8& color = picture.color.at(column, row);
          sums.add(color.r, color.g, color.b);
        }
        if (is_background || sums.count < way.least_views) continue;
        const double sigma = std::sqrt(sums.variance()), most = request.settings.threshold;
        if (way.below ? !(sigma < most) : !(sigma <= most)) continue;
        colored.insert(views::key_of({x, y, z}));
        hides.insert(hides.end(), pixels.begin(), pixels.end());
      }
    }
    if (!way.hides) continue;
    for (std::uint8_t* pixel : hides) *pixel = 1;
  }
  return colored;
}

}  // namespace glassbox::study::naive
