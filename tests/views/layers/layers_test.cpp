// Layered depth images: how they are packed, merged, warped and drawn (S1-01 to S1-11, C-37, C-80
// to C-86).
#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/mesh/triangulate.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/render/renderer.h>

#include "tests/support/catch.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_builder.h"
#include "views/layers/triangle_normals.h"

using namespace glassbox;
using namespace glassbox::views;

namespace {

Camera camera_at(const Point<World, double>& eye, const Point<World, double>& target,
                 double near = 0.5, double far = 50) {
  Camera camera;
  camera.lens = PerspectiveLens{0.9, near, far};
  camera.world_from_eye = camera_pose(eye, target, {0, 1, 0}).value();
  return camera;
}

View view_at(const Point<World, double>& eye, const Point<World, double>& target, int width = 96,
             int height = 64) {
  return make_view(camera_at(eye, target), width, height).value();
}

RenderSettings plain() {
  RenderSettings settings;
  settings.want_distance = true;
  return settings;
}

LayerCamera small_camera() {
  return layer_camera(view_at({0, 0, 4}, {0, 0, 0}, 4, 3));
}

}  // namespace

TEST_CASE("S1-07: the warp matrix carries a pixel to where the world's point is seen (C-37)") {
  Random random(7);
  // With the depth near / distance, the inverse is exact up to a few roundings for any far / near.
  for (const double far : {10.0, 1e5, 1e9}) {
    const View from = make_view(camera_at({1, 2, 6}, {0, 0, 0}, 1e-2, far), 640, 480).value();
    const View to = make_view(camera_at({1.3, 1.9, 5.7}, {0.1, 0, 0}, 1e-2, far), 640, 480).value();
    const LayerCamera c1 = layer_camera(from), c2 = layer_camera(to);
    const Eigen::Matrix4d warp = warp_matrix(c2, c1);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector4d world{random.between(-2, 2), random.between(-2, 2),
                                  random.between(-2, 2), 1};
      const Eigen::Vector4d in1 = c1.screen_from_world * world, in2 = c2.screen_from_world * world;
      const float depth = float(in1.z() / in1.w());  // as it is stored
      CHECK(double(depth) == Approx(depth_of(from, in1.w())).epsilon(1e-6));
      const Eigen::Vector4d found =
          warp * Eigen::Vector4d(in1.x() / in1.w(), in1.y() / in1.w(), double(depth), 1);
      // A depth with an error of 2^-24 moves the point by that share of its parallax, which is
      // below 640 px.
      const double bound = 640 * 0x1p-23;  // px
      CHECK(std::abs(found.x() / found.w() - in2.x() / in2.w()) < bound);
      CHECK(std::abs(found.y() / found.w() - in2.y() / in2.w()) < bound);
      CHECK(found.w() == Approx(in2.w() / in1.w()).epsilon(1e-6));
    }
  }
}

