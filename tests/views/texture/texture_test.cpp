// Weights of views, and surfaces coloured with them.
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/render/renderer.h>

#include "tests/views/voxels/rig.h"
#include "views/texture/static_texture.h"
#include "views/texture/textured_surface.h"
#include "views/texture/unlit_renderer.h"

namespace glassbox::views {
namespace {

Vector3d any_direction(Random& random) {
  for (;;) {
    const Vector3d d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (d.norm() > 0.1 && d.norm() < 1) return d.normalized();
  }
}

std::vector<Vector3d> any_directions(Random& random, int count) {
  std::vector<Vector3d> all;
  for (int i = 0; i < count; ++i) all.push_back(any_direction(random));
  return all;
}

// Directions in a circle, `degrees` above the horizon.
std::vector<Vector3d> ring_of_directions(int count, double degrees) {
  const double up = degrees * std::numbers::pi / 180;
  std::vector<Vector3d> all;
  for (int i = 0; i < count; ++i) {
    const double around = 2 * std::numbers::pi * i / count;
    all.emplace_back(std::cos(up) * std::sin(around), std::sin(up),
                     std::cos(up) * std::cos(around));
  }
  return all;
}

double sum_of(const ViewWeights& weights) {
  double sum = 0;
  for (const ViewWeight& each : weights) {
    CHECK(each.weight > 0);
    sum += each.weight;
  }
  return sum;
}

// The largest difference between the weights of any view.
double difference(const ViewWeights& a, const ViewWeights& b) {
  std::map<std::size_t, double> all;
  for (const ViewWeight& each : a) all[each.view] += each.weight;
  for (const ViewWeight& each : b) all[each.view] -= each.weight;
  double most = 0;
  for (const auto& [view, weight] : all) most = std::max(most, std::abs(weight));
  return most;
}

// The least height of a triangle's corner above the plane through the middle and the two other
// corners, and of an end of a border side above the line through the middle and the other end.
double least_height(const ViewSphere& sphere, const std::vector<Vector3d>& d) {
  double least = 1;
  for (const auto& t : sphere.triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d side = d[t[(k + 1) % 3]].cross(d[t[(k + 2) % 3]]);
      least = std::min(least, std::abs(d[t[k]].dot(side)) / side.norm());
    }
  }
  for (const auto& [a, b] : sphere.border()) least = std::min(least, d[a].cross(d[b]).norm());
  return least;
}

const auto kAll = [](std::size_t) { return true; };

// Pictures from cameras around a shiny ball, whose highlights move with the eye.
PictureSet shiny_ring(const Scene& scene, int views, int size) {
  RingOptions options;
  options.views = views;
  options.elevations = {-25, 10, 45};
  options.width = options.height = size;
  RenderSettings settings;
  settings.background = {0, 0, 0, 255};
  return draw_ring(scene, ring_views(scene, options).value(), settings, Matte::kDepth);
}

// A white floor of two triangles, below a lid that hides half of each when seen from straight
// above. It is one unlit mesh.
Scene floor_and_lid() {
  Scene scene;
  Mesh mesh;
  const auto quad = [&](float x0, float x1, float z0, float z1, float y, Rgba color) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const auto& [x, z] : {std::pair{x0, z1}, {x1, z1}, {x1, z0}, {x0, z0}})
      mesh.positions.push_back({x, y, z});
    mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 4});
    for (std::uint32_t k = 0; k < 4; ++k)
      mesh.corners.push_back({first + k, kNone, kNone, std::uint32_t(mesh.colors.size())});
    mesh.colors.push_back(color);
  };
  quad(-1, 1, -1, 1, 0, {1, 1, 1, 1});
  quad(-1, 1, -0.5f, 0.5f, 0.7f, {1, 0, 0, 1});
  scene.materials[add_material(scene, "unlit", {1, 1, 1, 1})].unlit = true;
  add_object(scene, std::move(mesh));
  return scene;
}

