// A flat scene: cameras so far away that a voxel (x, y, z) of size 1 is seen at the pixel
// (x - slope z + beside, y).
#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "views/voxels/coloring.h"
#include "views/voxels/voxel_layers.h"

namespace glassbox::views::test {

constexpr double kFar = 0x1p20;

inline PinholeCamera flat_camera(double slope, double beside) {
  PinholeCamera camera;
  // f X / Z + cx with X = x + f slope and Z = z + f is x - slope z up to x z / f, 1e-3 px here. A
  // voxel's centre is half a voxel deep.
  camera.intrinsic << kFar, 0, beside + slope / 2 - kFar * slope, 0, kFar, 0, 0, 0, 1;
  camera.centre = {-kFar * slope, 0, -kFar};
  return camera;
}

struct FlatScene {
  PictureSet set;
  ColoringRequest request;
};

// A box of n x height x depth voxels, seen by cameras with these slopes; all pixels are background
// until paint() is called.
inline FlatScene make_flat_scene(int n, int height, int depth, const std::vector<double>& slopes) {
  FlatScene flat;
  for (const double slope : slopes) {
    const int width = n + 2 * depth + 2;
    const PinholeCamera camera = flat_camera(slope, depth + 1);
    flat.set.pictures.push_back(
        {"", camera, Image<Rgba8>(width, height), Image<std::uint8_t>(width, height, 0)});
  }
  flat.request.box = {{0, 0, 0}, {double(n), double(height), double(depth)}};
  flat.request.voxel_size = 1;
  ColoringSettings& settings = flat.request.settings;
  settings.threshold = 1;
  settings.sampled = settings.hidden = Footprint::kCentre;
  settings.threads = 1;
  return flat;
}

inline VoxelGrid grid_of_flat(const FlatScene& flat) {
  return grid_of(flat.request.box, flat.request.voxel_size, Matrix3d::Identity()).value();
}

// The pixel of a voxel's centre.
inline PixelPosition pixel_of(const FlatScene& flat, std::size_t picture, const VoxelPosition& at) {
  const Vector3d p = project(flat.set.pictures[picture].camera, grid_of_flat(flat).centre(at));
  return {int(std::floor(p.x())), int(std::floor(p.y()))};
}

// Makes the pictures that the cameras see of these voxels: the nearest voxel in each pixel.
inline void paint(FlatScene& flat, std::vector<ColoredVoxel> voxels) {
  std::ranges::sort(voxels, [](const auto& a, const auto& b) { return a.at.z > b.at.z; });
  for (std::size_t p = 0; p < flat.set.pictures.size(); ++p) {
    CalibratedPicture& picture = flat.set.pictures[p];
    std::ranges::fill(picture.matte.pixels, std::uint8_t(0));
    std::ranges::fill(picture.color.pixels, Rgba8{0, 0, 0, 255});
    for (const ColoredVoxel& voxel : voxels) {
      const PixelPosition pixel = pixel_of(flat, p, voxel.at);
      picture.color.at(pixel.column, pixel.row) = voxel.color;
      picture.matte.at(pixel.column, pixel.row) = 255;
    }
  }
}

using VoxelTuple = std::tuple<int, int, int>;
inline std::set<VoxelTuple> positions_of(const std::vector<ColoredVoxel>& voxels) {
  std::set<VoxelTuple> positions;
  for (const ColoredVoxel& voxel : voxels) positions.emplace(voxel.at.x, voxel.at.y, voxel.at.z);
  return positions;
}

inline ColoredVoxel colored_voxel(int x, int y, int z, Rgba8 color) {
  return {{x, y, z}, color, 0, 0};
}

constexpr Rgba8 kRed{200, 30, 20, 255}, kBlue{20, 40, 220, 255};

}  // namespace glassbox::views::test
