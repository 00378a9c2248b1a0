#include <array>

#include "study/extremes/cases/clip_case.h"
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/far_panes.h"
#include "study/extremes/common/ray_cast.h"
#include "study/extremes/common/screen_scene.h"

#include <glassbox/mesh/builtin/cube.h>
#include <glassbox/mesh/builtin/sphere.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox::study {
namespace c42 {

using Verdict = ClipVerdict (*)(std::span<const Outcode>);

Outcome measure_error(Verdict verdict) {
  Random random(742);
  const auto planes = frustum_planes();
  int wrong = 0, spared = 0;
  constexpr int kTriangles = 20000;
  for (int i = 0; i < kTriangles; ++i) {
    // Small triangles, most of which are completely inside or completely outside.
    const Point<Clip> a = random_position(random, 0.5, 1.5);
    const auto beside = [&] {
      const double x = random.between(-0.5, 0.5), y = random.between(-0.5, 0.5);
      return Point<Clip>{a.x + float(x), a.y + float(y), a.z + float(random.between(-0.2, 0.2)),
                         a.w};
    };
    const Point<Clip> b = beside();
    const ClipTriangle t = clip_corners(a, b, beside());
    std::array<Outcode, 3> codes;
    for (std::size_t k = 0; k < 3; ++k) codes[k] = outcode(t[k].position, planes);
    const Outline clipped = pipeline_clips(t, planes);
    const ClipVerdict found = verdict(codes);
    const Outline whole{t[0].position, t[1].position, t[2].position};
    wrong += (found == ClipVerdict::kAccept && clipped != whole) ||
             (found == ClipVerdict::kReject && !clipped.empty());
    spared += found != ClipVerdict::kClip;
  }
  if (spared < kTriangles / 10)
    return must_be_zero(HUGE_VAL, "clipping was avoided for less than a tenth of the triangles");
  return wrong_count_outcome(wrong, kTriangles, "triangles differ from the clipped ones",
                             fmt::format("; clipping was avoided for {}", spared));
}

// Rejects a triangle if each corner is outside some plane, even if it is not the same plane for
// all. This loses triangles that reach across a corner of the picture.
ClipVerdict all_corners_outside(std::span<const Outcode> codes) {
  bool any = false, all = true;
  for (const Outcode code : codes) {
    any = any || code != 0;
    all = all && code != 0;
  }
  return all ? ClipVerdict::kReject : any ? ClipVerdict::kClip : ClipVerdict::kAccept;
}
ClipVerdict one_corner_inside(std::span<const Outcode> codes) {
  for (const Outcode code : codes) {
    if (code == 0) return ClipVerdict::kAccept;
  }
  return trivial_verdict(codes);
}

// The pictures below test what an engine may skip for whole draws or for parts of them. Adds an
// instance of a mesh at a place.
void add_at(Scene& scene, const Transform<World, Object>& place, std::uint32_t mesh = 0) {
  scene.instances.push_back({mesh, std::uint32_t(scene.nodes.size())});
  scene.nodes.push_back({"", kNone, place, place});
}
void add_cube(Scene& scene, const WorldVector& centre, const WorldVector& half) {
  add_at(scene, translate<World>(centre) * scale<World, Object>(half.x, half.y, half.z));
}
Scene no_cubes() {
  Scene scene = make_cube();
  scene.instances.clear();
  return scene;
}
Camera from_before() {
  return camera_at({0, 0, 8}, {0, 0, -1});
}

// 60 cubes around the eye, few of which are in the picture, and two walls.
RayScene cubes_and_walls() {
  Random random(842);
  Scene scene = no_cubes();
  for (int i = 0; i < 60; ++i) {
    const auto coordinate = [&] { return random.between(-9, 9); };
    const double size = random.between(0.2, 0.8);
    add_cube(scene, {coordinate(), coordinate(), coordinate()}, {size, size, size});
  }
  for (const double x : {-4.5, 5.5}) add_cube(scene, {x, 0.0, -3.0}, {4, 5, 0.1});
  return make_ray_scene(scene, from_before(), 96, 96);
}

// Two rectangles with a gap of ten pixels between them, and 104 cubes: some are behind the
// rectangles, some are partly visible beside them, some stick through them.
RayScene cubes_behind_panes() {
  Random random(942);
  Scene scene = no_cubes();
  Mesh panes;
  for (const float left : {-8.2f, 0.3f}) {
    const Point<Object> a{left, -2.5f, 2}, b{left + 8, -2.5f, 2}, c{left + 8, 2.5f, 2},
        d{left, 2.5f, 2};
    add_triangle(panes, {a, b, c});
    add_triangle(panes, {a, c, d});
  }
  scene.meshes.push_back(panes);
  add_at(scene, {}, 1);
  for (int i = 0; i < 80; ++i) {
    const double x = random.between(-4, 4), y = random.between(-6, 6);
    const double z = random.between(-6, 2), size = random.between(0.05, 1.5);
    add_cube(scene, {x, y, z}, {size, size, size});
  }
  for (int i = 0; i < 24; ++i) {
    const double x = random.between(-3, 3), y = random.between(-2, 2);
    add_cube(scene, {x, y, 2}, {0.2, 0.2, 0.2});
  }
  return make_ray_scene(scene, from_before(), 128, 128);
}

Scene pane() {
  Scene scene = no_cubes();
  Mesh& mesh = scene.meshes[0] = {};
  const Point<Object> a{-1, -1, 0}, b{1, -1, 0}, c{1, 1, 0}, d{-1, 1, 0};
  add_triangle(mesh, {a, b, c});
  add_triangle(mesh, {a, c, d});
  return scene;
}

// 1280 rectangles around the eye, so many that the engine plans them in groups. Most groups extend
// beyond the picture, and some extend behind the eye.
RayScene panes_in_groups() {
  Random random(1042);
  Scene scene = pane();
  for (int i = 0; i < 1280; ++i) {
    const auto coordinate = [&] { return random.between(-9, 9); };
    const double x = coordinate(), y = coordinate(), size = random.between(0.05, 0.3);
    // z goes from -13 to 5: fewer rectangles are behind the eye than in front, so that some groups
    // extend to both sides of the eye.
    const double z = coordinate() - 4, turn = random.between(-60, 60);
    add_at(scene, translate<World>(WorldVector{x, y, z}) *
                      rotate_degrees<World>({0, 1, 0}, turn).value() *
                      scale<World, Object>(size, size, size));
  }
  return make_ray_scene(scene, camera_at({0, 0, 0}, {0, 0, -1}), 32, 32);
}

// Two copies of a rectangle. One is flattened into the plane where w is 1, so that it needs no
// divide. The copy behind it needs the divide, and shows its texture in perspective.
RayScene panes_with_and_without_divide() {
  Scene scene = pane();
  add_at(scene, translate<World>(WorldVector{-0.25, 0, -1}) * scale<World, Object>(0.2, 0.2, 0));
  add_at(scene, translate<World>(WorldVector{0.75, 0, -3}) *
                    rotate_degrees<World>({0, 1, 0}, 60).value() *
                    scale<World, Object>(0.75, 0.75, 1));
  RayScene ray_scene = make_ray_scene(scene, camera_at({0, 0, 0}, {0, 0, -1}), 64, 64);
  add_numbered_texels(ray_scene, {8, 8});
  return ray_scene;
}

// A ball of 2,208 triangles, seen from so near that it extends beyond the picture.
RayScene near_ball(const WorldPoint& eye) {
  RayScene ray_scene = make_ray_scene(make_sphere(24), camera_at(eye, {0.2, -0.4, -1}), 64, 64);
  ray_scene.settings.cull = Cull::kBack;
  return ray_scene;
}

// Rectangles at the near plane. The exact place of some is in front of the plane, and the computed
// place on the plane or behind it.
Outcome measure_near_pane_error(const TestedEngine& engine) {
  PixelChanges all;
  for (int i = 0; i < 200; ++i) {
    const float z = 1e6f + float(i) * 0.0625f;
    const double scale = 1 + i * 1e-7;
    const PixelChanges found =
        compare_with_added_triangle(engine, {{z, 1e-5 * scale, (double(z) * scale - 1e6) * 1e-5}});
    all.changed += found.changed;
    all.shown += found.shown;
  }
  if (all.shown == 0) return must_be_zero(HUGE_VAL, "no pane was drawn");
  return wrong_count_outcome(int(all.changed), int(all.shown),
                             "pixels of panes change if their mesh has more triangles");
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> pictures = [] {
    std::vector<RayCastReference> all;
    all.emplace_back(cubes_and_walls());
    all.emplace_back(cubes_behind_panes());
    all.emplace_back(panes_in_groups());
    all.emplace_back(panes_with_and_without_divide());
    for (const WorldPoint& eye : {WorldPoint{0.9, 0.6, 0.9}, {0.2, 1.3, -0.4}}) {
      all.emplace_back(near_ball(eye));
    }
    return all;
  }();
  return worse_of(worst_of(pictures, engine), measure_near_pane_error(engine));
}

}  // namespace c42

ExtremeCase c42_trivial_accept() {
  using namespace c42;
  return {
      .id = "C-42",
      .name = "Clipping that is not needed",
      .construction = "20000 small triangles in and around the frustum",
      .stage = "clip",
      .right_answer =
          "for an accepted triangle clipping returns the same, bit for bit; for a rejected one it "
          "returns nothing",
      .unit = "triangles",
      .oracle = Oracle::kProperty,
      .ours = {"trivial_verdict from the outcodes", [] { return measure_error(trivial_verdict); }},
      .naive = {"a triangle is rejected if every corner is outside some plane",
                [] { return measure_error(all_corners_outside); }},
      .mutants = {{"a triangle is accepted if one corner is inside",
                   [] { return measure_error(one_corner_inside); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
