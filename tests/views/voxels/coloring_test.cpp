// Voxel colouring against pictures whose every answer is known.
#include <tests/support/catch.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <glassbox/mesh/ply/load.h>

#include "tests/views/voxels/rig.h"
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
  const VoxelGrid grid = grid_for(set, request).value();
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

TEST_CASE("every target and every number of threads finds the same voxels") {
  const PictureSet set = test::ring_of(test::speckled_sphere(6, 3), ring_options(7, {35}, 64));
  ColoringRequest request = request_for(set, 0.06);
  for (const Consistency consistency : {Consistency::kDeviation, Consistency::kAdaptive}) {
    request.settings.consistency = consistency;
    request.settings.target = Target::kScalar;
    request.settings.threads = 1;
    const auto first = color_voxels(set, request);
    REQUIRE(first);
    CHECK(first->voxels.size() > 200);
    for (const Target target : available_targets()) {
      for (const int threads : {1, 2, 3}) {
        request.settings.target = target;
        request.settings.threads = threads;
        const auto again = color_voxels(set, request);
        INFO(name_of(target) << ", " << threads << " threads");
        CHECK(again->voxels == first->voxels);
        CHECK(again->counts == first->counts);
      }
    }
  }
}

TEST_CASE("rows of voxels are judged as each alone is") {
  const PictureSet set = test::ring_of(test::speckled_sphere(6, 4), ring_options(9, {40}, 64));
  ColoringRequest request = request_for(set, 0.07);
  // In this sampling of centres the box around a projection that is smaller than a pixel is that pixel, unless a border is near.
  for (const ColorSpace space : {ColorSpace::kRgb, ColorSpace::kLab}) {
    request.settings.space = space;
    request.settings.hidden = Footprint::kCentre;
    std::vector<PackedPicture> pictures;
    for (const CalibratedPicture& picture : set.pictures)
      pictures.push_back(pack(picture, request.settings));
    const VoxelGrid grid = grid_for(set, request).value();
    const auto rows = color_voxels(set, request);
    // By hand: each layer's voxels one by one, from the words.
    Sweep sweep(grid, pictures, request.settings);
    std::set<Place> found;
    for (int k = 0; k < rows->grid.count[1]; ++k) {
      const int y = rows->direction[1] > 0 ? k : grid.count[1] - 1 - k;
      std::vector<VoxelRun> runs;
      for (int z = 0; z < grid.count[2]; ++z)
        for (int x = 0; x < grid.count[0]; ++x) runs.push_back({{x, y, z}, 2, 1});
      sweep.layer(runs, {}, Occluders::kColored);
      for (const VoxelAt& voxel : sweep.colored()) found.emplace(voxel.x, voxel.y, voxel.z);
    }
    REQUIRE(rows->direction[0] == 1);
    CHECK(found == places_of(rows->voxels));
    CHECK(found.size() > 100);
  }
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
  CHECK(refused.error().message().find(
            "4096 x 4096 x 4096 voxels and 2 pictures would take 8208 MB") != std::string::npos);
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