TEST_CASE("S1-06, C-85: packed from the bottom left, from back to front, and checked") {
  LayerBuilder builder(small_camera(), 0);
  builder.add(3, 2, 0.25f, {1, 0, 0});
  builder.add(3, 2, 0.5f, {2, 0, 0});
  builder.add(3, 2, 0.125f, {3, 0, 0});
  builder.add(0, 0, 0.75f, {4, 0, 0});
  builder.add(1, 2, std::nanf(""), {5, 0, 0});  // nothing
  const LayeredImage image = builder.pack();
  REQUIRE(check(image, "test"));
  CHECK(image.depth == std::vector<float>{0.125f, 0.25f, 0.5f, 0.75f});
  CHECK(image.color[0] == Rgba8{3, 0, 0});
  CHECK(image.first[image.pixel_index(3, 2)] == 0);
  CHECK(image.first[image.pixel_index(0, 0)] == 3);
  const LayerCounts counts = count_layers(image);
  CHECK(counts.samples == 4);
  CHECK(counts.covered == 2);
  CHECK(counts.most == 3);
  CHECK(counts.complexity() == 2);

  // No layers at all, then more layers than a byte can count.
  CHECK(check(LayerBuilder(small_camera(), 0).pack(), "empty"));
  LayerBuilder deep(small_camera(), 0);
  for (int i = 1; i <= 300; ++i) deep.add(2, 1, float(i) / 512, {std::uint8_t(i), 0, 0});
  CHECK(check(deep.pack(), "deep"));
  CHECK(count_layers(deep.pack()).most == 300);

  const auto broken = [&](auto&& change) {
    LayeredImage other = image;
    change(other);
    return !check(other, "broken");
  };
  CHECK(broken([](LayeredImage& i) { std::swap(i.depth[0], i.depth[1]); }));
  CHECK(broken([](LayeredImage& i) { i.depth[3] = 0; }));
  CHECK(broken([](LayeredImage& i) { i.depth[3] = std::nanf(""); }));
  CHECK(broken([](LayeredImage& i) { i.first[5] = 9; }));
  CHECK(broken([](LayeredImage& i) { i.first.pop_back(); }));
  CHECK(broken([](LayeredImage& i) { i.color.pop_back(); }));
  CHECK(broken([](LayeredImage& i) { i.camera.screen_from_world.setZero(); }));
}

TEST_CASE(
    "S1-02, C-84: a chain of near depths is merged from the front, in whatever order it comes") {
  constexpr double kEpsilon = 0x1p-6;
  std::vector<float> chain;
  for (int i = 0; i < 12; ++i)
    chain.push_back(0.5f * std::pow(float(1 - 0.9 * kEpsilon), float(i)));
  Random random(84);
  std::vector<LayeredImage> packed;
  for (int order = 0; order < 20; ++order) {
    LayerBuilder builder(small_camera(), kEpsilon);
    for (std::size_t i = 0; i < chain.size(); ++i)
      builder.add(1, 1, chain[i], {std::uint8_t(i), 9, 9});
    packed.push_back(builder.pack());
    for (std::size_t i = chain.size(); i-- > 1;) {
      std::swap(chain[i], chain[std::size_t(random.integer(0, int(i)))]);
    }
    // Depths within epsilon form a chain. Every other one is merged with the one before it: six are
    // left, not one.
    CHECK(packed.back().samples() == 6);
    CHECK(packed.back().depth == packed.front().depth);
  }
}

TEST_CASE(
    "S1-09: at the view that layers were made from, the picture is that view's, byte for byte") {
  for (const char* name : {"room", "teapot"}) {
    const Scene scene = make_builtin(name).value();
    const Camera camera =
        scene.cameras.empty() ? framing_camera(scene, 1.5).value() : scene.cameras[0];
    const View view = make_view(camera, 96, 64).value();
    Renderer renderer(scene, Transfer::kSrgb);
    const Image<Rgba8> own = renderer.render(view, plain()).buffers.color;
    const LayeredImage image = build_layers(scene, view, plain(), 3);
    REQUIRE(check(image, name));
    for (const LayerOrder order : {LayerOrder::kDepth, LayerOrder::kOcclusion}) {
      for (const Splat splat : {Splat::kPoint, Splat::kProjected}) {
        LayerDrawing drawing;
        drawing.order = order;
        drawing.splat = splat;
        drawing.background = RenderSettings{}.background;
        CHECK(draw_layers(image, image.camera, drawing).color.pixels == own.pixels);
      }
    }
  }
}

