#include "study/extremes/common/stereo_scene.h"

#include <cmath>
#include <utility>
#include <variant>

#include <glassbox/mesh/bounding_box.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/render/staged/staged.h>

namespace glassbox::study {

StereoScene make_stereo_scene(const std::string& name, double share, int width, int height) {
  StereoScene made;
  made.scene = make_builtin(name).value();
  const Camera camera = made.scene.cameras.empty()
                            ? framing_camera(made.scene, double(width) / height).value()
                            : made.scene.cameras.front();
  made.centre = make_view(camera, width, height).value();
  const double distance = -(made.centre.eye_from_world * bounds(made.scene).center()).z;
  const bool in_sight = distance > made.centre.near && distance < made.centre.far;
  made.pair.window = in_sight ? distance : 10 * made.centre.near;
  made.pair.half_separation = share * made.pair.window;
  return made;
}

EyePictures draw_eyes_separately(const StereoScene& s) {
  const auto eye = [&](Side side) {
    return render_staged(s.scene, eye_view(s.centre, s.pair, side), {}).buffers.color;
  };
  return {eye(Side::kLeft), eye(Side::kRight)};
}

RayScene eye_ray_scene(RayScene centre, const StereoPair& pair, Side side) {
  const auto& lens = std::get<PerspectiveLens>(centre.lens);
  const Viewport& viewport = centre.view.viewport;
  const double shift = eye_shift(pair, side), height = std::tan(lens.fovy_radians / 2) * lens.near;
  const double width = height * double(viewport.width()) / double(viewport.height());
  const double skew = shift * lens.near / pair.window;
  centre.lens = FrustumLens{skew - width, skew + width, -height, height, lens.near, lens.far};
  for (ExactEyeTriangle& triangle : centre.triangles) {
    for (auto& corner : triangle.corners) corner[0] += shift;
  }
  return centre;
}

TestedEngine engine_for_eye(const TestedEngine& engine, const StereoPair& pair, Side side) {
  const auto draw = [=](const Scene& scene, const View& centre, const RenderSettings& settings) {
    StereoSettings both;
    both.render = settings;
    StereoRendering drawn =
        engine.renderer(scene, settings.transfer).render_pair(centre, pair, both);
    return side == Side::kLeft ? Rendering{std::move(drawn.left), drawn.left_statistics}
                               : Rendering{std::move(drawn.right), drawn.right_statistics};
  };
  return {engine.name, draw, {}};
}

StereoReference::StereoReference(const RayScene& centre, const StereoPair& pair)
    : pair_(pair),
      left_(eye_ray_scene(centre, pair, Side::kLeft)),
      right_(eye_ray_scene(centre, pair, Side::kRight)) {}

Outcome StereoReference::measure_error(const TestedEngine& engine) const {
  return worse_of(left_.measure_error(engine_for_eye(engine, pair_, Side::kLeft)),
                  right_.measure_error(engine_for_eye(engine, pair_, Side::kRight)));
}

std::uint64_t pixels_that_differ(const Image<Rgba8>& a, const Image<Rgba8>& b) {
  if (a.pixels.size() != b.pixels.size()) return a.pixels.size() + b.pixels.size();
  std::uint64_t differ = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) differ += a.pixels[i] != b.pixels[i];
  return differ;
}

std::uint64_t pixels_that_differ(const EyePictures& a, const EyePictures& b) {
  return pixels_that_differ(a.left, b.left) + pixels_that_differ(a.right, b.right);
}

View view_from_origin(int width, int height, double near, double far) {
  Camera camera;
  camera.lens = PerspectiveLens{0.785398163397448309616, near, far};
  return make_view(camera, width, height).value();
}

}  // namespace glassbox::study
