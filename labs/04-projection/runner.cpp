// Calls your functions with the cases of lab 4.
#include "labs/framework/runner.h"

#include <stdexcept>

#include "generators.h"
#include "student.h"

namespace lab_04 {
namespace {

using glassbox::labs::Answer;
using glassbox::labs::entries;

void ask_camera(const Camera& c, Answer& answer) {
  answer.emit("clip_from_eye", entries(perspective(c.fovy_radians, c.aspect, c.near, c.far)));
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

// A view, or that it was refused.
void ask_view(const Camera& c, Answer& answer) {
  std::vector<double> view;
  try {
    view = entries(perspective(c.fovy_radians, c.aspect, c.near, c.far));
  } catch (const std::invalid_argument&) {
  }
  answer.emit("refused", {view.empty() ? 1.0 : 0.0});
  answer.emit("clip_from_eye", view);
}

void ask_box(const Box& b, Answer& answer) {
  answer.emit("clip_from_eye",
              entries(orthographic(b.left, b.right, b.bottom, b.top, b.near, b.far)));
}

void ask_dialect(const DialectCase& input, Answer& answer) {
  answer.emit("clip_from_eye", entries(in_dialect(input.m, input.dialect)));
}

void ask_divide(const Point<Clip, double>& p, Answer& answer) {
  const auto ndc = divide(p);
  answer.emit("ndc", ndc ? std::vector<double>{ndc->x, ndc->y, ndc->z} : std::vector<double>{});
}

void ask_screen(const ViewportCase& input, Answer& answer) {
  const Point<Screen, double> screen = to_screen(input.p, input.viewport);
  answer.emit("screen", {screen.x, screen.y});
  answer.emit("depth", {screen.z});
}

void ask_depth(const DepthCase& c, Answer& answer) {
  answer.emit("distance", {distance_of(c.depth, c.near, c.far)});
}

}  // namespace
}  // namespace lab_04

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_04;
  return {
      check("perspective views", cameras(), ask_camera),
      check("views that cannot be", refusals(), ask_refusals),
      check("parallel views", boxes(), ask_box),
      check("OpenGL's clip space", in_clip_space(Dialect::kOpenGl), ask_dialect),
      check("reversed depth", in_clip_space(Dialect::kReversed), ask_dialect),
      check("a left-handed eye", in_clip_space(Dialect::kLeftHandedEye), ask_dialect),
      check("points divided by w", points(), ask_divide),
      check("points on a picture of 640 x 480", on_the_picture(), ask_screen),
      check("distances from depths", depths(), ask_depth),
      generated_check("any view", generated_views(), ask_view),
      generated_check("any box", generated_boxes(), ask_box),
      generated_check("any projection in any dialect", generated_matrices(), ask_dialect),
      generated_check("any point", generated_points(), ask_divide),
      generated_check("any point and rectangle", generated_viewports(), ask_screen),
      generated_check("any depth", generated_depths(), ask_depth),
      // BEGIN HIDDEN
      check("views of extreme shape", stiff_cameras(), ask_camera),
      check("boxes far from the gaze", more_boxes(), ask_box),
      check("more points divided by w", random_points(), ask_divide),
      check("other rectangles of the screen", viewports(), ask_screen),
      check("distances from depths close to 1", stiff_depths(), ask_depth),
      // END HIDDEN
  };
}