TEST_CASE(
    "the picture does not depend on what it is drawn with: every target makes the same bytes") {
  const Scene scene = make_builtin("room").value();
  const View view = make_view(scene.cameras.at(0), 101, 67).value();
  const LayeredImage image = build_layers(scene, view, plain(), 4);
  View beside = view;
  beside.eye_from_world.at(0, 3) -= 0.3;
  beside.eye_from_world.at(2, 3) += 0.7;  // nearer: some samples are behind the eye, some are large
  for (const LayerOrder order : {LayerOrder::kDepth, LayerOrder::kOcclusion}) {
    for (const Splat splat : {Splat::kPoint, Splat::kThree, Splat::kProjected, Splat::kSoft}) {
      LayerDrawing drawing;
      drawing.order = order;
      drawing.splat = splat;
      drawing.target = Target::kScalar;
      const LayerPicture plainly = draw_layers(image, layer_camera(beside), drawing);
      for (const Target target : available_targets()) {
        drawing.target = target;
        const LayerPicture drawn = draw_layers(image, layer_camera(beside), drawing);
        INFO(name_of(target) << ", splat " << int(splat));
        CHECK(drawn.color.pixels == plainly.color.pixels);
        CHECK(drawn.depth.pixels == plainly.depth.pixels);
        CHECK(drawn.counts == plainly.counts);
      }
    }
  }
}

TEST_CASE("3 x 3 pixels of each sample: a pixel shows the nearest of those around it") {
  const Scene scene = make_builtin("room").value();
  const View view = make_view(scene.cameras.at(0), 96, 64).value();
  const LayeredImage image = build_layers(scene, view, plain(), 3);
  View beside = view;
  beside.eye_from_world.at(0, 3) -= 0.2;
  LayerDrawing drawing;
  drawing.splat = Splat::kPoint;
  const LayerPicture points = draw_layers(image, layer_camera(beside), drawing);
  drawing.splat = Splat::kThree;
  const LayerPicture threes = draw_layers(image, layer_camera(beside), drawing);
  for (int y = 1; y + 1 < 64; ++y) {
    for (int x = 1; x + 1 < 96; ++x) {
      float nearest = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx)
          nearest = std::max(nearest, points.depth.at(x + dx, y + dy));
      }
      REQUIRE(threes.depth.at(x, y) == nearest);
    }
  }
  // Samples whose centre is one pixel outside the picture are drawn as well.
  CHECK(threes.counts.drawn > points.counts.drawn);
}

TEST_CASE("S1-10: soft splats are opaque in the middle, half and a quarter of it at the rim") {
  // One white sample on black, from so near that it is 3 pixels large.
  const View from = view_at({0, 0, 9}, {0, 0, 0}, 9, 9);
  LayerBuilder builder(layer_camera(from), 0);
  builder.add(4, 4, float(depth_of(from, 9)), {255, 255, 255});
  const LayeredImage image = builder.pack();
  LayerDrawing drawing;
  drawing.order = LayerOrder::kOcclusion;
  drawing.splat = Splat::kSoft;
  drawing.background = {0, 0, 0};
  const LayerPicture picture =
      draw_layers(image, layer_camera(view_at({0, 0, 3}, {0, 0, 0}, 9, 9)), drawing);
  const auto grey = [&](int x, int y) { return int(picture.color.at(x, y).r); };
  CHECK(grey(4, 4) == 255);
  for (const int step : {-1, 1}) {
    CHECK(grey(4 + step, 4) == 128);
    CHECK(grey(4, 4 + step) == 128);
    CHECK(grey(4 + step, 4 + step) == 64);
    CHECK(grey(4 + step, 4 - step) == 64);
  }
  CHECK(grey(2, 4) == 0);
  CHECK(picture.depth.at(2, 4) == 0);
}

TEST_CASE("S1-02: of samples that are one, that of the lowest rank stays: the camera's own") {
  LayerBuilder builder(small_camera(), 0x1p-6);
  builder.add(1, 1, 0.5f, {1, 0, 0}, 1);
  builder.add(1, 1, 0.4999f, {2, 0, 0}, 0);
  builder.add(1, 1, 0.4998f, {3, 0, 0}, 0);
  builder.add(1, 1, 0.4f, {4, 0, 0}, 2);
  const LayeredImage image = builder.pack();
  REQUIRE(check(image, "ranks"));
  CHECK(image.depth == std::vector<float>{0.4f, 0.4999f});
  CHECK(image.color[1].r == 2);
}

