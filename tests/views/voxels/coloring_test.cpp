// Voxel colouring of pictures whose correct result is known.
#include <tests/support/catch.h>

#include <map>

#include "tests/views/voxels/flat_scene.h"

namespace glassbox::views {

using namespace test;

TEST_CASE(
    "two scenes that look the same: the one nearer to the cameras is found, and re-projects "
    "exactly (C-91, S1-16, S1-17)") {
  // Two red voxels side by side look like two voxels one behind the other between them.
  FlatScene flat = make_flat_scene(10, 1, 6, {-1, 1});
  const std::vector<ColoredVoxel> beside{colored_voxel(3, 0, 2, kRed),
                                         colored_voxel(5, 0, 2, kRed)};
  const std::vector<ColoredVoxel> behind{colored_voxel(4, 0, 1, kRed),
                                         colored_voxel(4, 0, 3, kRed)};
  paint(flat, behind);
  const PictureSet same = flat.set;
  paint(flat, beside);
  for (std::size_t p = 0; p < 2; ++p) CHECK(same.pictures[p].color == flat.set.pictures[p].color);
  const auto found = color_voxels(flat.set, flat.request);
  REQUIRE(found);
  CHECK(found->traversal != TraversalKind::kSurrounded);
  CHECK(positions_of(found->voxels) == positions_of(behind));
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
  FlatScene flat = make_flat_scene(kSide, 1, kDepth, {-1, 1});
  std::vector<ColoredVoxel> disc;
  for (int z = 0; z < kDepth; ++z) {
    for (int x = 0; x < kSide; ++x) {
      const double dx = x - 19.5, dz = z - 14.5;
      if (dx * dx + dz * dz < 8 * 8) disc.push_back(colored_voxel(x, 0, z, kBlue));
    }
  }
  paint(flat, disc);
  // A voxel seen by only one picture is kept: otherwise a pixel whose match is used already would
  // be matched farther behind.
  flat.request.settings.alone = SingleViewPolicy::kKeep;
  const auto found = color_voxels(flat.set, flat.request);
  REQUIRE(found);
  // With one colour, the photo hull is where both pictures show the object; its surface is the
  // nearest voxel on each line of sight of either picture.
  const auto in_hull = [&](const VoxelPosition& voxel) {
    for (std::size_t p = 0; p < 2; ++p) {
      const PixelPosition pixel = pixel_of(flat, p, voxel);
      if (flat.set.pictures[p].matte.at(pixel.column, pixel.row) == 0) return false;
    }
    return true;
  };
  std::set<int> seen[2];
  std::set<VoxelTuple> expected;
  for (int z = 0; z < kDepth; ++z) {
    std::vector<VoxelPosition> layer;
    for (int x = 0; x < kSide; ++x) {
      const VoxelPosition voxel{x, 0, z};
      if (!in_hull(voxel)) continue;
      const int left = pixel_of(flat, 0, voxel).column, right = pixel_of(flat, 1, voxel).column;
      if (seen[0].contains(left) && seen[1].contains(right)) continue;
      expected.emplace(x, 0, z);
      layer.push_back(voxel);
    }
    for (const VoxelPosition& voxel : layer)
      for (std::size_t p = 0; p < 2; ++p) seen[p].insert(pixel_of(flat, p, voxel).column);
  }
  CHECK(positions_of(found->voxels) == expected);
  CHECK(expected.size() >= 10);
  // On each line of sight the nearest voxel is not behind the disc's own.
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
  FlatScene flat = make_flat_scene(8, 8, 5, {-1, 0, 1});
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
  FlatScene flat = make_flat_scene(6, 1, 5, {0});
  paint(flat, {colored_voxel(2, 0, 3, kRed), colored_voxel(4, 0, 1, kBlue)});
  CHECK(color_voxels(flat.set, flat.request)->voxels.empty());
  CHECK(color_voxels(flat.set, flat.request)->counts[std::size_t(Verdict::kAlone)] == 10);
  const std::set<VoxelTuple> first{{2, 0, 0}, {4, 0, 0}};
  flat.request.settings.alone = SingleViewPolicy::kKeep;
  CHECK(positions_of(color_voxels(flat.set, flat.request)->voxels) == first);
  flat.request.settings.alone = SingleViewPolicy::kReject;
  flat.set.pictures.push_back(flat.set.pictures[0]);
  CHECK(positions_of(color_voxels(flat.set, flat.request)->voxels) == first);
}

TEST_CASE(
    "hiding after a layer and at once are one where voxels of a layer share no pixel (S1-21)") {
  // Textured slabs at two depths, seen by three cameras.
  FlatScene flat = make_flat_scene(20, 6, 6, {-1, 0, 1});
  Random random(21);
  std::vector<ColoredVoxel> slabs;
  for (int y = 0; y < 6; ++y) {
    for (int x = 3; x < 17; ++x) {
      const auto level = [&] { return std::uint8_t(random.integer(0, 255)); };
      slabs.push_back(colored_voxel(x, y, x < 10 ? 2 : 4, {level(), level(), level(), 255}));
    }
  }
  paint(flat, slabs);
  const auto by_layer = color_voxels(flat.set, flat.request);
  flat.request.settings.update = OcclusionUpdate::kVoxel;
  const auto by_voxel = color_voxels(flat.set, flat.request);
  CHECK(by_layer->voxels == by_voxel->voxels);
  CHECK(by_layer->counts == by_voxel->counts);
  // Three cameras locate a texture where it is.
  const auto right = positions_of(slabs);
  std::size_t exact = 0;
  for (const VoxelTuple& position : positions_of(by_layer->voxels))
    exact += right.contains(position);
  CHECK(exact > 60);

  // If they do share pixels, the first voxel hides its neighbour at once.
  flat.request.settings.hidden = Footprint::kBox;
  flat.request.voxel_size = 0.5;
  flat.request.settings.update = OcclusionUpdate::kLayer;
  const auto layer = color_voxels(flat.set, flat.request);
  flat.request.settings.update = OcclusionUpdate::kVoxel;
  CHECK(color_voxels(flat.set, flat.request)->voxels.size() < layer->voxels.size());
}

TEST_CASE(
    "a texture as fine as the voxels fails every fixed threshold and passes the adaptive one, and "
    "the edge rule (C-94, S1-33, S1-34)") {
  // A wall whose voxels are two by two pixels of a checkerboard.
  FlatScene flat = make_flat_scene(16, 16, 4, {-2, 0, 2});
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

}  // namespace glassbox::views
