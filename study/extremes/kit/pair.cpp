#include "study/extremes/kit/pair.h"

#include <cmath>
#include <utility>
#include <variant>

#include <glassbox/mesh/bounds.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/render/staged/staged.h>

namespace glassbox::study {

PairScene pair_scene(const std::string& name, double share, int width, int height) {
  PairScene made;
  made.scene = make_builtin(name).value();
  const Camera camera = made.scene.cameras.empty()
                            ? frame(made.scene, double(width) / height).value()
                            : made.scene.cameras.front();
  made.centre = make_view(camera, width, height).value();
  const double distance = -(made.centre.eye_from_world * bounds(made.scene).center()).z;
  const bool in_sight = distance > made.centre.near && distance < made.centre.far;
  made.pair.window = in_sight ? distance : 10 * made.centre.near;
  made.pair.half_separation = share * made.pair.window;
  return made;
}

EyePictures each_eye_alone(const PairScene& s) {
  const auto eye = [&](Side side) {
    return render_staged(s.scene, eye_view(s.centre, s.pair, side), {}).buffers.color;
  };
  return {eye(Side::kLeft), eye(Side::kRight)};
}

Vista seen_by(Vista centre, const StereoPair& pair, Side side) {
  const auto& lens = std::get<PerspectiveLens>(centre.lens);
  const Viewport& viewport = centre.view.viewport;
  const double shift = eye_shift(pair, side), height = std::tan(lens.fovy_radians / 2) * lens.near;
  const double width = height * double(viewport.width()) / double(viewport.height());
  const double skew = shift * lens.near / pair.window;
  centre.lens = FrustumLens{skew - width, skew + width, -height, height, lens.near, lens.far};
  for (SeenTriangle& triangle : centre.triangles) {
    for (auto& corner : triangle.corners) corner[0] += shift;
  }
  return centre;
}

Drawer eye_of(const Drawer& drawer, const StereoPair& pair, Side side) {
  const auto draw = [=](const Scene& scene, const View& centre, const RenderSettings& settings) {
    StereoSettings both;
    both.render = settings;
    StereoRendering drawn =
        drawer.renderer(scene, settings.transfer).render_pair(centre, pair, both);
    return side == Side::kLeft ? Rendering{std::move(drawn.left), drawn.left_statistics}
                               : Rendering{std::move(drawn.right), drawn.right_statistics};
  };
  return {drawer.name, draw, {}};
}

PairDrawn::PairDrawn(const Vista& centre, const StereoPair& pair)
    : pair_(pair),
      left_(seen_by(centre, pair, Side::kLeft)),
      right_(seen_by(centre, pair, Side::kRight)) {}

Outcome PairDrawn::judge(const Drawer& drawer) const {
  return worse_of(left_.judge(eye_of(drawer, pair_, Side::kLeft)),
                  right_.judge(eye_of(drawer, pair_, Side::kRight)));
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