TEST_CASE("the picture does not depend on how many threads draw it") {
  const Scene scene = make_builtin("room").value();
  const View view = make_view(scene.cameras.at(0), 96, 64).value();
  const LayeredImage image = build_layers(scene, view, plain(), 4);
  View beside = view;
  beside.eye_from_world.at(0, 3) -= 0.2;
  LayerDrawing drawing;
  const LayerPicture one = draw_layers(image, layer_camera(beside), drawing);
  for (const int threads : {2, 3, 64}) {
    drawing.threads = threads;
    const LayerPicture many = draw_layers(image, layer_camera(beside), drawing);
    CHECK(many.color.pixels == one.color.pixels);
    CHECK(many.depth.pixels == one.depth.pixels);
    CHECK(many.counts == one.counts);
  }
}

TEST_CASE(
    "C-81, S1-10: magnified by m, points leave 1 - 1/m^2 of a wall, and projected squares "
    "nothing") {
  // A wall that fills the picture, drawn from its own distance, from half and from a quarter of it.
  LayerBuilder builder(layer_camera(view_at({0, 0, 8}, {0, 0, 0}, 64, 64)), 0);
  const View wall = view_at({0, 0, 8}, {0, 0, 0}, 64, 64);
  builder.add_picture(wall, Image<Rgba8>(64, 64, {9, 9, 9}), Image<float>(64, 64, 8.0f));
  const LayeredImage image = builder.pack();
  for (const int m : {1, 2, 4}) {
    const LayerCamera near = layer_camera(view_at({0, 0, 8.0 / m}, {0, 0, 0}, 64, 64));
    LayerDrawing drawing;
    drawing.splat = Splat::kPoint;
    const auto holes = [&] {
      const auto depth = draw_layers(image, near, drawing).depth;
      return double(std::ranges::count(depth.pixels, 0.0f)) / double(depth.pixels.size());
    };
    CHECK(holes() == Approx(1 - 1.0 / (m * m)));
    drawing.splat = Splat::kProjected;
    CHECK(holes() == 0);
  }
}

TEST_CASE("S1-10: a plane that is seen at a slant has no hole inside, from 10 degrees beside") {
  const View from = view_at({0, 0, 8}, {0, 0, 0}, 64, 64);
  const LayerCamera c1 = layer_camera(from);
  // The point where the line from the eye through a pixel meets the plane z = -k x.
  const auto on_plane = [](const LayerCamera& camera, int x, int y, double k) {
    const Eigen::Vector4d at_near =
        camera.screen_from_world.inverse() * Eigen::Vector4d(x + 0.5, y + 0.5, 1, 1);
    const Eigen::Vector3d eye = eye_of(camera).hnormalized(), near = at_near.hnormalized();
    const Eigen::Vector3d normal(k, 0, 1), along = near - eye;
    return Eigen::Vector3d(eye - along * (normal.dot(eye) / normal.dot(along)));
  };
  for (const double slant : {0.0, 1.0, -1.7}) {  // up to 60 degrees
    LayerBuilder builder(c1, 0);
    Image<float> distance(64, 64);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) distance.at(x, y) = float(8 - on_plane(c1, x, y, slant).z());
    }
    builder.add_picture(from, Image<Rgba8>(64, 64, {9, 9, 9}), distance);
    const LayeredImage image = builder.pack();
    for (const double side : {-1.0, 1.0}) {
      const double turn = side * 10 * 3.14159265358979 / 180;
      const LayerCamera c2 =
          layer_camera(view_at({8 * std::sin(turn), 0, 8 * std::cos(turn)}, {0, 0, 0}, 64, 64));
      const LayerPicture picture = draw_layers(image, c2, {});
      std::size_t inside = 0;
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
          const Eigen::Vector3d there = on_plane(c2, x, y, slant);
          const Eigen::Vector3d seen = (c1.screen_from_world * there.homogeneous()).hnormalized();
          const bool in_first = seen.x() > 1 && seen.x() < 63 && seen.y() > 1 && seen.y() < 63;
          inside += in_first;
          if (in_first) CHECK(picture.depth.at(x, y) != 0);
        }
      }
      CHECK(inside > 1000);
    }
  }
}

