#include <fmt/format.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/flat_scene.h"
#include "study/naive/voxels.h"

namespace glassbox::study {
namespace c92 {

constexpr int kSide = 40, kDepth = 30;

FlatScene disc() {
  FlatScene flat = make_flat_scene(kSide, 1, kDepth, {-1, 1});
  std::vector<views::VoxelPosition> voxels;
  for (int z = 0; z < kDepth; ++z) {
    for (int x = 0; x < kSide; ++x) {
      const double dx = x - 19.5, dz = z - 14.5;
      if (dx * dx + dz * dz < 8 * 8) voxels.push_back({x, 0, z});
    }
  }
  paint(flat, voxels, {20, 40, 220, 255});
  flat.request.settings.alone = views::SingleViewPolicy::kKeep;
  return flat;
}

// All voxels have one colour, so all of them are consistent. The hull is the set of voxels that
// both pictures show as object; the result is its surface, the voxels that are nearest on a line of
// sight of one of the pictures.
naive::VoxelKeys photo_hull(const FlatScene& flat) {
  std::set<int> taken[2];
  naive::VoxelKeys hull;
  for (int z = 0; z < kDepth; ++z) {
    std::vector<int> columns[2];
    for (int x = 0; x < kSide; ++x) {
      int column[2];
      bool is_in = true, is_seen = false;
      for (std::size_t p = 0; p < 2; ++p) {
        column[p] = flat_pixel(flat, p, {x, 0, z}).column;
        is_in = is_in && flat.set.pictures[p].matte.at(column[p], 0) != 0;
        is_seen = is_seen || !taken[p].contains(column[p]);
      }
      if (!is_in || !is_seen) continue;
      hull.insert(views::key_of({x, 0, z}));
      for (std::size_t p = 0; p < 2; ++p) columns[p].push_back(column[p]);
    }
    for (std::size_t p = 0; p < 2; ++p) taken[p].insert(columns[p].begin(), columns[p].end());
  }
  return hull;
}

Outcome measure_error(Colorer colored_by) {
  const FlatScene flat = disc();
  const naive::VoxelKeys hull = photo_hull(flat);
  const int wrong = differing(colored_by(flat), hull);
  return must_be_zero(
      wrong, fmt::format("{} voxels are missing or too many; the hull has {}", wrong, hull.size()));
}

template <naive::SweepRules kWay>
naive::VoxelKeys plain(const FlatScene& flat) {
  return naive::colored_by(flat.set, flat.request, kWay);
}

}  // namespace c92

ExtremeCase c92_untextured() {
  using namespace c92;
  return {
      .id = "C-92",
      .name = "An object of one colour",
      .construction = "a disc with a radius of 8 voxels, seen by cameras of slopes -1 and 1",
      .stage = "voxels",
      .right_answer =
          "the result is the photo hull (S1-32), which is larger than the disc on the cameras' "
          "side: the part nearest to the cameras of the diamond that both outlines allow",
      .unit = "voxels",
      .oracle = Oracle::kAnalytic,
      .ours = {"voxel colouring that keeps voxels seen in only one picture",
               [] { return measure_error(colored_by_ours); }},
      .naive = {"all voxels that both outlines allow are coloured",
                [] {
                  return measure_error(plain<naive::SweepRules{.hides = false, .least_views = 1}>);
                }},
      .mutants = {{"the layers are visited from far to near",
                   [] {
                     return measure_error(
                         plain<naive::SweepRules{.nearest_first = false, .least_views = 1}>);
                   }},
                  {"the background is a colour like any other",
                   [] {
                     return measure_error(
                         plain<naive::SweepRules{.asks_masks = false, .least_views = 1}>);
                   }}},
      .not_drawn = "the case reconstructs a shape from given pictures; no engine draws the result",
  };
}

}  // namespace glassbox::study