// A camera that looks at the middle from a distance of five, `degrees` off the vertical.
PinholeCamera camera_above(double degrees, int size) {
  const double turn = degrees * std::numbers::pi / 180;
  const Vector3d out(0, std::cos(turn), std::sin(turn));
  PinholeCamera camera;
  camera.intrinsic << 1.5 * size, 0, size / 2.0, 0, 1.5 * size, size / 2.0, 0, 0, 1;
  camera.centre = 5 * out;
  camera.camera_from_world.row(0) = Vector3d::UnitX().transpose();
  camera.camera_from_world.row(1) = -out.cross(Vector3d::UnitX()).transpose();
  camera.camera_from_world.row(2) = -out.transpose();
  return camera;
}

PictureSet pictures_by(const Scene& scene, const std::vector<PinholeCamera>& cameras, int size) {
  PictureSet set;
  UnlitRenderer renderer(scene);
  for (const PinholeCamera& camera : cameras) {
    Framebuffer buffers = renderer.draw(camera, size, size).value();
    auto matte = matte_where(size, size, [&](std::size_t i) { return buffers.id.pixels[i] != 0; });
    set.pictures.push_back({"", camera, std::move(buffers.color), std::move(matte)});
  }
  return set;
}

}  // namespace

TEST_CASE(
    "triangles of views are Delaunay's: no other view is within the circle through three of them "
    "(S1-40)") {
  Random random(40);
  for (const int count : {4, 7, 20, 60}) {
    const auto directions = any_directions(random, count);
    const ViewSphere sphere(directions);
    for (const auto& [a, b, c] : sphere.triangles()) {
      const Vector3d normal = (directions[b] - directions[a]).cross(directions[c] - directions[a]);
      for (const Vector3d& d : directions) {
        // Directions are rounded to 2^-24 and lengthened by up to 2^-18, and the normal is no
        // longer than the product of the two sides.
        CHECK(normal.dot(d - directions[a]) <= 0x1p-16);
      }
    }
    // By Euler's formula, n corners with a border of b sides have 2 n - 2 - b triangles, and
    // without a border 2 n - 4. Twenty random directions surround the middle.
    const std::size_t border = sphere.border().size();
    if (count >= 20) REQUIRE(border == 0);
    CHECK(sphere.triangles().size() == 2 * std::size_t(count) - 2 - (border == 0 ? 2 : border));
  }
}

TEST_CASE("views of which many lie in one plane have triangles all the same (C-98)") {
  std::vector<Vector3d> directions;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) directions.push_back(sign * Vector3d::Unit(axis));
  }
  const ViewSphere octahedron(directions);
  CHECK(octahedron.triangles().size() == 8);
  CHECK(octahedron.border().empty());
  for (const Vector3d& d : directions) CHECK(octahedron.weights(d).size() == 1);
}

TEST_CASE(
    "weights are positive, sum to 1, make the direction, and at a view's own are that view alone "
    "(S1-40, C-98)") {
  Random random(41);
  int inside = 0;
  for (const int count : {1, 2, 3, 4, 12, 50}) {
    const auto directions = any_directions(random, count);
    const ViewSphere sphere(directions);
    for (int i = 0; i < 500; ++i) {
      const Vector3d direction = any_direction(random);
      const ViewWeights weights = sphere.weights(direction);
      REQUIRE(weights.size() >= 1);
      REQUIRE(weights.size() <= 3);
      CHECK(sum_of(weights) == Approx(1).epsilon(1e-12));
      Vector3d made = Vector3d::Zero();
      for (const ViewWeight& each : weights) made += each.weight * directions[each.view];
      if (weights.size() < 3) continue;
      ++inside;
      CHECK((made.normalized() - direction).norm() < 1e-9);
    }
    for (std::size_t view = 0; view < directions.size(); ++view)
      CHECK(difference(sphere.weights(directions[view]), {{view, 1}}) < 1e-9);
  }
  CHECK(inside > 500);
}

