#include <array>

#include "study/extremes/cases/clip_case.h"
#include "study/extremes/kit/extreme_case.h"
#include "study/extremes/kit/screen_scene.h"
#include "study/extremes/kit/sight.h"
#include "study/extremes/kit/world.h"

#include <glassbox/mesh/builtin/cube.h>
#include <glassbox/mesh/builtin/sphere.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox::study {
namespace c42 {

using Verdict = ClipVerdict (*)(std::span<const Outcode>);

Outcome judge(Verdict verdict) {
  Random random(742);
  const auto planes = frustum_planes();
  int wrong = 0, spared = 0;
  constexpr int kTriangles = 20000;
  for (int i = 0; i < kTriangles; ++i) {
    // Small ones, most of which are wholly inside or outside.
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
  if (spared < kTriangles / 10) return must_be_zero(HUGE_VAL, "hardly any clipping spared");
  return wrong_of(wrong, kTriangles, "triangles differ from the clipped ones",
                  fmt::format("; clipping spared for {}", spared));
}

// Outside is outside, whichever the planes: loses what reaches across a corner of the picture.
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

// What may be spared of whole draws and of parts of them: 60 cubes around the eye, of which few are in the picture, behind two
// walls with a gap between them; cubes of which walls hide most; then a ball of 1,152 triangles that reaches out of it.
Vista cubes_and_walls() {
  Random random(842);
  Scene scene = make_cube();
  const auto add = [&](const Transform<World, Object>& place) {
    scene.nodes.push_back({"", kNone, place, place});
    scene.instances.push_back({0, std::uint32_t(scene.nodes.size() - 1)});
  };
  scene.instances.clear();
  for (int i = 0; i < 60; ++i) {
    const auto coordinate = [&] { return random.between(-9, 9); };
    const double size = random.between(0.2, 0.8);
    add(translate<World>({coordinate(), coordinate(), coordinate()}) *
        scale<World, Object>(size, size, size));
  }
  for (const double x : {-4.5, 5.5}) {
    add(translate<World>({x, 0.0, -3.0}) * scale<World, Object>(4, 5, 0.1));
  }
  return vista_of(scene, camera_at({0, 0, 8}, {0, 0, -1}), 96, 96);
}

// Two walls with a gap that is two pixels wide, and 104 cubes that are behind them, look out or poke through.
Vista cubes_behind_walls() {
  Random random(942);
  Scene scene = make_cube();
  scene.instances.clear();
  const auto add = [&](const Transform<World, Object>& place) {
    scene.nodes.push_back({"", kNone, place, place});
    scene.instances.push_back({0, std::uint32_t(scene.nodes.size() - 1)});
  };
  Mesh pane;
  for (const float left : {-8.2f, 0.3f}) {
    const Point<Object> a{left, -2.5f, 2}, b{left + 8, -2.5f, 2}, c{left + 8, 2.5f, 2},
        d{left, 2.5f, 2};
    add_triangle(pane, {a, b, c});
    add_triangle(pane, {a, c, d});
  }
  scene.meshes.push_back(pane);
  add({});
  scene.instances.back().mesh = 1;
  for (int i = 0; i < 80; ++i) {
    const double size = random.between(0.05, 1.5);
    add(translate<World>({random.between(-4, 4), random.between(-6, 6), random.between(-6, 2)}) *
        scale<World, Object>(size, size, size));
  }
  // Small ones half way through the walls.
  for (int i = 0; i < 24; ++i) {
    add(translate<World>({random.between(-3, 3), random.between(-2, 2), 2.0}) *
        scale<World, Object>(0.2, 0.2, 0.2));
  }
  return vista_of(scene, camera_at({0, 0, 8}, {0, 0, -1}), 128, 128);
}

Outcome judge_drawn(const Drawer& by) {
  static const std::vector<SightDrawn> pictures = [] {
    std::vector<SightDrawn> all;
    all.emplace_back(cubes_and_walls());
    all.emplace_back(cubes_behind_walls());
    for (const WorldPoint& eye : {WorldPoint{0.9, 0.6, 0.9}, {0.2, 1.3, -0.4}}) {
      Vista vista = vista_of(make_sphere(24), camera_at(eye, {0.2, -0.4, -1}), 64, 64);
      vista.settings.cull = Cull::kBack;
      all.emplace_back(std::move(vista));
    }
    return all;
  }();
  return worst_of(pictures, by);
}

}  // namespace c42

ExtremeCase c42_trivial_accept() {
  using namespace c42;
  return {
      .id = "C-42",
      .name = "Clipping spared",
      .construction = "20000 small triangles in and around the frustum",
      .stage = "clip",
      .right = "what is accepted is what clipping returns, bit for bit; what is rejected, nothing",
      .unit = "triangles",
      .oracle = Oracle::kProperty,
      .ours = {"trivial_verdict of the outcodes", [] { return judge(trivial_verdict); }},
      .naive = {"rejected where every corner is outside",
                [] { return judge(all_corners_outside); }},
      .mutants = {{"accepted where one corner is inside", [] { return judge(one_corner_inside); }}},
      .drawn = judge_drawn,
  };
}

}  // namespace glassbox::study
