// Cameras, pictures and scenes for voxel colouring with known results.
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/scenes.h>

#include "views/rings/draw_ring.h"
#include "views/voxels/coloring.h"
#include "views/voxels/draw_voxels.h"
#include "views/voxels/truth.h"

namespace glassbox::views::test {

// A camera at `centre` that looks along z, with a focal length in pixels.
inline PinholeCamera camera_along_z(const Vector3d& centre, double focal, int width, int height) {
  PinholeCamera camera;
  camera.intrinsic << focal, 0, width / 2.0, 0, focal, height / 2.0, 0, 0, 1;
  camera.centre = centre;
  return camera;
}

// A sphere of radius 1 whose corners have their own colours, which light does not change: textured,
// convex and closed.
inline Scene speckled_sphere(int level, std::uint64_t seed) {
  Scene scene = *make_builtin("sphere:" + std::to_string(level));
  Random random(seed);
  for (Mesh& mesh : scene.meshes) {
    mesh.colors.clear();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const auto light = [&] { return float(random.between(0.02, 0.9)); };
      mesh.colors.push_back({light(), light(), light(), 1});
    }
    for (Corner& corner : mesh.corners) corner.color = corner.position;
  }
  for (Material& material : scene.materials) {
    material.unlit = true;
    material.base_color = {1, 1, 1, 1};
  }
  return scene;
}

inline PictureSet ring_of(const Scene& scene, const RingOptions& options) {
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  settings.background = {0, 0, 0, 255};
  return draw_ring(scene, ring_views(scene, options).value(), settings, Matte::kDepth);
}

// The size of a voxel that is one pixel wide where the box is nearest to a camera of the ring.
inline double pixel_size(const PictureSet& set) {
  const Vector3d middle = (set.box->low + set.box->high) / 2;
  double size = INFINITY;
  for (const CalibratedPicture& picture : set.pictures) {
    const double distance =
        (picture.camera.centre - middle).norm() - (set.box->high - set.box->low).maxCoeff() / 2;
    size = std::min(size, distance / picture.camera.intrinsic(0, 0));
  }
  return size;
}

// Pictures of coloured voxels, exactly as the cameras see them.
inline PictureSet pictures_of(const VoxelGrid& grid, const std::vector<ColoredVoxel>& voxels,
                              const std::vector<PinholeCamera>& cameras, int width, int height) {
  PictureSet set;
  for (const PinholeCamera& camera : cameras) {
    const VoxelPicture drawn = draw_voxels(grid, voxels, camera, width, height, {0, 0, 0, 255});
    CalibratedPicture picture{"", camera, drawn.color, {width, height, 0}};
    for (std::size_t i = 0; i < picture.matte.pixels.size(); ++i)
      picture.matte.pixels[i] = std::isfinite(drawn.distance.pixels[i]) ? 255 : 0;
    set.pictures.push_back(std::move(picture));
  }
  return set;
}

inline ColoringRequest request_for(const PictureSet& set, double size) {
  ColoringRequest request;
  request.box = *set.box;
  request.voxel_size = size;
  request.settings.threads = 1;
  // The colours of the speckles vary by about ten levels within a pixel.
  request.settings.threshold = 30;
  return request;
}

inline RingOptions ring_options(int views, std::vector<double> elevations, int size) {
  RingOptions options;
  options.views = views;
  options.elevations = std::move(elevations);
  options.width = options.height = size;
  return options;
}

inline double iou_of(const Scene& scene, const PictureSet& set, const ColoringRequest& request,
                     Coloring* result = nullptr) {
  const VoxelGrid grid = plan_coloring(set, request).value().grid;
  const TrueVolume truth(scene, grid);
  Overlap overlap(truth);
  Coloring coloring = color_voxels(set, request, [&](int, auto runs, auto verdicts) {
                        overlap.add(runs, verdicts);
                      }).value();
  for (const VoxelRun& run : coloring.solid) overlap.add(run);
  if (result != nullptr) *result = std::move(coloring);
  return overlap.iou();
}

}  // namespace glassbox::views::test
