// Layered images of polygon ids, and the surface that is updated with them.
#include <tests/support/catch.h>

#include <algorithm>
#include <map>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/render/renderer.h>

#include "tests/views/voxels/rig.h"
#include "views/polygons/coloring.h"
#include "views/polygons/editable_surface.h"
#include "views/polygons/mesh_check.h"
#include "views/polygons/mesh_scene.h"
#include "views/texture/unlit_renderer.h"
#include "views/voxels/truth.h"

namespace glassbox::views {
namespace {

PinholeCamera looking_along_z(int size) {
  return test::camera_along_z({0, 0, -4}, size, size, size);
}

Vector3d any_place(Random& random) {
  return {random.between(-1.5, 1.5), random.between(-1.5, 1.5), random.between(-1.5, 1.5)};
}

Corners3d any_triangle(Random& random) {
  return {any_place(random), any_place(random), any_place(random)};
}

// Empty pictures from cameras around a box.
PictureSet empty_ring(const VoxelGrid& grid, int views, int size) {
  PictureSet set;
  const Vector3d middle = grid.world(grid.count[0] / 2.0, grid.count[1] / 2.0, grid.count[2] / 2.0);
  const double away = 3 * grid.size * grid.count[0];
  for (int i = 0; i < views; ++i) {
    const double angle = 2 * 3.14159265358979 * i / views;
    const Vector3d out = Vector3d(std::cos(angle), 0.4, std::sin(angle)).normalized();
    PinholeCamera camera;
    camera.intrinsic << 2 * size, 0, size / 2.0, 0, 2 * size, size / 2.0, 0, 0, 1;
    camera.centre = middle + away * out;
    const Vector3d right = Vector3d::UnitY().cross(out).normalized();
    camera.camera_from_world.row(0) = right.transpose();
    camera.camera_from_world.row(1) = -out.cross(right).transpose();
    camera.camera_from_world.row(2) = -out.transpose();
    set.pictures.push_back({"", camera, Image<Rgba8>(size, size), {}});
  }
  return set;
}

Occupancy random_solid(const VoxelGrid& grid, Random& random) {
  Occupancy solid(grid);
  for (int z = 0; z < grid.count[2]; ++z) {
    for (int y = 0; y < grid.count[1]; ++y) {
      for (int x = 0; x < grid.count[0]; ++x) solid.set({x, y, z}, random.integer(0, 2) > 0);
    }
  }
  return solid;
}

}  // namespace

TEST_CASE(
    "layered images after 100,000 random edits are those that are built anew, bit for bit (C-97)") {
  Random random(97);
  const PinholeCamera camera = looking_along_z(24);
  IdLayers layers(24, 24);
  std::map<PolygonId, Corners3d> there;
  const auto rebuilt = [&] {
    IdLayers anew(24, 24);
    // In a different order.
    for (auto it = there.rbegin(); it != there.rend(); ++it)
      anew.add(it->first, {camera, 24, 24, it->second});
    return anew;
  };
  std::int64_t most = 0;
  for (int edit = 0; edit < 100000; ++edit) {
    const auto id = PolygonId(random.integer(0, 199));
    const auto found = there.find(id);
    if (found != there.end()) {
      layers.remove(id, {camera, 24, 24, found->second});
      there.erase(found);
    } else {
      // Some triangles are in the same plane: which of equally distant ones is in front does not
      // depend on the order of edits.
      Corners3d corners = any_triangle(random);
      if (id % 3 == 0) {
        for (Vector3d& p : corners) p.z() = 0.5;
      }
      layers.add(id, {camera, 24, 24, corners});
      there.emplace(id, corners);
    }
    most = std::max(most, layers.sample_count());
    if (edit % 5000 == 0) REQUIRE(layers == rebuilt());
  }
  CHECK(layers == rebuilt());
  CHECK(most > 1000);
  while (!there.empty()) {
    layers.remove(there.begin()->first, {camera, 24, 24, there.begin()->second});
    there.erase(there.begin());
  }
  CHECK(layers.sample_count() == 0);
}

TEST_CASE("centres of pixels on a side that two polygons share belong to one of them") {
  Random random(11);
  const PinholeCamera camera = looking_along_z(32);
  std::int64_t drawn = 0;
  for (int i = 0; i < 300; ++i) {
    // Four triangles around a point that is a pixel centre, which form a quadrilateral: no gap, and
    // no pixel twice.
    const auto at = [&](double x, double y) { return Vector3d(x / 8, y / 8, 0); };
    const auto coordinate = [&](int low, int high) {
      return double(random.integer(low, high)) + 0.5;
    };
    const double x = coordinate(-2, 2), y = coordinate(-2, 2);
    const double right = coordinate(5, 9), top = coordinate(-9, -5);
    const double left = coordinate(-9, -5), bottom = coordinate(5, 9);
    const Vector3d middle = at(x, y);
    const Vector3d corners[] = {at(-9, -9), at(right, top), at(9, 9), at(left, bottom)};
    IdLayers layers(32, 32);
    for (std::size_t k = 0; k < 4; ++k)
      layers.add(PolygonId(k), {camera, 32, 32, {middle, corners[(k + 1) % 4], corners[k]}});
    IdLayers two(32, 32);
    two.add(0, {camera, 32, 32, {corners[0], corners[2], corners[1]}});
    two.add(1, {camera, 32, 32, {corners[0], corners[3], corners[2]}});
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 32; ++x) {
        REQUIRE(layers.samples({x, y}).size() <= 1);
        REQUIRE(layers.samples({x, y}).size() == two.samples({x, y}).size());
      }
    }
    drawn += layers.sample_count();
  }
  CHECK(drawn > 30000);
}

