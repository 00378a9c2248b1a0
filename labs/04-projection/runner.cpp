#include "labs/framework/runner.h"

#include <stdexcept>

#include "cases.h"
#include "student.h"

namespace glassbox::labs {

namespace {

using namespace lab_04;

void emit(const Projection& m, Answer& answer) {
  std::vector<double> rows;
  for (int i = 0; i < 16; ++i) rows.push_back(m.at(i / 4, i % 4));
  answer.emit("clip_from_eye", rows);
}

void ask_camera(const Camera& c, Answer& answer) {
  emit(perspective(c.fovy_radians, c.aspect, c.near, c.far), answer);
}

void ask_refusals(const std::vector<Camera>& cameras, Answer& answer) {
  std::vector<double> refused;
  for (const Camera& c : cameras) {
    try {
      perspective(c.fovy_radians, c.aspect, c.near, c.far);
      refused.push_back(0);
    } catch (const std::invalid_argument&) {
      refused.push_back(1);
    }
  }
  answer.emit("refused", refused);
}

void ask_box(const Box& b, Answer& answer) {
  emit(orthographic(b.left, b.right, b.bottom, b.top, b.near, b.far), answer);
}

void ask_dialect(const DialectCase& input, Answer& answer) {
  emit(in_dialect(input.m, input.dialect), answer);
}

void ask_divide(const Point<Clip, double>& p, Answer& answer) {
  const auto ndc = divide(p);
  answer.emit("ndc", ndc ? std::vector<double>{ndc->x, ndc->y, ndc->z} : std::vector<double>{});
}

void ask_screen(const Point<Ndc, double>& p, const Rectangle& viewport, Answer& answer) {
  const Point<Screen, double> screen = to_screen(p, viewport);
  answer.emit("screen", {screen.x, screen.y});
  answer.emit("depth", {screen.z});
}

void ask_depth(const DepthCase& c, Answer& answer) {
  answer.emit("distance", {distance_of(c.depth, c.near, c.far)});
}

}  // namespace

std::vector<RunnerCheck> runner_checks() {
  std::vector<RunnerCheck> all{
      check("perspective views", cameras(), ask_camera),
      check("views that cannot be", refusals(), ask_refusals),
      check("parallel views", boxes(), ask_box),
      check("OpenGL's clip space", in_clip_space(Dialect::kOpenGl), ask_dialect),
      check("reversed depth", in_clip_space(Dialect::kReversed), ask_dialect),
      check("a left-handed eye", in_clip_space(Dialect::kLeftHandedEye), ask_dialect),
      check("points divided by w", points(), ask_divide),
      check("points on a picture of 640 x 480", ndc_points(),
            [](const auto& p, Answer& answer) { ask_screen(p, kPicture, answer); }),
      check("distances from depths", depths(), ask_depth),
  };
  // BEGIN HIDDEN
  all.push_back(check("views of extreme shape", stiff_cameras(), ask_camera));
  all.push_back(check("boxes far from the gaze", more_boxes(), ask_box));
  all.push_back(check("more points divided by w", random_points(), ask_divide));
  all.push_back(check("other rectangles of the screen", viewports(),
                      [](const auto& c, Answer& answer) { ask_screen(c.p, c.viewport, answer); }));
  all.push_back(check("distances from depths close to 1", stiff_depths(), ask_depth));
  // END HIDDEN
  return all;
}

}  // namespace glassbox::labs