TEST_CASE("S1-10: a plane's stored normal gives every sample its size, at the plane's edge, too") {
  // A column of a plane z = -2 x that is one pixel wide: its samples have no neighbours from which
  // the slope could be computed.
  const View from = view_at({0, 0, 8}, {0, 0, 0}, 64, 64);
  const LayerCamera c1 = layer_camera(from);
  LayerBuilder with(c1, 0, {.normals = true}), without(c1, 0);
  LayerBuilder whole(c1, 0);
  const SampleNormal normal = stored_normal(2, 0, 1);
  for (int y = 0; y < 64; ++y) {
    for (int x = 20; x < 44; ++x) {
      const Eigen::Vector4d on_ray =
          c1.screen_from_world.inverse() * Eigen::Vector4d(x + 0.5, y + 0.5, 1, 1);
      const Eigen::Vector3d along = on_ray.hnormalized() - Eigen::Vector3d(0, 0, 8);
      const double t = -8 / (2 * along.x() + along.z());
      const float depth = float(depth_of(from, -t * along.z()));
      whole.add(x, y, depth, {9, 9, 9});
      if (x != 32) continue;
      with.add(x, y, depth, {9, 9, 9}, 0, {normal, 7});
      without.add(x, y, depth, {9, 9, 9});
    }
  }
  const LayerCamera side = layer_camera(view_at({6, 0, 6}, {0, 0, 0}, 64, 64));
  const auto covered = [&](const LayerBuilder& builder) {
    const LayerPicture picture = draw_layers(builder.pack(), side, {});
    std::size_t count = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) count += y >= 8 && y < 56 && picture.depth.at(x, y) != 0;
    }
    return count;
  };
  // The whole plane, whose slope follows from neighbours. Without a normal the single column is as
  // wide as if it faced its own eye.
  LayeredImage all = whole.pack();
  CHECK(2 * covered(with) > 3 * covered(without));
  const LayeredImage image = with.pack();
  REQUIRE(check(image, "normals"));
  CHECK(image.normal.size() == image.samples());
  CHECK(image.triangle.empty());
  // Both ways to get the slope agree where both are possible.
  LayeredImage known = all;
  known.normal.assign(known.samples(), normal);
  const LayerPicture by_neighbours = draw_layers(all, side, {}),
                     by_normals = draw_layers(known, side, {});
  std::size_t differ = 0;
  for (std::size_t i = 0; i < by_normals.depth.pixels.size(); ++i)
    differ += (by_normals.depth.pixels[i] != 0) != (by_neighbours.depth.pixels[i] != 0);
  CHECK(differ <= 2 * 64);  // at the two sides, whose samples are larger by a rounding
}

