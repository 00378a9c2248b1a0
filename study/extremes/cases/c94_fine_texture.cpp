#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/flat_scene.h"
#include "study/naive/voxels.h"

namespace glassbox::study {
namespace c94 {

// A wall of voxels, each of which covers two by two pixels of a checkerboard.
Outcome measure_error(const views::ColoringSettings& asked) {
  FlatScene flat = make_flat_scene(16, 16, 4, {-2, 0, 2});
  for (views::CalibratedPicture& picture : flat.set.pictures) {
    picture.matte = {};
    for (int y = 0; y < picture.color.height; ++y)
      for (int x = 0; x < picture.color.width; ++x)
        picture.color.at(x, y) = (x + y) % 2 == 0 ? Rgba8{255, 255, 255, 255} : Rgba8{0, 0, 0, 255};
  }
  flat.request.voxel_size = 2;
  views::ColoringSettings& settings = flat.request.settings;
  settings = asked;
  settings.sampled = settings.hidden = views::Footprint::kBox;
  settings.threads = 1;
  std::vector<views::VoxelPosition> wall;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) wall.push_back({x, y, 0});
  const naive::VoxelKeys first = keys_of(wall);
  const auto coloring = views::color_voxels(flat.set, flat.request);
  if (!coloring) return wrong_count_outcome(64, 64, "voxels of the wall are wrong");
  naive::VoxelKeys found;
  for (const views::ColoredVoxel& voxel : coloring->voxels)
    if (voxel.at.z == 0) found.insert(views::key_of(voxel.at));
  return wrong_count_outcome(differing(found, first), 64, "voxels of the wall are wrong");
}

views::ColoringSettings fixed(double threshold) {
  views::ColoringSettings settings;
  settings.threshold = threshold;
  return settings;
}
views::ColoringSettings adaptive(double k1) {
  views::ColoringSettings settings;
  settings.consistency = views::Consistency::kAdaptive;
  settings.k1 = k1;
  settings.k2 = 10;
  return settings;
}

}  // namespace c94

ExtremeCase c94_fine_texture() {
  using namespace c94;
  return {
      .id = "C-94",
      .name = "A texture as fine as the voxels",
      .construction =
          "a wall of 8 x 8 voxels, each of 2 x 2 pixels of a checker board, seen by three cameras",
      .stage = "voxels",
      .right_answer =
          "the wall is found, because the colours of a voxel differ within a picture as much as "
          "between pictures (S1-34)",
      .unit = "voxels",
      .oracle = Oracle::kProperty,
      .ours = {"sigma < M + 10", [] { return measure_error(adaptive(1)); }},
      .naive = {"sigma < 40", [] { return measure_error(fixed(40)); }},
      .mutants = {{"sigma < 100", [] { return measure_error(fixed(100)); }},
                  {"sigma < M/2 + 10", [] { return measure_error(adaptive(0.5)); }}},
      .not_drawn = "the case reconstructs a shape from given pictures; no engine draws the result",
  };
}

}  // namespace glassbox::study