TEST_CASE(
    "the example of the slides: three views, .49, .27 and .24 of a direction between them "
    "(S1-40)") {
  const std::vector<Vector3d> directions{Vector3d(0, 0, 1), Vector3d(0.6, 0, 0.8),
                                         Vector3d(0, 0.6, 0.8)};
  const Vector3d between =
      (0.49 * directions[0] + 0.27 * directions[1] + 0.24 * directions[2]).normalized();
  const ViewWeights weights = ViewSphere(directions).weights(between);
  CHECK(difference(weights, {{0, 0.49}, {1, 0.27}, {2, 0.24}}) < 1e-12);
}

TEST_CASE(
    "barycentric weights change as little as the direction does, across edges and off the border; "
    "nearest jumps") {
  constexpr double kStep = 1e-7, kMinCosine = 0.05;
  Random random(42);
  for (const auto& directions : {any_directions(random, 30), ring_of_directions(16, 20),
                                 ring_of_directions(9, 0), any_directions(random, 3)}) {
    const ViewSphere sphere(directions);
    double most = 0;
    int asked = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vector3d from = any_direction(random), step = kStep * any_direction(random);
      // Farther than 90 degrees from every view, the nearest view has all the weight.
      const bool is_near = std::ranges::any_of(
          directions, [&](const Vector3d& d) { return d.dot(from) > kMinCosine; });
      if (!is_near) continue;
      most = std::max(most,
                      difference(sphere.weights(from), sphere.weights((from + step).normalized())));
      ++asked;
    }
    CHECK(asked > 400);  // at least a tenth of the sphere is near
    // A direction that is projected into the cone has at least the length kMinCosine there, and
    // its change does not grow. Three numbers w express it, whose sum is at least that length, and
    // each changes by at most the step over the height of its corner; so w_i / sum changes by (1 +
    // 3) times that, divided by the sum.
    const double bound = 4 * kStep / (kMinCosine * least_height(sphere, directions));
    CHECK(bound < 0.1);
    CHECK(most < bound);
  }
  // Halfway between two views, from one side of the middle to the other.
  const auto ring = ring_of_directions(8, 0);
  const Vector3d middle = (ring[0] + ring[1]).normalized(), aside = 1e-9 * (ring[1] - ring[0]);
  const auto jump = [&](Blend blend) {
    const ViewBlend views(blend, ring);
    return difference(views.from_direction((middle - aside).normalized()).weights(kAll),
                      views.from_direction((middle + aside).normalized()).weights(kAll));
  };
  CHECK(jump(Blend::kNearest) == 1);
  CHECK(jump(Blend::kBarycentric) < 1e-8);
  CHECK(jump(Blend::kNeighbours) < 1e-7);
}

TEST_CASE(
    "views that do not see a polygon have no weight, and where none of the three does the nearest "
    "that sees it has all (C-98)") {
  Random random(43);
  const auto directions = any_directions(random, 25);
  for (const Blend blend : {Blend::kNearest, Blend::kBarycentric, Blend::kNeighbours}) {
    const ViewBlend views(blend, directions, 5);
    for (int i = 0; i < 400; ++i) {
      std::vector<bool> sees(directions.size());
      for (std::size_t v = 0; v < sees.size(); ++v) sees[v] = random.integer(0, 3) == 0;
      const Vector3d direction = any_direction(random);
      const auto weights =
          views.from_direction(direction).weights([&](std::size_t v) { return bool(sees[v]); });
      if (std::ranges::none_of(sees, [](bool b) { return b; })) {
        CHECK(weights.empty());
        continue;
      }
      CHECK(sum_of(weights) == Approx(1).epsilon(1e-12));
      for (const ViewWeight& each : weights) CHECK(sees[each.view]);
      CHECK(weights.size() <= (blend == Blend::kNearest       ? 1
                               : blend == Blend::kBarycentric ? 3
                                                              : 5));
    }
    CHECK(views.from_direction(directions[0]).weights([](std::size_t) { return false; }).empty());
    // In a view's own direction only that view counts, if it sees the polygon.
    CHECK(difference(views.from_direction(directions[7]).weights(kAll), {{7, 1}}) < 1e-9);
  }
}

