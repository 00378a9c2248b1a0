// A scene for voxel colouring with cameras so far away that they are almost parallel: voxel (x, y,
// z) of size 1 is seen in pixel (x - slope z + beside, y), so every right answer can be written
// down.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <vector>

#include "study/extremes/common/outcome.h"
#include "views/voxels/coloring.h"
#include "views/voxels/footprint.h"

namespace glassbox::study {

// The distance of the cameras f in voxels. At this distance, perspective moves the picture by about
// 1e-3 px in a thousand voxels.
inline constexpr double kFlatFar = 0x1p20;

struct FlatScene {
  views::PictureSet set;
  views::ColoringRequest request;
};

inline views::PinholeCamera flat_camera(double slope, double beside) {
  views::PinholeCamera camera;
  // The pixel column is f X / Z + cx, with f = kFlatFar, X = x + f slope and Z = z + f. The
  // constant cx contains slope / 2 because a voxel's centre is half a voxel deep.
  camera.intrinsic << kFlatFar, 0, beside + slope / 2 - kFlatFar * slope, 0, kFlatFar, 0, 0, 0, 1;
  camera.centre = {-kFlatFar * slope, 0, -kFlatFar};
  return camera;
}

// A box of n x height x depth voxels, seen by cameras with these slopes. Everything is background
// until it is painted.
inline FlatScene make_flat_scene(int n, int height, int depth, const std::vector<double>& slopes) {
  FlatScene flat;
  for (const double slope : slopes) {
    const int width = n + 2 * depth + 2;
    flat.set.pictures.push_back({"", flat_camera(slope, depth + 1), Image<Rgba8>(width, height),
                                 Image<std::uint8_t>(width, height, 0)});
  }
  flat.request.box = {{0, 0, 0}, {double(n), double(height), double(depth)}};
  flat.request.voxel_size = 1;
  views::ColoringSettings& settings = flat.request.settings;
  settings.threshold = 1;
  settings.sampled = settings.hidden = views::Footprint::kCentre;
  settings.threads = 1;
  return flat;
}

inline views::PixelPosition flat_pixel(const FlatScene& flat, std::size_t picture,
                                       const views::VoxelPosition& at) {
  const views::Vector3d p =
      views::project(flat.set.pictures[picture].camera, {at.x + 0.5, at.y + 0.5, at.z + 0.5});
  return {int(std::floor(p.x())), int(std::floor(p.y()))};
}

// Paints these voxels, which have a single colour, into all pictures; the order does not matter
// because hidden voxels have the same colour.
inline void paint(FlatScene& flat, const std::vector<views::VoxelPosition>& voxels, Rgba8 color) {
  for (std::size_t p = 0; p < flat.set.pictures.size(); ++p) {
    views::CalibratedPicture& picture = flat.set.pictures[p];
    for (const views::VoxelPosition& voxel : voxels) {
      const views::PixelPosition pixel = flat_pixel(flat, p, voxel);
      picture.color.at(pixel.column, pixel.row) = color;
      picture.matte.at(pixel.column, pixel.row) = 255;
    }
  }
}

using VoxelKeys = std::set<std::uint64_t>;  // the key_of each voxel

inline VoxelKeys keys_of(const std::vector<views::VoxelPosition>& voxels) {
  VoxelKeys keys;
  for (const views::VoxelPosition& voxel : voxels) keys.insert(views::key_of(voxel));
  return keys;
}

// A function that finds the coloured voxels of a scene: our own code or a plain sweep.
using Colorer = VoxelKeys (*)(const FlatScene& flat);

inline VoxelKeys colored_by_ours(const FlatScene& flat) {
  VoxelKeys keys;
  const auto coloring = views::color_voxels(flat.set, flat.request);
  if (!coloring) return keys;
  for (const views::ColoredVoxel& voxel : coloring->voxels) keys.insert(views::key_of(voxel.at));
  return keys;
}

// The number of voxels that only one of the two sets contains.
inline int differing(const VoxelKeys& a, const VoxelKeys& b) {
  std::vector<std::uint64_t> differ;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(differ));
  return int(differ.size());
}

}  // namespace glassbox::study
