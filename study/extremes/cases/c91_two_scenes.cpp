#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/flat_scene.h"
#include "study/naive/voxels.h"

namespace glassbox::study {
namespace c91 {

constexpr Rgba8 kRed{200, 30, 20, 255};

// Two red voxels side by side look the same to the cameras as two voxels one behind the other,
// midway between them.
Outcome measure_error(Colorer colored_by) {
  const std::vector<views::VoxelPosition> beside{{3, 0, 2}, {5, 0, 2}},
      nearer{{4, 0, 1}, {4, 0, 3}};
  FlatScene flat = make_flat_scene(10, 1, 6, {-1, 1}), other = flat;
  paint(flat, beside, kRed);
  paint(other, nearer, kRed);
  int pixels = 0;
  const auto differ = [&](const FlatScene& a, const FlatScene& b) {
    for (std::size_t p = 0; p < 2; ++p) {
      const auto &one = a.set.pictures[p], &two = b.set.pictures[p];
      for (std::size_t i = 0; i < one.color.pixels.size(); ++i)
        pixels += !(one.color.pixels[i] == two.color.pixels[i]) ||
                  one.matte.pixels[i] != two.matte.pixels[i];
    }
  };
  differ(flat, other);
  const naive::VoxelKeys found = colored_by(flat);
  // Draws the scene that was found and compares the pictures.
  FlatScene again = make_flat_scene(10, 1, 6, {-1, 1});
  for (int z = 0; z < 6; ++z)
    for (int x = 0; x < 10; ++x)
      if (found.contains(views::key_of({x, 0, z}))) paint(again, {{x, 0, z}}, kRed);
  differ(flat, again);
  const int voxels = differing(found, keys_of(nearer));
  return must_be_zero(
      pixels + voxels,
      fmt::format("{} pixels differ, {} voxels are not in the nearer scene", pixels, voxels));
}

template <naive::SweepRules kWay>
naive::VoxelKeys plain(const FlatScene& flat) {
  return naive::colored_by(flat.set, flat.request, kWay);
}

}  // namespace c91

ExtremeCase c91_two_scenes() {
  using namespace c91;
  return {
      .id = "C-91",
      .name = "Two scenes that look the same",
      .construction =
          "two voxels of one colour side by side, and two behind each other between them, seen by "
          "cameras of slopes -1 and 1",
      .stage = "voxels",
      .right_answer =
          "both scenes give the same pictures; the result is the scene whose voxels are nearest to "
          "the cameras (S1-17), and it gives these pictures again",
      .unit = "pixels and voxels",
      .oracle = Oracle::kInteger,
      .ours = {"the layers are visited from near to far",
               [] { return measure_error(colored_by_ours); }},
      .naive = {"coloured voxels hide nothing",
                [] { return measure_error(plain<naive::SweepRules{.hides = false}>); }},
      .mutants = {{"a voxel is coloured if one picture sees it",
                   [] { return measure_error(plain<naive::SweepRules{.least_views = 1}>); }},
                  {"the background is a colour like any other",
                   [] { return measure_error(plain<naive::SweepRules{.asks_masks = false}>); }}},
      .not_drawn = "the case reconstructs a shape from given pictures; no engine draws the result",
  };
}

}  // namespace glassbox::study