TEST_CASE("normals are those of the triangles that samples are of, by their numbers") {
  const Scene scene = make_builtin("room").value();
  const View view = make_view(scene.cameras.at(0), 48, 32).value();
  RenderSettings settings = plain();
  settings.want_id = true;
  const std::vector<SampleNormal> normals = triangle_normals(scene);
  LayerBuilder builder(layer_camera(view), 0, {.normals = true, .triangles = true});
  const std::vector<Layer> layers = peel(scene, view, settings, 3);
  for (const Layer& layer : layers) builder.add_layer(view, layer, normals);
  const LayeredImage image = builder.pack();
  REQUIRE(check(image, "room"));
  std::vector<bool> has_two_sides{false};  // by number, from 1 on
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const Face& face : mesh.faces)
      has_two_sides.insert(has_two_sides.end(), triangle_number_count(face),
                           scene.materials[mesh.material].double_sided);
  }
  std::size_t known = 0, backs = 0;
  const Eigen::Vector3d eye = eye_of(image.camera).hnormalized();
  const Eigen::Matrix4d world_from_screen = image.camera.screen_from_world.inverse();
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 48; ++x) {
      const std::size_t place = image.pixel_index(x, y);
      for (std::uint32_t i = image.first[place]; i < image.first[place + 1]; ++i) {
        REQUIRE(image.triangle[i] > 0);
        CHECK(image.normal[i] == normals.at(image.triangle[i]));
        known += image.normal[i].is_known();
        const Eigen::Vector4d at(x + 0.5, y + 0.5, double(image.depth[i]), 1);
        const Eigen::Vector3d to_eye = eye - (world_from_screen * at).hnormalized();
        const SampleNormal& n = image.normal[i];
        // A normal is 127 long, and each component is off by at most a half. Back sides are seen
        // only of double-sided materials.
        const double towards = to_eye.normalized().dot(Eigen::Vector3d(n.x, n.y, n.z));
        const bool is_back = towards < -0.5 * std::sqrt(3.0);
        REQUIRE((!is_back || has_two_sides[image.triangle[i]]));
        backs += is_back;
      }
    }
  }
  CHECK(known == image.samples());
  CHECK(backs < known / 2);
  // The nearest and the farthest samples keep their normals and numbers.
  const LayeredImage ends = nearest_and_farthest(image);
  REQUIRE(check(ends, "ends"));
  CHECK(ends.normal.size() == ends.samples());
  CHECK(ends.triangle.size() == ends.samples());
}

TEST_CASE(
    "C-83, C-86: what is behind the eye is left out, and a sample in its face is cut and counted") {
  LayerBuilder builder(layer_camera(view_at({0, 0, 8}, {0, 0, 0}, 64, 64)), 0);
  const View from = view_at({0, 0, 8}, {0, 0, 0}, 64, 64);
  builder.add_picture(from, Image<Rgba8>(64, 64, {9, 9, 9}), Image<float>(64, 64, 3.0f));
  const LayeredImage image = builder.pack();
  // The wall is at z = 5, and the other eye is beyond it.
  const auto passed = draw_layers(image, layer_camera(view_at({0, 0, 4}, {0, 0, 0}, 64, 64)), {});
  CHECK(passed.counts.behind == image.samples());
  CHECK(std::ranges::count(passed.depth.pixels, 0.0f) == 64 * 64);
  // Nothing is drawn between the near plane and the eye.
  const auto at_near =
      draw_layers(image, layer_camera(view_at({0, 0, 5.25}, {0, 0, 0}, 64, 64)), {});
  CHECK(at_near.counts.outside == image.samples());
  // A near plane of 0.001: each sample is 3 / 0.01 pixels large.
  const View face = make_view(camera_at({0, 0, 5.01}, {0, 0, 0}, 1e-3, 50), 64, 64).value();
  CHECK(draw_layers(image, layer_camera(face), {}).counts.oversized > 0);
}

TEST_CASE("a wall on the near plane is drawn whole, from wherever its own view looks") {
  // The warp in float changes their depth, 1, by a rounding, possibly to more than 1.
  Random random(83);
  for (int i = 0; i < 60; ++i) {
    const auto some = [&](double most) { return random.between(-most, most); };
    const Point<World, double> eye{some(9), some(9), some(9)};
    const Point<World, double> target{some(1), some(1), some(1)};
    const Camera camera = camera_at(eye, target, random.between(0.01, 3));
    const LayerCamera own = layer_camera(make_view(camera, 64, 48).value());
    LayerBuilder builder(own, 0);
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) builder.add(x, y, 1.0f, {9, 9, 9});
    }
    const LayeredImage wall = builder.pack();
    for (const Splat splat : {Splat::kPoint, Splat::kProjected}) {
      LayerDrawing drawing;
      drawing.splat = splat;
      CHECK(draw_layers(wall, own, drawing).counts.drawn == 64 * 48);
    }
  }
  // A point a thousandth nearer is between the near plane and the eye.
  LayerBuilder nearer(small_camera(), 0);
  nearer.add(1, 1, 1.001f, {9, 9, 9});
  CHECK(draw_layers(nearer.pack(), small_camera(), {}).counts.outside == 1);
}