TEST_CASE("at the place of a picture a textured surface is that picture, byte for byte (S1-40)") {
  // A coarse ball instead of the fine one: the surface is wrong, the pictures are right.
  const Scene real = test::speckled_sphere(8, 4), coarse = *make_builtin("sphere:3");
  const PictureSet set = shiny_ring(real, 6, 72);
  for (const Blend blend : {Blend::kNearest, Blend::kBarycentric, Blend::kNeighbours}) {
    const auto surface = TexturedSurface::create(coarse, set, blend);
    REQUIRE(surface);
    for (const CalibratedPicture& picture : set.pictures) {
      const auto drawn = surface->draw(picture.camera, 72, 72, {0, 0, 0, 255});
      REQUIRE(drawn);
      int wrong = 0, compared = 0;
      for (std::size_t i = 0; i < drawn->id.pixels.size(); ++i) {
        if (drawn->id.pixels[i] == 0 || picture.matte.pixels[i] == 0) continue;
        ++compared;
        wrong += !(drawn->color.pixels[i] == picture.color.pixels[i]);
      }
      INFO(name_of(blend) << ", " << picture.name);
      CHECK(wrong == 0);
      CHECK(compared > 1000);
    }
  }
}

TEST_CASE(
    "a picture that was left out is better made of three views than of the nearest, and a static "
    "texture draws what all eyes share") {
  const Scene scene = test::speckled_sphere(8, 4);
  PictureSet set = shiny_ring(scene, 9, 72);
  const CalibratedPicture left_out = set.pictures[13];
  set.pictures.erase(set.pictures.begin() + 13);
  std::map<Blend, double> psnr;
  for (const Blend blend : {Blend::kNearest, Blend::kBarycentric, Blend::kNeighbours}) {
    const auto surface = TexturedSurface::create(scene, set, blend);
    const auto drawn = surface->draw(left_out.camera, 72, 72, {0, 0, 0, 255});
    REQUIRE(drawn);
    const TextureErrors errors = textured_picture_errors(*drawn, left_out);
    CHECK(errors.covered > 0.99);
    psnr[blend] = errors.psnr;
    if (blend != Blend::kBarycentric) continue;
    const auto fixed = with_static_texture(scene, *surface, 8, 0x1p30);
    REQUIRE(fixed);
    RenderSettings settings;
    settings.shading = Shading::kUnlit;
    settings.background = {0, 0, 0, 255};
    Renderer renderer(*fixed, settings.transfer);
    TexturedPicture again = *drawn;
    again.color =
        renderer.render(*view_of(left_out.camera, 72, 72, box_of(scene)), settings).buffers.color;
    CHECK(textured_picture_errors(again, left_out).psnr > errors.psnr - 6);
  }
  CHECK(psnr[Blend::kBarycentric] > psnr[Blend::kNearest]);
  CHECK(psnr[Blend::kBarycentric] > 25);
}

TEST_CASE(
    "a polygon that is half hidden from a picture has no colour of what hides it: there the others "
    "have its weight (S1-40)") {
  const Scene scene = floor_and_lid();
  constexpr int kSize = 80;
  // From straight above, half of each of the floor's triangles is hidden; from the side, another
  // part.
  const PictureSet set =
      pictures_by(scene, {camera_above(0, kSize), camera_above(50, kSize)}, kSize);
  const PinholeCamera eye = camera_above(20, kSize);
  const PictureSet right = pictures_by(scene, {eye}, kSize);
  for (const Blend blend : {Blend::kNearest, Blend::kBarycentric, Blend::kNeighbours}) {
    INFO(name_of(blend));
    const auto surface = TexturedSurface::create(scene, set, blend);
    for (std::uint32_t polygon = 0; polygon < 2; ++polygon)
      REQUIRE(surface->visible_polygons().sees(0, polygon));
    const auto drawn = surface->draw(eye, kSize, kSize, {0, 0, 0, 255});
    int floor = 0, wrong = 0;
    for (std::size_t i = 0; i < drawn->id.pixels.size(); ++i) {
      if (drawn->id.pixels[i] == 0) continue;
      floor += drawn->id.pixels[i] <= 2;
      wrong += !(drawn->color.pixels[i] == right.pictures[0].color.pixels[i]);
    }
    CHECK(floor > 900);
    CHECK(wrong == 0);
    CHECK(drawn->without_view == 0);
  }
  // With only the picture from above, no view sees the places under the lid.
  const PictureSet above = pictures_by(scene, {camera_above(0, kSize)}, kSize);
  const auto surface = TexturedSurface::create(scene, above, Blend::kBarycentric);
  CHECK(surface->draw(eye, kSize, kSize, {0, 0, 0, 255})->without_view > 50);
}

