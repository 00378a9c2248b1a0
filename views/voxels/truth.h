// What a scene really is, for pictures that were made from it: which voxels are inside it, and which points of its surface the
// pictures see.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/voxels/coloring.h"

namespace glassbox::views {

// One bit for each voxel: its centre is inside a closed surface of the scene. Lines along z through the centres are cut with the
// triangles; where they wind around a place other than 0 times, it is inside. Surfaces that are not closed have no inside.
class TrueVolume {
public:
  TrueVolume(const Scene& scene, const VoxelGrid& grid);
  bool has(const VoxelAt& at) const {
    const std::size_t i = voxel_index(count_, at);
    return (bits_[i / 64] >> (i % 64) & 1) != 0;
  }
  std::int64_t voxels() const { return voxels_; }

  // Its bits, and while it is made a list of crossings for each line of voxels.
  static double bytes_for(const VoxelGrid& grid);

private:
  std::array<int, 3> count_;
  std::vector<std::uint64_t> bits_;
  std::int64_t voxels_ = 0;
};

// How much two solids have in common: |A and B| / |A or B|. A solid is fed voxel by voxel, or run by run.
class Overlap {
public:
  explicit Overlap(const TrueVolume& truth) : truth_(truth) {}
  void add(const VoxelAt& at) {
    ++found_;
    both_ += truth_.has(at);
  }
  void add(const VoxelRun& run);
  // Those voxels of a layer that a sweep did not prove to be empty.
  void add(std::span<const VoxelRun> runs, std::span<const Verdict> verdicts);
  double iou() const {
    const std::int64_t either = found_ + truth_.voxels() - both_;
    return either == 0 ? 1 : double(both_) / double(either);
  }
  std::int64_t found() const { return found_; }

private:
  const TrueVolume& truth_;
  std::int64_t found_ = 0, both_ = 0;
};

// Points of the true surface: of each pixel of each picture, that which it shows. Grid coordinates.
struct SeenSurface {
  std::vector<Vector3d> once;   // seen by at least one picture
  std::vector<Vector3d> twice;  // seen by at least two
};
// `distances`: of each picture, along the gaze, as the engine has them. Two pictures see the same point where their distances agree
// within a voxel's diagonal.
SeenSurface seen_surface(const PictureSet& set, const std::vector<Image<float>>& distances,
                         const VoxelGrid& grid);

// The pictures' distances, drawn from the scene.
Result<std::vector<Image<float>>> true_distances(const Scene& scene, const PictureSet& set);

struct SurfaceErrors {
  // Voxels. From a coloured voxel's centre to the nearest point of the true surface that is seen, and from a point that two pictures
  // see to the nearest centre.
  double to_truth_mean = 0, to_truth_most = 0, from_truth_mean = 0, from_truth_most = 0;
  double hausdorff() const { return std::max(to_truth_most, from_truth_most); }
};
// What true_distances, seen_surface and surface_errors take together with so many coloured voxels.
double surface_error_bytes(const PictureSet& set, double voxels);
// Infinite where there is nothing to measure to.
SurfaceErrors surface_errors(const std::vector<ColoredVoxel>& voxels, const SeenSurface& surface);

}  // namespace glassbox::views