TEST_CASE("threads that have nothing to do, or no memory for a picture of their own, draw none") {
  LayerCamera from = small_camera(), to = small_camera();
  from.height = 64;
  LayerDrawing drawing;
  drawing.threads = 300;
  CHECK(threads_that_draw(from, to, drawing) == 8);  // of 8 rows each
  from.height = 16384;
  CHECK(threads_that_draw(from, to, drawing) == 300);
  to.width = 3840;
  to.height = 2160;
  const int threads = threads_that_draw(from, to, drawing);
  CHECK(threads > 1);
  CHECK(std::size_t(threads) * 8 * 3840 * 2160 <= kMaxCanvasBytes);
  to.width = to.height = 16384;
  CHECK(threads_that_draw(from, to, drawing) == 1);
  drawing.order = LayerOrder::kOcclusion;
  CHECK(threads_that_draw(from, small_camera(), drawing) == 1);
}

TEST_CASE(
    "S1-11, C-82: the order of visits runs towards an epipole before the camera, and away from one "
    "behind") {
  // Inside the picture, in front of the camera.
  CHECK(visiting_order(2.5 * 1, 1, 5) == std::vector<int>{0, 1, 4, 3, 2});
  // Inside, behind the camera.
  CHECK(visiting_order(-2.5, -1, 5) == std::vector<int>{3, 4, 2, 1, 0});
  CHECK(visiting_order(9, 1, 3) == std::vector<int>{0, 1, 2});  // outside the picture
  CHECK(visiting_order(-9, 1, 3) == std::vector<int>{2, 1, 0});
  CHECK(visiting_order(1, 0, 3) == std::vector<int>{0, 1, 2});  // at infinity
  CHECK(visiting_order(-1, 0, 3) == std::vector<int>{2, 1, 0});
}

TEST_CASE("S1-11: along a row of a stereo pair, what is visited later is nearer") {
  // The eyes are side by side: rows stay rows, and two samples that meet in a pixel are on one
  // line. All depths are chosen so that samples move to pixel centres, where the order is exact.
  const View left = view_at({0, 0, 0}, {0, 0, -1}, 64, 8);
  const LayerCamera from = layer_camera(left);
  const double pixels = from.screen_from_world(0, 0);  // per unit at distance 1
  Random random(82);
  for (const double side : {1.0, -1.0}) {
    LayerBuilder builder(from, 0);
    for (int i = 0; i < 600; ++i) {
      // Parallaxes of whole pixels: near / distance = n near / (pixels * baseline), with baseline
      // 1.
      const double depth = double(random.integer(1, 30)) * 0.5 / pixels;
      const int x = int(random.integer(0, 63)), y = int(random.integer(0, 7));
      builder.add(x, y, float(depth),
                  {std::uint8_t(random.integer(0, 255)), std::uint8_t(i), std::uint8_t(i >> 8)});
    }
    const LayeredImage image = builder.pack();
    const LayerCamera to = layer_camera(view_at({side, 0, 0}, {side, 0, -1}, 64, 8));
    LayerDrawing drawing;
    drawing.splat = Splat::kPoint;
    const LayerPicture by_depth = draw_layers(image, to, drawing);
    drawing.order = LayerOrder::kOcclusion;
    const LayerPicture by_order = draw_layers(image, to, drawing);
    CHECK(by_depth.counts == by_order.counts);
    CHECK(by_depth.counts.drawn > 100);
    CHECK(by_depth.color.pixels == by_order.color.pixels);
  }
}
