#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/flat_scene.h"
#include "study/naive/voxels.h"

namespace glassbox::study {
namespace c88 {

constexpr int kWide = 8, kDeep = 5;

FlatScene noisy(bool blank, double threshold) {
  FlatScene flat = make_flat_scene(kWide, kWide, kDeep, {-1, 0, 1});
  Random random(88);
  for (views::CalibratedPicture& picture : flat.set.pictures) {
    picture.matte = {};
    for (Rgba8& pixel : picture.color.pixels) {
      const auto level = [&] { return std::uint8_t(blank ? 90 : random.integer(0, 255)); };
      pixel = {level(), level(), level(), 255};
    }
  }
  flat.request.settings.threshold = threshold;
  return flat;
}

// With an infinite threshold T, the first layer takes all pixels of the middle camera. What the
// other cameras see behind that layer is seen by one camera only, so no more voxels are found.
Outcome measure_error(Colorer colored_by) {
  std::vector<views::VoxelPosition> wall;
  for (int y = 0; y < kWide; ++y)
    for (int x = 0; x < kWide; ++x) wall.push_back({x, y, 0});
  const int with_none = int(colored_by(noisy(false, 0)).size() + colored_by(noisy(true, 0)).size());
  const double infinite = std::numeric_limits<double>::infinity();
  const int with_all = differing(colored_by(noisy(false, infinite)), keys_of(wall));
  return must_be_zero(
      with_none + with_all,
      fmt::format("{} voxels are coloured with T = 0, and {} outside the wall with T infinite",
                  with_none, with_all));
}

template <naive::SweepRules kWay>
naive::VoxelKeys plain(const FlatScene& flat) {
  return naive::colored_by(flat.set, flat.request, kWay);
}

}  // namespace c88

ExtremeCase c88_threshold_ends() {
  using namespace c88;
  return {
      .id = "C-88",
      .name = "A threshold of 0, and an infinite one",
      .construction =
          "three cameras see 8 x 8 x 5 voxels, in pictures of noise and in pictures of one colour, "
          "without masks",
      .stage = "voxels",
      .right_answer =
          "T = 0 colours no voxel, because no deviation is below 0; with T infinite all voxels of "
          "the first layer are coloured, and this wall hides the others",
      .unit = "voxels",
      .oracle = Oracle::kProperty,
      .ours = {"sigma < T", [] { return measure_error(colored_by_ours); }},
      .naive = {"sigma <= T",
                [] { return measure_error(plain<naive::SweepRules{.below = false}>); }},
      .mutants = {{"coloured voxels hide nothing",
                   [] { return measure_error(plain<naive::SweepRules{.hides = false}>); }},
                  {"the layers are visited from far to near",
                   [] { return measure_error(plain<naive::SweepRules{.nearest_first = false}>); }}},
      .not_drawn = "the case reconstructs a shape from given pictures; no engine draws the result",
  };
}

}  // namespace glassbox::study
