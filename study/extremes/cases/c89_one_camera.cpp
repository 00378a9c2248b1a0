#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/flat_scene.h"
#include "study/naive/voxels.h"

namespace glassbox::study {
namespace c89 {

// Tests scenes with one camera, which always agrees with itself, and with two cameras at the same
// place.
Outcome measure_error(Colorer colored_by) {
  FlatScene one = make_flat_scene(6, 1, 5, {0});
  paint(one, {{2, 0, 3}, {4, 0, 1}}, {200, 30, 20, 255});
  const int alone = int(colored_by(one).size());
  FlatScene twins = one;
  twins.set.pictures.push_back(one.set.pictures.front());
  const int beside = differing(colored_by(twins), keys_of({{2, 0, 0}, {4, 0, 0}}));
  return must_be_zero(alone + beside,
                      fmt::format("{} voxels are coloured from one picture; with two equal "
                                  "cameras, {} coloured voxels are not in the first layer",
                                  alone, beside));
}

template <naive::SweepRules kWay>
naive::VoxelKeys plain(const FlatScene& flat) {
  return naive::colored_by(flat.set, flat.request, kWay);
}

}  // namespace c89

ExtremeCase c89_one_camera() {
  using namespace c89;
  return {
      .id = "C-89",
      .name = "One camera, and the same one twice",
      .construction =
          "two voxels at different depths, seen by one camera, and by two cameras at the same "
          "place",
      .stage = "voxels",
      .right_answer =
          "fewer than two pictures give no voxel; two equal cameras give the first layer of the "
          "object and nothing behind it",
      .unit = "voxels",
      .oracle = Oracle::kProperty,
      .ours = {"at least two pictures must see a voxel",
               [] { return measure_error(colored_by_ours); }},
      .naive = {"a voxel seen in one picture is coloured, because its deviation is 0",
                [] { return measure_error(plain<naive::SweepRules{.least_views = 1}>); }},
      .mutants = {{"at least three pictures must see a voxel",
                   [] { return measure_error(plain<naive::SweepRules{.least_views = 3}>); }},
                  {"coloured voxels hide nothing",
                   [] { return measure_error(plain<naive::SweepRules{.hides = false}>); }}},
      .not_drawn = "the case reconstructs a shape from given pictures; no engine draws the result",
  };
}

}  // namespace glassbox::study