TEST_CASE("a mirrored surface has the pictures of its own side, drawn anew and as a texture") {
  Scene scene = test::speckled_sphere(6, 4);
  scene.nodes[scene.instances[0].node].world_from_node.at(0, 0) *= -1;
  const PictureSet set = shiny_ring(scene, 8, 64);
  const auto surface = TexturedSurface::create(scene, set, Blend::kBarycentric);
  for (const WorldTriangle& triangle : world_triangles(scene))
    // Away from the origin, the centre of the ball.
    CHECK(triangle.normal().dot(triangle.corners[0]) > 0);
  const Scene fixed = with_static_texture(scene, *surface, 8, 0x1p30).value();
  const CalibratedPicture& picture = set.pictures[3];
  const Framebuffer drawn = UnlitRenderer(fixed).draw(picture.camera, 64, 64).value();
  const TexturedPicture again{drawn.color, drawn.id};
  const TextureErrors errors = textured_picture_errors(again, picture);
  CHECK(errors.covered > 0.99);
  // The result is as good as for the same ball without mirroring.
  const Scene plain = test::speckled_sphere(6, 4);
  const PictureSet plain_set = shiny_ring(plain, 8, 64);
  const auto plain_surface = TexturedSurface::create(plain, plain_set, Blend::kBarycentric);
  const Scene plain_fixed = with_static_texture(plain, *plain_surface, 8, 0x1p30).value();
  const Framebuffer plain_drawn =
      UnlitRenderer(plain_fixed).draw(plain_set.pictures[3].camera, 64, 64).value();
  const double psnr =
      textured_picture_errors({plain_drawn.color, plain_drawn.id}, plain_set.pictures[3]).psnr;
  INFO(errors.psnr << " and " << psnr);
  CHECK(errors.psnr > psnr - 1);
}

TEST_CASE("a blend that leaves a picture out is that of a set that never had it") {
  const Scene scene = test::speckled_sphere(6, 4);
  const PictureSet set = shiny_ring(scene, 5, 48);
  PictureSet others = set;
  others.pictures.erase(others.pictures.begin() + 7);
  const CalibratedPicture& picture = set.pictures[7];
  const auto all = TexturedSurface::create(scene, set, Blend::kNearest);
  for (const Blend blend : {Blend::kNearest, Blend::kBarycentric, Blend::kNeighbours}) {
    const auto anew = TexturedSurface::create(scene, others, blend, 3);
    CHECK(all->with_blend(blend, 3, 7).draw(picture.camera, 48, 48, {})->color.pixels ==
          anew->draw(picture.camera, 48, 48, {})->color.pixels);
  }
}

TEST_CASE("a static texture that would take too many bytes is refused before it is made") {
  const Scene scene = test::speckled_sphere(6, 4);
  const PictureSet set = shiny_ring(scene, 3, 32);
  const auto surface = TexturedSurface::create(scene, set, Blend::kBarycentric);
  const auto refused = with_static_texture(scene, *surface, 64, 0x1p20);
  REQUIRE(!refused);
  CHECK(refused.error().message().starts_with("--texels: "));
  CHECK(with_static_texture(scene, *surface, 8, 0x1p22));
}

}  // namespace glassbox::views