TEST_CASE(
    "a polygon's distance is that of its plane, and what is turned away or behind is not there") {
  Random random(5);
  const PinholeCamera camera = looking_along_z(40);
  int seen = 0;
  for (int i = 0; i < 200; ++i) {
    const Corners3d c = any_triangle(random);
    const Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]);
    const bool faces = normal.dot(camera.centre - c[0]) > 0;
    const PolygonFootprint footprint(camera, 40, 40, c);
    footprint.for_each_pixel([&](IdPixel at, float distance) {
      ++seen;
      CHECK(faces);
      const Vector3d ray = ray_through(camera.intrinsic, {at.x + 0.5, at.y + 0.5});
      const double right = normal.dot(c[0] - camera.centre) / normal.dot(ray);
      // Snapping moves corners by up to 1/512 px along each axis, which changes a distance by that
      // times the slope there.
      const double slope = normal.head<2>().norm() / 40 * right / std::abs(normal.dot(ray));
      CHECK(std::abs(double(distance) - right) <= 0x1p-8 * slope * right + 1e-6 * right);
    });
  }
  CHECK(seen > 1000);
  const Corners3d behind{Vector3d(-1, -1, -5), Vector3d(0, 1, 0), Vector3d(1, -1, 0)};
  IdLayers layers(40, 40);
  for (const Corners3d& each : {behind, Corners3d{behind[0], behind[2], behind[1]}})
    layers.add(1, {camera, 40, 40, each});
  CHECK(layers.sample_count() == 0);
}

TEST_CASE(
    "a surface that voxels are taken from and given to is that of the solid that is left (S1-39)") {
  Random random(23);
  const VoxelGrid grid = grid_of({{0, 0, 0}, {6, 6, 6}}, 1, Matrix3d::Identity()).value();
  const PictureSet set = empty_ring(grid, 5, 40);
  EditableSurface surface(set, random_solid(grid, random), 1);
  for (int edit = 0; edit < 600; ++edit) {
    const auto any = [&] { return int(random.integer(0, 5)); };
    const VoxelPosition voxel{any(), any(), any()};
    const bool full = surface.occupancy().has(voxel);
    const auto changed = surface.set_voxel(voxel, !full);
    for (const PolygonId id : changed) REQUIRE(surface.has(id));
    if (edit % 40 != 39) continue;
    const EditableSurface anew(set, surface.occupancy(), edit % 3);
    REQUIRE(surface.layers() == anew.layers());
    REQUIRE(surface.polygons() == anew.polygons());
  }
  // The polygons of the cells are those of the mesh, one by one.
  const PolygonMesh mesh = polygonise(surface.occupancy().field(), 0.5, Polygoniser::kConsistent);
  const auto ids = surface.polygons();
  REQUIRE(ids.size() == mesh.polygons.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(surface.polygon(ids[i]).corners[k] ==
            world_of_lattice(grid, mesh.positions[mesh.polygons[i][k]]));
  }
  CHECK(check_mesh(mesh).is_closed());
  // Smoothing moves the corners, but does not change the polygons.
  const PolygonMesh smooth =
      polygonise(surface.occupancy().smooth_field(), 0.5, Polygoniser::kConsistent);
  CHECK(smooth.polygons == mesh.polygons);
  CHECK(smooth.positions != mesh.positions);
}

