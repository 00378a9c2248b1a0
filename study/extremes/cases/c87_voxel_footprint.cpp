#include <functional>

#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "views/voxels/footprint.h"

namespace glassbox::study {
namespace c87 {

using views::GridPicture;
using views::Projected;
using PixelVisitor = std::function<void(int, int)>;
using FootprintOf = void (*)(const GridPicture& lens, const Projected& centre,
                             const PixelVisitor& visit);

constexpr int kSide = 64;  // in px

struct Box {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
};
Box box_around(const GridPicture& lens, const Projected& centre) {
  Box box;
  for (std::size_t i = 0; i < 8; ++i) {
    const double w = double(centre.w) + double(lens.corner_w[i]);
    const double u = (double(centre.x) + double(lens.corner_x[i])) / w;
    const double v = (double(centre.y) + double(lens.corner_y[i])) / w;
    box = {std::min(box.left, u), std::max(box.right, u), std::min(box.top, v),
           std::max(box.bottom, v)};
  }
  return box;
}

void ours(const GridPicture& lens, const Projected& centre, const PixelVisitor& visit) {
  views::for_each_pixel(lens, centre, views::Footprint::kBox, visit);
}

// Visits the pixels first .. last of the box, limited to the picture.
void visit_box(double left, double right, double top, double bottom, const PixelVisitor& visit) {
  for (int y = std::max(0, int(top)); y <= std::min(kSide - 1, int(bottom)); ++y)
    for (int x = std::max(0, int(left)); x <= std::min(kSide - 1, int(right)); ++x) visit(x, y);
}
// Visits only pixels whose centres are in the box. If the box is between pixel centres, there are
// none, and the standard deviation of no colours is 0.
void centres_alone(const GridPicture& lens, const Projected& centre, const PixelVisitor& visit) {
  const Box box = box_around(lens, centre);
  visit_box(std::ceil(box.left - 0.5), std::floor(box.right - 0.5), std::ceil(box.top - 0.5),
            std::floor(box.bottom - 0.5), visit);
}
// Visits every pixel that the box touches, including pixels of neighbouring voxels.
void all_touched(const GridPicture& lens, const Projected& centre, const PixelVisitor& visit) {
  const Box box = box_around(lens, centre);
  visit_box(std::floor(box.left), std::floor(box.right), std::floor(box.top),
            std::floor(box.bottom), visit);
}
// Uses the width that the voxel has at the distance of its centre, although its corners are nearer
// and farther.
void centre_alone(const GridPicture& lens, const Projected& centre, const PixelVisitor& visit) {
  views::for_each_pixel(lens, centre, views::Footprint::kCentre, visit);
}

Outcome measure_error(FootprintOf footprint_of) {
  Random random(87);
  int wrong = 0, tried = 0, empty = 0;
  for (const double size : {0.1, 0.3, 1.0, 3.0, 10.0}) {
    for (int round = 0; round < 40; ++round) {
      views::VoxelGrid grid;
      grid.size = size;
      // The voxel is 100 units away and the focal length is 100 px, so one unit is one pixel.
      grid.corner = {random.between(-20, 20), random.between(-20, 20), 100};
      views::PinholeCamera camera;
      camera.intrinsic << 100, 0, kSide / 2, 0, 100, kSide / 2, 0, 0, 1;
      const GridPicture lens =
          views::grid_picture(grid, views::projection_of(camera), kSide, kSide);
      const Projected centre = views::centre_of(lens, {0, 0, 0});
      const views::PixelPosition middle = views::centre_pixel(centre, kSide, kSide);
      Image<std::uint8_t> found(kSide, kSide, 0);
      footprint_of(lens, centre, [&](int x, int y) { found.at(x, y) = 1; });
      const Box box = box_around(lens, centre);
      // The box is computed with 8 additions and divisions of floats up to 64, each with a rounding
      // error.
      constexpr double kOff = 8 * kSide * 0x1p-24;
      bool is_wrong = found.at(middle.column, middle.row) == 0;
      bool is_empty = true;
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
          const double u = x + 0.5, v = y + 0.5;
          const double inside =
              std::min({u - box.left, box.right - u, v - box.top, box.bottom - v});
          const bool is_middle = x == middle.column && y == middle.row;
          is_empty = is_empty && found.at(x, y) == 0;
          is_wrong = is_wrong || (inside > kOff && found.at(x, y) == 0) ||
                     (inside < -kOff && !is_middle && found.at(x, y) == 1);
        }
      }
      wrong += is_wrong;
      empty += is_empty;
      ++tried;
    }
  }
  return wrong_count_outcome(wrong, tried, "voxels have wrong pixels",
                             fmt::format(", and {} have no pixel", empty));
}

}  // namespace c87

ExtremeCase c87_voxel_footprint() {
  using namespace c87;
  return {
      .id = "C-87",
      .name = "Voxels from a tenth of a pixel to ten",
      .construction = "cubes of 0.1, 0.3, 1, 3 and 10 px at 200 random places",
      .stage = "voxels",
      .right_answer =
          "a voxel has the pixels whose centres are in the box around its projection, and always "
          "the pixel of its own centre; without pixels the deviation would be 0, and every voxel "
          "would count as one colour",
      .unit = "voxels",
      .oracle = Oracle::kProperty,
      .ours =
          {"the pixels whose centres are in the box, and always the pixel of the voxel's centre",
           [] { return measure_error(ours); }},
      .naive = {"only the pixels whose centres are in the box",
                [] { return measure_error(centres_alone); }},
      .mutants = {{"all pixels that the box touches", [] { return measure_error(all_touched); }},
                  {"only the pixel of the voxel's centre",
                   [] { return measure_error(centre_alone); }}},
      .not_drawn = "the case reconstructs a shape from given pictures; no engine draws the result",
  };
}

}  // namespace glassbox::study
