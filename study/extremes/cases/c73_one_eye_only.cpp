#include <array>

#include <glassbox/pipeline/stereo/culling.h>
#include <glassbox/render/stereo/disparity.h>
#include <glassbox/render/stereo/monocular.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/screen_scene.h"
#include "study/extremes/common/stereo_scene.h"

namespace glassbox::study {
namespace c73 {

// A wall at the window, 10 units away, and small triangles 0.5 units away, side by side. They are
// tilted, so that the light gives them different shades; each eye sees some that the other eye does
// not see.
StereoScene close_things() {
  Mesh mesh;
  add_triangle(
      mesh, {Point<Object>(-20, -20, -10), Point<Object>(20, -20, -10), Point<Object>(0, 30, -10)});
  for (int i = -8; i <= 8; ++i) {
    const float x = float(i) * 0.1f;
    add_triangle(mesh, {Point<Object>(x, -0.05f, -0.5f), Point<Object>(x + 0.05f, -0.05f, -0.5f),
                        Point<Object>(x, 0.1f, -0.45f)});
  }
  Material material;
  material.double_sided = true;
  return {scene_of(std::move(mesh), material), view_from_origin(320, 180, 0.1), {0.3, 10}};
}

// Decides whether a triangle is kept, from its corners in the clip spaces of both eyes.
using KeepTest = std::function<bool(const std::array<Point<Clip>, 3>& left,
                                    const std::array<Point<Clip>, 3>& right, const View& centre)>;

StereoScene culled(const StereoScene& whole, const KeepTest& keeps) {
  StereoScene rest = whole;
  Mesh& mesh = rest.scene.meshes[0];
  mesh.faces.clear();
  const auto clip = [&](Side side, const Point<Object>& p) {
    return round_to_float(eye_view(whole.centre, whole.pair, side).clip_from_eye) *
           Point<Eye>(p.x, p.y, p.z);
  };
  for (const Face& face : whole.scene.meshes[0].faces) {
    std::array<Point<Clip>, 3> left, right;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point<Object>& p = mesh.positions[mesh.corners[face.first + k].position];
      left[k] = clip(Side::kLeft, p);
      right[k] = clip(Side::kRight, p);
    }
    if (keeps(left, right, whole.centre)) mesh.faces.push_back(face);
  }
  return rest;
}

bool seen_by(const std::array<Point<Clip>, 3>& clip) {
  std::array<Outcode, 3> codes;
  const auto planes = frustum_planes();
  for (std::size_t k = 0; k < 3; ++k) codes[k] = outcode(clip[k], planes);
  return trivial_verdict(codes) != ClipVerdict::kReject;
}

Outcome measure_error(const EyePictures& drawn, const std::string& more = {}) {
  const std::uint64_t differ = pixels_that_differ(drawn, draw_eyes_separately(close_things()));
  return must_be_zero(double(differ), fmt::format("{} pixels are lost{}", differ, more));
}

Outcome measure_our_error() {
  const StereoScene s = close_things();
  StereoSettings settings;
  settings.render.want_distance = true;
  const StereoRendering drawn = render_pair(s.scene, s.centre, s.pair, settings);
  const MonocularMaps maps = monocular_maps(disparity_map(s.centre, s.pair, drawn.left.distance),
                                            disparity_map(s.centre, s.pair, drawn.right.distance));
  return measure_error(
      {drawn.left.color, drawn.right.color},
      fmt::format("; {} pixels are reported as seen by one eye alone",
                  count_monocular(maps.left).all() + count_monocular(maps.right).all()));
}

Outcome measure_drawn_error(const TestedEngine& engine) {
  static const StereoReference things = [] {
    const StereoScene s = close_things();
    Camera camera;
    camera.lens = PerspectiveLens{0.785398163397448309616, 0.1, 1000.0};
    return StereoReference(make_ray_scene(s.scene, camera, 320, 180), s.pair);
  }();
  return things.measure_error(engine);
}

Outcome measure_culling_error(const KeepTest& keeps) {
  return measure_error(draw_eyes_separately(culled(close_things(), keeps)));
}

}  // namespace c73

ExtremeCase c73_one_eye_only() {
  using namespace c73;
  return {
      .id = "C-73",
      .name = "Seen by one eye alone",
      .construction =
          "a wall at the window, at the distance 10, and 17 small triangles at the distance 0.5; "
          "half of the separation is 0.3",
      .stage = "stereo culling",
      .right_answer = "each eye's picture has the bytes of a run for that eye alone",
      .unit = "pixels",
      .oracle = Oracle::kProperty,
      .ours = {"a triangle is culled if neither eye sees it", measure_our_error},
      .naive = {"a triangle is kept only if both eyes see it",
                [] {
                  return measure_culling_error(
                      [](const auto& left, const auto& right, const View&) {
                        return seen_by(left) && seen_by(right);
                      });
                }},
      .mutants = {{"a triangle is culled if the left eye does not see it",
                   [] {
                     return measure_culling_error(
                         [](const auto& left, const auto&, const View&) { return seen_by(left); });
                   }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
