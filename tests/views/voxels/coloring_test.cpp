// Voxel colouring against pictures whose every answer is known.
#include <tests/support/catch.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <glassbox/mesh/ply/load.h>

#include "tests/views/voxels/rig.h"
#include "views/voxels/layers_of.h"
#include "views/voxels/tiles.h"
#include "views/voxels/truth.h"
#include "views/voxels/voxel_file.h"

namespace glassbox::views {
namespace {

// ---- flatland: cameras so far away that a voxel (x, y, z) of size 1 is the pixel (x - slope z + beside, y) ----

constexpr double kFar = 0x1p20;

PinholeCamera flat_camera(double slope, double beside) {
  PinholeCamera camera;
  // f X / Z + cx with X = x + f slope, Z = z + f: to x z / f of x - slope z, 1e-3 px here. A centre is half a voxel deep.
  camera.intrinsic << kFar, 0, beside + slope / 2 - kFar * slope, 0, kFar, 0, 0, 0, 1;
  camera.centre = {-kFar * slope, 0, -kFar};
  return camera;
}

struct FlatScene {
  PictureSet set;
  ColoringRequest request;
};

// A box of n x 1 x depth voxels, seen by cameras of these slopes; all pixels are background until they are painted.
FlatScene flatland(int n, int height, int depth, const std::vector<double>& slopes) {
  FlatScene flat;
  for (const double slope : slopes) {
    const int width = n + 2 * depth + 2;
    const PinholeCamera camera = flat_camera(slope, depth + 1);
    flat.set.pictures.push_back(
        {"", camera, Image<Rgba8>(width, height), Image<std::uint8_t>(width, height, 0)});
  }
  flat.request.box = {{0, 0, 0}, {double(n), double(height), double(depth)}};
  flat.request.voxel_size = 1;
  ColoringSettings& settings = flat.request.settings;
  settings.threshold = 1;
  settings.sampled = settings.hidden = Footprint::kCentre;
  settings.threads = 1;
  return flat;
}

VoxelGrid grid_of_flat(const FlatScene& flat) {
  return grid_of(flat.request.box, flat.request.voxel_size, Matrix3d::Identity()).value();
}

// The pixel of a voxel's centre.
PixelOf pixel_of(const FlatScene& flat, std::size_t picture, const VoxelAt& at) {
  const Vector3d p = project(flat.set.pictures[picture].camera, grid_of_flat(flat).centre(at));
  return {int(std::floor(p.x())), int(std::floor(p.y()))};
}

// What the cameras see of these voxels: the nearest of each pixel.
void paint(FlatScene& flat, std::vector<ColoredVoxel> voxels) {
  std::ranges::sort(voxels, [](const auto& a, const auto& b) { return a.at.z > b.at.z; });
  for (std::size_t p = 0; p < flat.set.pictures.size(); ++p) {
    CalibratedPicture& picture = flat.set.pictures[p];
    std::ranges::fill(picture.matte.pixels, std::uint8_t(0));
    std::ranges::fill(picture.color.pixels, Rgba8{0, 0, 0, 255});
    for (const ColoredVoxel& voxel : voxels) {
      const PixelOf pixel = pixel_of(flat, p, voxel.at);
      picture.color.at(pixel.column, pixel.row) = voxel.color;
      picture.matte.at(pixel.column, pixel.row) = 255;
    }
  }
}

using Place = std::tuple<int, int, int>;
std::set<Place> places_of(const std::vector<ColoredVoxel>& voxels) {
  std::set<Place> places;
  for (const ColoredVoxel& voxel : voxels) places.emplace(voxel.at.x, voxel.at.y, voxel.at.z);
  return places;
}

ColoredVoxel at(int x, int y, int z, Rgba8 color) {
  return {{x, y, z}, color, 0, 0};
}

constexpr Rgba8 kRed{200, 30, 20, 255}, kBlue{20, 40, 220, 255};

// ---- rings ----

ColoringRequest request_for(const PictureSet& set, double size) {
  ColoringRequest request;
  request.box = *set.box;
  request.voxel_size = size;
  request.settings.threads = 1;
  // Within a pixel the speckles change by some ten levels.
  request.settings.threshold = 30;
  return request;
}

RingOptions ring_options(int views, std::vector<double> elevations, int size) {
  RingOptions options;
  options.views = views;
  options.elevations = std::move(elevations);
  options.width = options.height = size;
  return options;
}

double iou_of(const Scene& scene, const PictureSet& set, const ColoringRequest& request,
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

}  // namespace

TEST_CASE(
    "two scenes that look the same: the one nearer to the cameras is found, and re-projects "
    "exactly (C-91, S1-16, S1-17)") {
  // Two red voxels side by side look as two behind each other between them.
  FlatScene flat = flatland(10, 1, 6, {-1, 1});
  const std::vector<ColoredVoxel> beside{at(3, 0, 2, kRed), at(5, 0, 2, kRed)};
  const std::vector<ColoredVoxel> behind{at(4, 0, 1, kRed), at(4, 0, 3, kRed)};
  paint(flat, behind);
  const PictureSet same = flat.set;
  paint(flat, beside);
  for (std::size_t p = 0; p < 2; ++p) CHECK(same.pictures[p].color == flat.set.pictures[p].color);
  const auto found = color_voxels(flat.set, flat.request);
  REQUIRE(found);
  CHECK(found->traversal != TraversalKind::kSurrounded);
  CHECK(places_of(found->voxels) == places_of(behind));
  const PictureSet before = flat.set;
  paint(flat, found->voxels);
  for (std::size_t p = 0; p < 2; ++p) {
    CHECK(before.pictures[p].color == flat.set.pictures[p].color);
    CHECK(before.pictures[p].matte == flat.set.pictures[p].matte);
  }
}

TEST_CASE(
    "an untextured object bulges towards two cameras as far as its photo hull, and no voxel is "
    "behind it (C-92, S1-32)") {
  constexpr int kSide = 40, kDepth = 30;
  FlatScene flat = flatland(kSide, 1, kDepth, {-1, 1});
  std::vector<ColoredVoxel> disc;
  for (int z = 0; z < kDepth; ++z) {
    for (int x = 0; x < kSide; ++x) {
      const double dx = x - 19.5, dz = z - 14.5;
      if (dx * dx + dz * dz < 8 * 8) disc.push_back(at(x, 0, z, kBlue));
    }
  }
  paint(flat, disc);
  // What one picture alone sees agrees with itself: without it, a pixel whose match is taken would be matched further behind.
  flat.request.settings.alone = Alone::kKeep;
  const auto found = color_voxels(flat.set, flat.request);
  REQUIRE(found);
  // Of one colour, the hull is where both show the object; its surface is nearest on each line of either picture.
  const auto in_hull = [&](const VoxelAt& voxel) {
    for (std::size_t p = 0; p < 2; ++p) {
      const PixelOf pixel = pixel_of(flat, p, voxel);
      if (flat.set.pictures[p].matte.at(pixel.column, pixel.row) == 0) return false;
    }
    return true;
  };
  std::set<int> seen[2];
  std::set<Place> expected;
  for (int z = 0; z < kDepth; ++z) {
    std::vector<VoxelAt> layer;
    for (int x = 0; x < kSide; ++x) {
      const VoxelAt voxel{x, 0, z};
      if (!in_hull(voxel)) continue;
      const int left = pixel_of(flat, 0, voxel).column, right = pixel_of(flat, 1, voxel).column;
      if (seen[0].contains(left) && seen[1].contains(right)) continue;
      expected.emplace(x, 0, z);
      layer.push_back(voxel);
    }
    for (const VoxelAt& voxel : layer)
      for (std::size_t p = 0; p < 2; ++p) seen[p].insert(pixel_of(flat, p, voxel).column);
  }
  CHECK(places_of(found->voxels) == expected);
  CHECK(expected.size() >= 10);
  // On each line of each picture the nearest voxel is not behind the disc's own.
  for (std::size_t p = 0; p < 2; ++p) {
    std::map<int, int> nearest, real;
    for (const ColoredVoxel& voxel : found->voxels) {
      const auto [place, is_new] =
          nearest.try_emplace(pixel_of(flat, p, voxel.at).column, voxel.at.z);
      place->second = std::min(place->second, voxel.at.z);
    }
    for (const ColoredVoxel& voxel : disc) {
      const auto [place, is_new] = real.try_emplace(pixel_of(flat, p, voxel.at).column, voxel.at.z);
      place->second = std::min(place->second, voxel.at.z);
    }
    bool bulges = false;
    for (const auto& [column, z] : nearest) {
      REQUIRE(real.contains(column));
      CHECK(z <= real[column]);
      bulges = bulges || z < real[column];
    }
    CHECK(bulges);
  }
}

TEST_CASE(
    "a threshold of 0 colours nothing, an infinite one makes a wall of the first layer (C-88)") {
  FlatScene flat = flatland(8, 8, 5, {-1, 0, 1});
  for (CalibratedPicture& picture : flat.set.pictures) {
    Random random(88);
    for (Rgba8& pixel : picture.color.pixels)
      pixel = {std::uint8_t(random.integer(0, 255)), std::uint8_t(random.integer(0, 255)), 0, 255};
    picture.matte = {};
  }
  flat.request.settings.threshold = 0;
  CHECK(color_voxels(flat.set, flat.request)->voxels.empty());
  flat.request.settings.threshold = INFINITY;
  const auto wall = color_voxels(flat.set, flat.request);
  CHECK(wall->voxels.size() >= 64);
  const auto in_first =
      std::ranges::count_if(wall->voxels, [](const auto& v) { return v.at.z == 0; });
  CHECK(in_first == 64);
}

TEST_CASE(
    "one camera, or one twice, says nothing of depth: the policy decides, and twins are the first "
    "layer (C-89)") {
  FlatScene flat = flatland(6, 1, 5, {0});
  paint(flat, {at(2, 0, 3, kRed), at(4, 0, 1, kBlue)});
  CHECK(color_voxels(flat.set, flat.request)->voxels.empty());
  CHECK(color_voxels(flat.set, flat.request)->counts[std::size_t(Verdict::kAlone)] == 10);
  const std::set<Place> first{{2, 0, 0}, {4, 0, 0}};
  flat.request.settings.alone = Alone::kKeep;
  CHECK(places_of(color_voxels(flat.set, flat.request)->voxels) == first);
  flat.request.settings.alone = Alone::kReject;
  flat.set.pictures.push_back(flat.set.pictures[0]);
  CHECK(places_of(color_voxels(flat.set, flat.request)->voxels) == first);
}

TEST_CASE(
    "hiding after a layer and at once are one where voxels of a layer share no pixel (S1-21)") {
  // Slabs with a texture, at two depths, under three cameras.
  FlatScene flat = flatland(20, 6, 6, {-1, 0, 1});
  Random random(21);
  std::vector<ColoredVoxel> slabs;
  for (int y = 0; y < 6; ++y) {
    for (int x = 3; x < 17; ++x) {
      const auto level = [&] { return std::uint8_t(random.integer(0, 255)); };
      slabs.push_back(at(x, y, x < 10 ? 2 : 4, {level(), level(), level(), 255}));
    }
  }
  paint(flat, slabs);
  const auto by_layer = color_voxels(flat.set, flat.request);
  flat.request.settings.update = Update::kVoxel;
  const auto by_voxel = color_voxels(flat.set, flat.request);
  CHECK(by_layer->voxels == by_voxel->voxels);
  CHECK(by_layer->counts == by_voxel->counts);
  // What three cameras see of a texture is where it is.
  const auto right = places_of(slabs);
  std::size_t exact = 0;
  for (const Place& place : places_of(by_layer->voxels)) exact += right.contains(place);
  CHECK(exact > 60);

  // Where they do share pixels, what comes first hides its neighbour at once.
  flat.request.settings.hidden = Footprint::kBox;
  flat.request.voxel_size = 0.5;
  flat.request.settings.update = Update::kLayer;
  const auto layer = color_voxels(flat.set, flat.request);
  flat.request.settings.update = Update::kVoxel;
  CHECK(color_voxels(flat.set, flat.request)->voxels.size() < layer->voxels.size());
}

TEST_CASE(
    "a texture as fine as the voxels fails every fixed threshold and passes the adaptive one, and "
    "the edge rule (C-94, S1-33, S1-34)") {
  // A wall whose voxels are two by two pixels of a checker board.
  FlatScene flat = flatland(16, 16, 4, {-2, 0, 2});
  for (CalibratedPicture& picture : flat.set.pictures) {
    picture.matte = {};
    for (int y = 0; y < picture.color.height; ++y)
      for (int x = 0; x < picture.color.width; ++x)
        picture.color.at(x, y) = (x + y) % 2 == 0 ? Rgba8{255, 255, 255, 255} : Rgba8{0, 0, 0, 255};
  }
  flat.request.voxel_size = 2;
  ColoringSettings& settings = flat.request.settings;
  settings.sampled = settings.hidden = Footprint::kBox;
  settings.threshold = 40;
  CHECK(color_voxels(flat.set, flat.request)->voxels.empty());
  settings.consistency = Consistency::kAdaptive;
  settings.k1 = 1;
  settings.k2 = 10;
  const auto adaptive = color_voxels(flat.set, flat.request);
  CHECK(std::ranges::count_if(adaptive->voxels, [](const auto& v) { return v.at.z == 0; }) == 64);
  settings.consistency = Consistency::kDeviation;
  settings.edge = 100;
  const auto edges = color_voxels(flat.set, flat.request);
  CHECK(edges->voxels == adaptive->voxels);
}

TEST_CASE("every target and every number of threads finds the same voxels, in every way there is") {
  const PictureSet set = test::ring_of(test::speckled_sphere(6, 3), ring_options(7, {35}, 64));
  struct Way {
    const char* name;
    void (*choose)(ColoringRequest&);
  };
  const Way ways[] = {
      {"sigma", [](ColoringRequest&) {}},
      {"adaptive", [](ColoringRequest& r) { r.settings.consistency = Consistency::kAdaptive; }},
      {"ratio, without masks of two pictures",
       [](ColoringRequest& r) {
         r.settings.consistency = Consistency::kLikelihood;
         r.settings.noise = 20;
       }},
      {"lab", [](ColoringRequest& r) { r.settings.space = ColorSpace::kLab; }},
      {"levels", [](ColoringRequest& r) { r.levels = 1; }},
      {"carving", [](ColoringRequest& r) { r.order = Order::kCarve; }},
      {"hulls, voxel after voxel", [](ColoringRequest& r) {
         r.settings.sampled = r.settings.hidden = Footprint::kHull;
         r.settings.update = Update::kVoxel;
       }}};
  for (const Way& way : ways) {
    ColoringRequest request = request_for(set, 0.1);
    way.choose(request);
    request.settings.target = Target::kScalar;
    request.settings.threads = 1;
    const auto first = color_voxels(set, request);
    REQUIRE(first);
    INFO(way.name);
    CHECK(first->voxels.size() > 100);
    for (const Target target : available_targets()) {
      for (const int threads : {1, 3}) {
        request.settings.target = target;
        request.settings.threads = threads;
        const auto again = color_voxels(set, request);
        INFO(name_of(target) << ", " << threads << " threads");
        CHECK(again->voxels == first->voxels);
        CHECK(again->counts == first->counts);
        CHECK(again->judged == first->judged);
      }
    }
  }
}

namespace {

struct OneByOne {
  std::set<Place> colored;
  std::int64_t hidden = 0, alone = 0, background = 0;
};

// The sweep of centres' pixels as its definition has it: each voxel by itself, in every picture.
OneByOne one_by_one(const PictureSet& set, const ColoringSettings& settings, const VoxelGrid& grid,
                    std::array<int, 2> direction, const WorldBox& box) {
  OneByOne result;
  std::vector<PackedPicture> pictures;
  std::vector<GridPicture> lenses;
  for (const CalibratedPicture& picture : set.pictures) {
    pictures.push_back(pack(picture, settings));
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
          const PixelOf at = centre_pixel(centre, lenses[p].width, lenses[p].height);
          if (at.column < 0) {
            is_background = is_background || picture.has_whole;
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
        const VoxelAt voxel = run.at(i);
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
  const PictureSet whole = test::ring_of(test::speckled_sphere(6, 4), ring_options(9, {40}, 96));
  // Two of them without a mask, and one that looks past most of the box.
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
        CHECK(right.colored == places_of(rows->voxels));
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
  const PictureSet set = test::ring_of(test::speckled_sphere(6, 5), ring_options(5, {30}, 64));
  ColoringRequest request = request_for(set, 0.05);
  const VoxelGrid grid = plan_coloring(set, request).value().grid;
  int backgrounds = 0, hiddens = 0, tight = 0;
  for (const CalibratedPicture& shown : set.pictures) {
    PackedPicture picture = pack(shown, request.settings);
    picture.has_whole = random.integer(0, 1) == 1;
    PixelTiles tiles(picture);
    // A disc of pixels is hidden, some twice.
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
            const PixelOf at = centre_pixel(p, lens.width, lens.height);
            const bool is_beside = at.column < 0;
            const std::uint32_t word =
                is_beside ? 0 : picture.words[std::size_t(at.row) * 64 + std::size_t(at.column)];
            if (is_background) {
              const bool agrees = is_beside ? picture.has_whole : (word & kBackground) != 0;
              REQUIRE(agrees);
            }
            if (is_hidden) {
              const bool agrees =
                  is_beside ? !picture.has_whole : (word & (kHidden | kBackground)) == kHidden;
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
  // A centre behind the camera, and numbers beyond what floats can place: nothing is known.
  PinholeCamera camera;
  camera.intrinsic << 100, 0, 32, 0, 100, 32, 0, 0, 1;
  VoxelGrid around;
  around.corner = {-2, -2, -2};
  CHECK_FALSE(rect_of(grid_picture(around, projection_of(camera), 64, 64), {{1, 1, 1}, {3, 3, 3}}));
  camera.centre = {-1e7, 0, -10};
  camera.intrinsic(0, 2) = -1e8;
  CHECK_FALSE(rect_of(grid_picture(around, projection_of(camera), 64, 64), {{1, 1, 1}, {3, 3, 3}}));
}

TEST_CASE("with masks no voxel is coloured outside of the visual hull (S1-20)") {
  const PictureSet set = test::ring_of(test::speckled_sphere(6, 5), ring_options(9, {30}, 64));
  for (const Order order : {Order::kSweep, Order::kCarve}) {
    ColoringRequest request = request_for(set, 0.05);
    request.order = order;
    const auto found = color_voxels(set, request);
    REQUIRE(found);
    CHECK(found->voxels.size() > 200);
    std::size_t outside = 0;
    for (const ColoredVoxel& voxel : found->voxels) {
      for (const CalibratedPicture& picture : set.pictures) {
        const Vector3d p = project(picture.camera, found->grid.centre(voxel.at));
        // A centre within 1e-3 px of a border may be looked up beside it, as rows go on in float.
        const auto near_border = [](double u) { return std::abs(u - std::round(u)) < 1e-3; };
        if (near_border(p.x()) || near_border(p.y())) continue;
        REQUIRE((p.x() > 0 && p.y() > 0 && p.x() < 64 && p.y() < 64));
        outside += picture.matte.at(int(p.x()), int(p.y())) == 0;
      }
    }
    CHECK(outside == 0);
  }
}

TEST_CASE(
    "a ring around the object has no order: one sweep is wrong, and carving from all sides is not "
    "(C-90)") {
  const Scene scene = test::speckled_sphere(6, 6);
  const PictureSet set = test::ring_of(scene, ring_options(16, {0}, 48));
  ColoringRequest request = request_for(set, test::pixel_size(set));
  request.settings.threshold = 60;
  Coloring carved, swept;
  const double by_carving = iou_of(scene, set, request, &carved);
  CHECK(carved.traversal == TraversalKind::kSurrounded);
  CHECK(carved.order == Order::kCarve);
  request.order = Order::kSweep;
  const double by_sweep = iou_of(scene, set, request, &swept);
  INFO("IoU " << by_carving << " and " << by_sweep);
  CHECK(by_carving > 0.8);
  CHECK(by_sweep < by_carving - 0.05);
}

TEST_CASE(
    "a textured ball from all around, at voxels of a pixel: IoU 0.95, and what two pictures see is "
    "within 3 voxels") {
  const Scene scene = test::speckled_sphere(6, 7);
  const PictureSet set = test::ring_of(scene, ring_options(8, {50, 0, -50}, 48));
  ColoringRequest request = request_for(set, test::pixel_size(set));
  request.settings.threshold = 60;
  Coloring found;
  CHECK(iou_of(scene, set, request, &found) >= 0.95);
  const SeenSurface seen = seen_surface(set, true_distances(scene, set).value(), found.grid);
  CHECK(surface_errors(found.voxels, seen).from_truth_most <= 3);
  CHECK(seen.twice.size() > 10000);
  // Below the speckle of a pixel one voxel that is carved wrongly opens the way to those behind it.
  request.settings.threshold = 25;
  CHECK(iou_of(scene, set, request) < 0.1);
}

TEST_CASE("coarse to fine finds nearly all, and looks at a small part") {
  const PictureSet set = test::ring_of(test::speckled_sphere(6, 9), ring_options(12, {45}, 96));
  ColoringRequest request = request_for(set, test::pixel_size(set));
  request.settings.threshold = 60;
  const auto full = color_voxels(set, request);
  request.levels = 2;
  const auto fine = color_voxels(set, request);
  REQUIRE(fine);
  const auto all = places_of(full->voxels), some = places_of(fine->voxels);
  std::size_t both = 0;
  for (const Place& place : some) both += all.contains(place);
  CHECK(double(both) > 0.9 * double(all.size()));
  CHECK(fine->judged < full->judged / 2);
}

TEST_CASE("what does not fit into memory is computed and refused before it is taken") {
  FlatScene flat = flatland(8, 1, 4, {-1, 1});
  flat.request.order = Order::kCarve;
  flat.request.voxel_size = 8.0 / 4096;
  flat.request.box.high = {8, 8, 8};
  flat.request.most_bytes = std::uint64_t(1) << 30;
  const auto refused = color_voxels(flat.set, flat.request);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message().find("4096 x 4096 x 4096 voxels and 2 pictures would take") !=
        std::string::npos);
  flat.request.voxel_size = 1e-3;
  CHECK(color_voxels(flat.set, flat.request).error().message().find("8000 voxels along an axis") !=
        std::string::npos);
  flat.request.voxel_size = 0;
  CHECK_FALSE(color_voxels(flat.set, flat.request));
  flat.request.voxel_size = 1;
  flat.request.levels = 7;
  CHECK_FALSE(color_voxels(flat.set, flat.request));
  flat.set.pictures.clear();
  CHECK_FALSE(color_voxels(flat.set, flat.request));
}

TEST_CASE("cameras whose numbers no float has are refused, and none is taken for a pixel") {
  FlatScene flat = flatland(8, 1, 4, {-1, 1});
  for (const Order order : {Order::kSweep, Order::kCarve}) {
    for (const Footprint footprint : {Footprint::kCentre, Footprint::kBox, Footprint::kHull}) {
      flat.request.order = order;
      flat.request.settings.sampled = footprint;
      FlatScene far = flat;
      far.set.pictures[1].name = "b.png";
      far.set.pictures[1].camera.centre.z() = -1e300;
      const auto refused = color_voxels(far.set, far.request);
      REQUIRE_FALSE(refused);
      CHECK(refused.error().message().find("b.png: its camera's numbers are too large") !=
            std::string::npos);
      far = flat;
      far.set.pictures[0].camera.intrinsic(0, 0) = 1e300;
      CHECK_FALSE(color_voxels(far.set, far.request));
    }
  }
  // By themselves footprints of places that are no numbers have no pixel, not one that is made of them.
  PinholeCamera camera = flat.set.pictures[0].camera;
  camera.centre.z() = -1e300;
  const VoxelGrid grid = grid_of_flat(flat);
  const GridPicture lens = grid_picture(grid, projection_of(camera), 20, 10);
  CHECK_FALSE(is_finite(lens));
  for (const Footprint footprint : {Footprint::kCentre, Footprint::kBox, Footprint::kHull}) {
    int pixels = 0;
    for_each_pixel(lens, centre_of(lens, {1, 0, 1}), footprint, [&](int x, int y) {
      ++pixels;
      CHECK((x >= 0 && y >= 0 && x < 20 && y < 10));
    });
    CHECK(pixels <= 1);
  }
}

TEST_CASE("what a request asks for is done or refused, and the result says what was done") {
  FlatScene flat = flatland(8, 1, 4, {-1, 1});
  paint(flat, {at(3, 0, 2, kRed)});
  flat.request.direction = std::array<int, 2>{0, -1};
  const auto along_x = color_voxels(flat.set, flat.request);
  REQUIRE(along_x);
  CHECK(along_x->direction == std::array<int, 2>{0, -1});
  CHECK(along_x->layers == 8);
  // Cameras inside of the box sweep in shells, unless a direction is asked for.
  FlatScene inside = flat;
  inside.request.direction.reset();
  for (CalibratedPicture& picture : inside.set.pictures) picture.camera.centre = {4, 0.5, 2};
  CHECK(plan_coloring(inside.set, inside.request)->in_shells);
  inside.request.direction = std::array<int, 2>{2, 1};
  const auto planes = plan_coloring(inside.set, inside.request);
  REQUIRE(planes);
  CHECK_FALSE(planes->in_shells);
  CHECK(planes->traversal == TraversalKind::kEmbedded);

  const auto refusal = [&](const ColoringRequest& request) {
    const auto refused = plan_coloring(flat.set, request);
    REQUIRE_FALSE(refused);
    return refused.error().message();
  };
  ColoringRequest request = flat.request;
  request.order = Order::kCarve;
  CHECK(refusal(request).find("--direction: is of one sweep, and carving goes along all six") !=
        std::string::npos);
  request.direction.reset();
  request.levels = 1;
  CHECK(refusal(request).find("--levels: is of one sweep") != std::string::npos);
  // Cameras all around, of which nobody said that one sweep is wanted.
  flat.set.pictures[0].camera.centre = {-100, 0.5, 2};
  flat.set.pictures[1].camera.centre = {100, 0.5, 2};
  request = flat.request;
  request.order = Order::kAuto;
  CHECK(refusal(request).find("cameras all around the box need carving") != std::string::npos);
  request.order = Order::kSweep;
  CHECK(plan_coloring(flat.set, request));
}

TEST_CASE("carving that is stopped says so") {
  const PictureSet set = test::ring_of(test::speckled_sphere(6, 6), ring_options(8, {0}, 32));
  ColoringRequest request = request_for(set, 0.15);
  request.order = Order::kCarve;
  const auto whole = color_voxels(set, request);
  REQUIRE(whole);
  CHECK(whole->is_finished);
  REQUIRE(whole->passes >= 2);
  request.most_passes = 1;
  const auto stopped = color_voxels(set, request);
  CHECK_FALSE(stopped->is_finished);
  CHECK(stopped->passes == 1);
}

TEST_CASE("voxels are written as cubes without inner faces, which are read again") {
  VoxelGrid grid;
  grid.size = 0.5;
  const std::vector<ColoredVoxel> voxels{at(0, 0, 0, kRed), at(1, 0, 0, kBlue)};
  const auto scene = load_ply_memory(voxels_ply(grid, voxels, VoxelShape::kCubes));
  REQUIRE(scene);
  REQUIRE(scene->meshes.size() == 1);
  CHECK(scene->meshes[0].faces.size() == 10);
  const WorldBox box = box_of(*scene);
  CHECK(box.low == Vector3d(0, 0, 0));
  CHECK(box.high == Vector3d(1, 0.5, 0.5));
  // Counter-clockwise seen from outside: the volume by the divergence theorem is that of both, 2 / 8.
  const Mesh& mesh = scene->meshes[0];
  double volume = 0;
  for (const Face& face : mesh.faces) {
    const auto place = [&](std::uint32_t corner) {
      const Point<Object>& p = mesh.positions[mesh.corners[face.first + corner].position];
      return Vector3d(double(p.x), double(p.y), double(p.z));
    };
    for (std::uint32_t i = 2; i < face.count; ++i)
      volume += place(0).dot(place(i - 1).cross(place(i))) / 6;
  }
  CHECK(std::abs(volume - 0.25) < 1e-12);
  const std::string points = voxels_ply(grid, voxels, VoxelShape::kPoints);
  CHECK(points.find("element vertex 2") != std::string::npos);
  CHECK(points.find("element face") == std::string::npos);
}

TEST_CASE("what is inside of a scene is found by winding") {
  const Scene cube = *make_builtin("cube");
  const VoxelGrid grid = grid_of({{-2, -2, -2}, {2, 2, 2}}, 0.25, Matrix3d::Identity()).value();
  const TrueVolume inside(cube, grid);
  CHECK(inside.voxels() == 8 * 8 * 8);
  CHECK(inside.has({4, 4, 4}));
  CHECK_FALSE(inside.has({3, 8, 8}));
  CHECK(inside.has({11, 11, 11}));
}

}  // namespace glassbox::views