TEST_CASE("polygons and layered images that take more memory than is allowed are refused") {
  Random random(29);
  const VoxelGrid grid = grid_of({{0, 0, 0}, {12, 12, 12}}, 1, Matrix3d::Identity()).value();
  const PictureSet set = empty_ring(grid, 4, 120);
  const Occupancy solid = random_solid(grid, random);
  const EditableSurface surface(set, solid, 1);
  CHECK(std::size_t(EditableSurface::count_polygons(solid)) == surface.polygons().size());
  // A list for each pixel and at least eight bytes for each sample, and at most three times that
  // with the overhead of the allocator.
  const double pixels = 4 * 120 * 120;
  double samples = 0;
  std::int64_t covered = 0;
  for (const IdLayers& layers : surface.layers()) {
    samples += double(layers.sample_count());
    for (int i = 0; i < 120 * 120; ++i) covered += layers.front({i % 120, i / 120}) != nullptr;
  }
  REQUIRE(covered > 1000);
  CHECK(surface.layer_bytes() >= 24 * pixels + 8 * samples);
  CHECK(surface.layer_bytes() <= 24 * pixels + 24 * samples + 32 * double(covered));

  PolygonColoringSettings settings;
  settings.carves = false;
  const double polygons = polygon_bytes(grid, double(surface.polygons().size()));
  const auto message = [&](double most_bytes) {
    settings.most_bytes = most_bytes;
    const auto coloring = color_polygons(set, solid, settings);
    return coloring ? std::string() : coloring.error().message();
  };
  CHECK(message(polygons + surface.layer_bytes()).empty());
  CHECK(message(polygons + surface.layer_bytes() - 1)
            .find("polygons and their layered images need more memory") != std::string::npos);
  CHECK(message(polygons - 1).find("polygons need more memory") != std::string::npos);
}

TEST_CASE("polygons have the colours that pictures show, and voxels that are too many are carved") {
  const Scene scene = test::speckled_sphere(5, 8);
  RingOptions options;
  options.views = 10;
  options.elevations = {-35, 20, 55};
  options.width = options.height = 64;
  const PictureSet set = test::ring_of(scene, options);
  const VoxelGrid grid = grid_of(*set.box, 2 / 24.0, Matrix3d::Identity()).value();
  const TrueVolume truth(scene, grid);
  // The ball, and in front of it a slab that does not exist.
  Occupancy solid(grid);
  std::int64_t slab = 0;
  for (int z = 0; z < grid.count[2]; ++z) {
    for (int y = 0; y < grid.count[1]; ++y) {
      for (int x = 0; x < grid.count[0]; ++x) {
        const bool is_slab = z >= 21 && std::abs(x - 12) < 5 && std::abs(y - 12) < 5;
        solid.set({x, y, z}, truth.has({x, y, z}) || is_slab);
        slab += is_slab && !truth.has({x, y, z});
      }
    }
  }
  REQUIRE(slab > 50);
  PolygonColoringSettings settings;
  settings.threads = 1;
  settings.threshold = INFINITY;  // colours never decide: only the background carves
  settings.carves = false;
  const auto as_it_is = color_polygons(set, solid, settings);
  REQUIRE(as_it_is);
  settings.carves = true;
  const auto carved = color_polygons(set, solid, settings);
  REQUIRE(carved);
  CHECK(as_it_is->full == solid.full());
  CHECK(carved->carved_by_background > 0);
  CHECK(carved->carved_by_color + carved->carved_by_background == solid.full() - carved->full);
  CHECK(check_mesh(carved->mesh).is_closed());
  CHECK(carved->colors.size() == carved->mesh.polygons.size());
  // Most of the slab is carved: a voxel is carved if a picture shows background at its centre,
  // unless a polygon that sticks out is in front of it. At its outline the ball loses some voxels,
  // by less than a pixel.
  CHECK(carved->full < truth.voxels() + slab / 3);
  std::int64_t lost = 0, lost_within = 0;
  for (int z = 0; z < grid.count[2]; ++z) {
    for (int y = 0; y < grid.count[1]; ++y) {
      for (int x = 0; x < grid.count[0]; ++x) {
        const VoxelPosition at{x, y, z};
        if (!solid.has(at) || carved->solid.has(at)) continue;
        lost += truth.has(at);
        lost_within += std::ranges::none_of(set.pictures, [&](const CalibratedPicture& picture) {
          const Vector3d p = project(picture.camera, grid.centre(at));
          return picture.matte.at(int(p.x()), int(p.y())) == 0;
        });
      }
    }
  }
  CHECK(lost_within == 0);
  CHECK(50 * lost < truth.voxels());
  settings.threads = 3;
  const auto again = color_polygons(set, solid, settings);
  CHECK(again->mesh.polygons == carved->mesh.polygons);
  CHECK(again->mesh.positions == carved->mesh.positions);
  const auto ply = polygons_ply(*carved);
  REQUIRE(ply);
  CHECK(*ply == *polygons_ply(*again));
  // Drawn by the engine, it covers less of the background than with the slab.
  const auto beside = [&](const PolygonColoring& coloring) {
    const Scene drawn = scene_of(coloring).value();
    RenderSettings engine;
    engine.shading = Shading::kUnlit;
    engine.want_id = true;
    Renderer renderer(drawn, engine.transfer);
    std::int64_t pixels = 0;
    for (const CalibratedPicture& picture : set.pictures) {
      const auto view = view_of(picture.camera, 64, 64, *set.box);
      const auto ids = renderer.render(*view, engine).buffers.id;
      for (std::size_t i = 0; i < ids.pixels.size(); ++i)
        pixels += ids.pixels[i] != 0 && picture.matte.pixels[i] == 0;
    }
    return pixels;
  };
  CHECK(3 * beside(*carved) < beside(*as_it_is));
}

