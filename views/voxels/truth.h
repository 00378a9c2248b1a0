// The truth about a scene from which pictures were made: which voxels are inside it, and which
// points of its surface the pictures see.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/voxels/coloring.h"

namespace glassbox::views {

// One bit for each voxel: whether its centre is inside a closed surface of the scene. Lines along z
// through the centres are intersected with the triangles; a point is inside if its winding number
// along the line is not 0. Surfaces that are not closed have no inside.
class TrueVolume {
public:
  TrueVolume(const Scene& scene, const VoxelGrid& grid);
  bool has(const VoxelPosition& at) const {
    const std::size_t i = voxel_index(count_, at);
    return (bits_[i / 64] >> (i % 64) & 1) != 0;
  }
  std::int64_t voxels() const { return voxels_; }

  // Bytes for its bits and, during construction, a list of crossings for each line of voxels.
  static double bytes_for(const VoxelGrid& grid);

private:
  std::array<int, 3> count_;
  std::vector<std::uint64_t> bits_;
  std::int64_t voxels_ = 0;
};

// The overlap of the true solid A and a found solid B, |A and B| / |A or B| in numbers of voxels. B
// is added voxel by voxel, or run by run.
class Overlap {
public:
  explicit Overlap(const TrueVolume& truth) : truth_(truth) {}
  void add(const VoxelPosition& at) {
    ++found_;
    both_ += truth_.has(at);
  }
  void add(const VoxelRun& run);
  // Adds those voxels of a layer that a sweep did not prove to be empty.
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

// Points of the true surface: for each pixel of each picture, the point that it shows. In grid
// coordinates.
struct VisibleSurface {
  std::vector<Vector3d> in_one_picture;   // seen by at least one picture
  std::vector<Vector3d> in_two_pictures;  // seen by at least two
};
// `distances` has the engine's distances along the direction of view for each picture. Two pictures
// see the same point if their distances agree to within a voxel's diagonal.
VisibleSurface visible_surface(const PictureSet& set, const std::vector<Image<float>>& distances,
                               const VoxelGrid& grid);

// The distances of the pictures, drawn from the scene.
Result<std::vector<Image<float>>> true_distances(const Scene& scene, const PictureSet& set);

struct SurfaceErrors {
  // In voxels: from a coloured voxel's centre to the nearest visible point of the true surface
  // (to_truth), and from a point that two pictures see to the nearest centre (from_truth).
  double to_truth_mean = 0, to_truth_most = 0, from_truth_mean = 0, from_truth_most = 0;
  double hausdorff() const { return std::max(to_truth_most, from_truth_most); }
};
// Bytes that true_distances, visible_surface and surface_errors need together for this many
// coloured voxels.
double surface_error_bytes(const PictureSet& set, double voxels);
// Distances are infinite if there is nothing to measure to.
SurfaceErrors surface_errors(const std::vector<ColoredVoxel>& voxels,
                             const VisibleSurface& surface);

}  // namespace glassbox::views
