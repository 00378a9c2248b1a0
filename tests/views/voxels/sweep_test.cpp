// A sweep over rows and blocks of voxels, compared with one that examines each voxel by itself.
#include <tests/support/catch.h>

#include "tests/views/voxels/flat_scene.h"
#include "tests/views/voxels/rig.h"
#include "views/voxels/tiles.h"

namespace glassbox::views {

using namespace test;

namespace {

struct OneByOne {
  std::set<VoxelTuple> colored;
  std::int64_t hidden = 0, alone = 0, background = 0;
};

// The sweep by its definition, with the pixels of voxel centres: each voxel by itself in every
// picture.
OneByOne one_by_one(const PictureSet& set, const ColoringSettings& settings, const VoxelGrid& grid,
                    std::array<int, 2> direction, const WorldBox& box) {
  OneByOne result;
  std::vector<PackedPicture> pictures;
  std::vector<GridPicture> lenses;
  for (const CalibratedPicture& picture : set.pictures) {
    pictures.push_back(pack_picture(picture, settings));
    lenses.push_back(grid_picture(grid, pictures.back()));
  }
  const PlaneLayers planes(grid, direction);
  for (int k = 0; k < planes.count(); ++k) {
    std::vector<std::uint32_t*> hides;
    const auto hide = [&](const VoxelRun& run, int i) {
      for (std::size_t p = 0; p < pictures.size(); ++p) {
        const Projected centre = projected(row_of(lenses[p], run.first, run.axis), run.begin() + i);
        for_each_pixel(lenses[p], centre, settings.hidden, [&](int x, int y) {
          hides.push_back(
              &pictures[p].words[std::size_t(y) * std::size_t(pictures[p].width) + std::size_t(x)]);
        });
      }
    };
    for (const VoxelRun& run : planes.runs(k, box)) {
      for (int i = 0; i < run.count; ++i) {
        ColorSums sums;
        double spread = 0;
        bool is_background = false;
        for (std::size_t p = 0; p < pictures.size(); ++p) {
          const PackedPicture& picture = pictures[p];
          const Projected centre =
              projected(row_of(lenses[p], run.first, run.axis), run.begin() + i);
          const PixelPosition at = centre_pixel(centre, lenses[p].width, lenses[p].height);
          if (at.column < 0) {
            is_background = is_background || picture.shows_whole_object;
            continue;
          }
          const std::size_t pixel =
              std::size_t(at.row) * std::size_t(picture.width) + std::size_t(at.column);
          const std::uint32_t word = picture.words[pixel];
          is_background = is_background || (word & kBackground) != 0;
          if ((word & (kHidden | kBackground)) != 0) continue;
          add_word(sums, word);
          if (!picture.spread.empty()) spread += picture.spread[pixel];
        }
        result.background += is_background;
        if (is_background) continue;
        result.hidden += sums.count == 0;
        result.alone += sums.count == 1;
        if (sums.count < 2) continue;
        const double threshold =
            settings.consistency == Consistency::kAdaptive
                ? settings.k1 * (spread / double(sums.count)) + settings.k2 * kCodesPerLevel
                : settings.threshold * kCodesPerLevel;
        if (!(sums.variance() < threshold * threshold)) continue;
        const VoxelPosition voxel = run.at(i);
        result.colored.emplace(voxel.x, voxel.y, voxel.z);
        hide(run, i);
      }
    }
    for (std::uint32_t* word : hides) *word |= kHidden;
  }
  return result;
}

}  // namespace

TEST_CASE(
    "rows of voxels are judged as one by one, and blocks that are known to be hidden or background "
    "are so") {
  const PictureSet whole = ring_of(speckled_sphere(6, 4), ring_options(9, {40}, 96));
  // Some pictures without a mask, and one that sees hardly any of the box.
  PictureSet partial = whole;
  for (const std::size_t p : {1u, 4u, 6u}) partial.pictures[p].matte = {};
  partial.pictures[6].camera.intrinsic(0, 2) -= 60;
  for (const PictureSet* set : {&std::as_const(whole), &std::as_const(partial)}) {
    for (const ColorSpace space : {ColorSpace::kRgb, ColorSpace::kLab}) {
      for (const Consistency consistency : {Consistency::kDeviation, Consistency::kAdaptive}) {
        ColoringRequest request = request_for(*set, 0.04);
        ColoringSettings& settings = request.settings;
        settings.space = space;
        settings.consistency = consistency;
        settings.threshold = 60;
        settings.k2 = 50;
        const auto rows = color_voxels(*set, request);
        REQUIRE(rows);
        const OneByOne right = one_by_one(*set, settings, rows->grid, rows->direction, request.box);
        CHECK(right.colored == positions_of(rows->voxels));
        CHECK(right.hidden == rows->counts[std::size_t(Verdict::kHidden)]);
        CHECK(right.alone == rows->counts[std::size_t(Verdict::kAlone)]);
        CHECK(right.colored.size() > 200);
        CHECK(right.background > 1000);
        if (set == &whole) CHECK(right.hidden > 1000);
      }
    }
  }
}

TEST_CASE("tiles say of a block of voxels what every one of its pixels says") {
  Random random(17);
  const PictureSet set = ring_of(speckled_sphere(6, 5), ring_options(5, {30}, 64));
  ColoringRequest request = request_for(set, 0.05);
  const VoxelGrid grid = plan_coloring(set, request).value().grid;
  int backgrounds = 0, hiddens = 0, tight = 0;
  for (const CalibratedPicture& shown : set.pictures) {
    PackedPicture picture = pack_picture(shown, request.settings);
    picture.shows_whole_object = random.integer(0, 1) == 1;
    PixelTiles tiles(picture);
    // The pixels of a disc are hidden, some of them twice.
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        if ((x - 30) * (x - 30) + (y - 34) * (y - 34) > 24 * 24) continue;
        std::uint32_t& word = picture.words[std::size_t(y) * 64 + std::size_t(x)];
        if ((word & (kHidden | kBackground)) == 0) tiles.hide(x, y);
        word |= kHidden;
      }
    }
    const GridPicture lens = grid_picture(grid, picture);
    for (int round = 0; round < 2000; ++round) {
      const auto along = [&](std::size_t axis, int most) {
        const int from = int(random.integer(0, grid.count[axis] - 1));
        return std::pair{from, std::min(from + int(random.integer(0, most)), grid.count[axis] - 1)};
      };
      const auto [x0, x1] = along(0, 6);
      const auto [y0, y1] = along(1, 3);
      const auto [z0, z1] = along(2, 3);
      const auto rect = rect_of(lens, {{x0, y0, z0}, {x1, y1, z1}});
      REQUIRE(rect);
      const bool is_background = tiles.is_background(*rect), is_hidden = tiles.is_hidden(*rect);
      backgrounds += is_background;
      hiddens += is_hidden;
      for (int z = z0; z <= z1; ++z) {
        for (int y = y0; y <= y1; ++y) {
          for (int x = x0; x <= x1; ++x) {
            const Projected p = centre_of(lens, {x, y, z});
            const double u = double(p.x / p.w), v = double(p.y / p.w);
            const bool is_in = u >= double(rect->left) && u < double(rect->right) + 1 &&
                               v >= double(rect->top) && v < double(rect->bottom) + 1;
            REQUIRE(is_in);
            tight += x0 == x1 && y0 == y1 && z0 == z1 && rect->right - rect->left == 2;
            const PixelPosition at = centre_pixel(p, lens.width, lens.height);
            const bool is_beside = at.column < 0;
            const std::uint32_t word =
                is_beside ? 0 : picture.words[std::size_t(at.row) * 64 + std::size_t(at.column)];
            if (is_background) {
              const bool agrees =
                  is_beside ? picture.shows_whole_object : (word & kBackground) != 0;
              REQUIRE(agrees);
            }
            if (is_hidden) {
              const bool agrees = is_beside ? !picture.shows_whole_object
                                            : (word & (kHidden | kBackground)) == kHidden;
              REQUIRE(agrees);
            }
          }
        }
      }
    }
  }
  CHECK(backgrounds > 50);
  CHECK(hiddens > 50);
  CHECK(tight > 50);
  // A centre behind the camera, then numbers too large for float positions: nothing is known.
  PinholeCamera camera;
  camera.intrinsic << 100, 0, 32, 0, 100, 32, 0, 0, 1;
  VoxelGrid around;
  around.corner = {-2, -2, -2};
  CHECK_FALSE(rect_of(grid_picture(around, projection_of(camera), 64, 64), {{1, 1, 1}, {3, 3, 3}}));
  camera.centre = {-1e7, 0, -10};
  camera.intrinsic(0, 2) = -1e8;
  CHECK_FALSE(rect_of(grid_picture(around, projection_of(camera), 64, 64), {{1, 1, 1}, {3, 3, 3}}));
}

}  // namespace glassbox::views