TEST_CASE("where no background tells, colours do: what bulges is carved, and what is there stays") {
  // A speckled wall, z > 0, seen from the front by five cameras whose pictures it fills.
  constexpr int kCells = 20, kSize = 72;
  Scene scene;
  Mesh wall;
  Random random(3);
  for (int y = 0; y <= kCells; ++y) {
    for (int x = 0; x <= kCells; ++x) {
      const auto light = [&] { return float(random.between(0.02, 0.9)); };
      wall.positions.push_back({4.0f * float(x) / kCells - 2, 4.0f * float(y) / kCells - 2, 0});
      wall.colors.push_back({light(), light(), light(), 1});
    }
  }
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      const auto first = std::uint32_t(y * (kCells + 1) + x);
      wall.faces.push_back({std::uint32_t(wall.corners.size()), 4});
      for (const std::uint32_t at : {first, first + kCells + 1, first + kCells + 2, first + 1})
        wall.corners.push_back({at, kNone, kNone, at});
    }
  }
  scene.materials[add_material(scene, "speckled", {1, 1, 1, 1})].unlit = true;
  add_object(scene, std::move(wall));
  PictureSet set;
  UnlitRenderer renderer(scene);
  for (const auto& [x, y] :
       {std::pair{0.0, 0.0}, {-0.9, 0.1}, {0.8, -0.2}, {0.1, 0.9}, {-0.2, -0.8}}) {
    const PinholeCamera camera = test::camera_along_z({x, y, -4}, 2.4 * kSize, kSize, kSize);
    set.pictures.push_back({"", camera, renderer.draw(camera, kSize, kSize)->color, {}});
  }
  const VoxelGrid grid =
      grid_of({{-0.7, -0.7, -0.4}, {0.7, 0.7, 0.4}}, 0.1, Matrix3d::Identity()).value();
  Occupancy truth(grid), solid(grid);
  for (int z = 0; z < grid.count[2]; ++z) {
    for (int y = 0; y < grid.count[1]; ++y) {
      for (int x = 0; x < grid.count[0]; ++x) {
        const Vector3d p = grid.centre({x, y, z});
        truth.set({x, y, z}, p.z() > 0);
        solid.set({x, y, z}, p.z() > (p.head<2>().norm() < 0.3 ? -0.3 : 0));
      }
    }
  }
  PolygonColoringSettings settings;
  settings.threads = 1;
  settings.threshold = 20;
  const auto found = color_polygons(set, solid, settings);
  const auto wrong = [&](const Occupancy& one) {
    int sum = 0;
    for (int z = 0; z < grid.count[2]; ++z) {
      for (int y = 0; y < grid.count[1]; ++y) {
        for (int x = 0; x < grid.count[0]; ++x) sum += one.has({x, y, z}) != truth.has({x, y, z});
      }
    }
    return sum;
  };
  CAPTURE(wrong(solid), wrong(found->solid), found->carved_by_color, found->kept);
  CHECK(found->kept > 0);
  // No voxel of the wall is carved.
  CHECK(found->carved_by_color > 0);
  CHECK(wrong(found->solid) == wrong(solid) - found->carved_by_color);
}

TEST_CASE("surfaces that cannot be made are refused with a reason") {
  const VoxelGrid grid = grid_of({{0, 0, 0}, {4, 4, 4}}, 1, Matrix3d::Identity()).value();
  const PictureSet set = empty_ring(grid, 2, 8);
  CHECK_FALSE(color_polygons(set, Occupancy(grid), {}));
  VoxelGrid large = grid;
  large.count = {1000, 1000, 1000};
  CHECK(EditableSurface::is_too_large(large));
  // Voxels of 0.01 at a distance of a million units.
  const WorldBox far_box{{1e6, 0, 0}, {1e6 + 0.04, 0.04, 0.04}};
  const VoxelGrid far_grid = grid_of(far_box, 0.01, Matrix3d::Identity()).value();
  Occupancy one(far_grid);
  one.set({1, 1, 1}, true);
  PolygonColoring coloring;
  coloring.grid = far_grid;
  coloring.mesh = polygonise(one.field(), 0.5, Polygoniser::kConsistent);
  coloring.colors.resize(coloring.mesh.polygons.size());
  CHECK_FALSE(scene_of(coloring));
  CHECK_FALSE(polygons_ply(coloring));
}

}  // namespace glassbox::views
