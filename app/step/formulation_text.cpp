#include "app/step/formulation_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/report/text_layout.h"
#include "app/step/chain_text.h"
#include "app/step/matrices/decimal.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>

namespace glassbox::app {

namespace {

constexpr const char* kIndent = "     ";

std::string sentence(const std::string& text) {
  return wrapped(kIndent, text);
}

std::string rows(const glm::dmat4& m) {
  return matrix_rows(m, kIndent, 9);
}

// The largest distance of two entries, in what `distance` measures.
template <class Distance>
auto largest_over(int columns, const glm::dmat4& a, const glm::dmat4& b, Distance distance) {
  decltype(distance(0.0, 0.0)) largest{};
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < 4; ++row)
      largest = std::max(largest, distance(a[column][row], b[column][row]));
  }
  return largest;
}

int count_of_other_floats(const glm::dmat4& a, const glm::dmat4& b) {
  int count = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) count += float(a[column][row]) != float(b[column][row]);
  }
  return count;
}

std::string other_floats(const glm::dmat4& a, const glm::dmat4& b) {
  return fmt::format("rounded to float, {} of 16 entries differ", count_of_other_floats(a, b));
}

double degrees(double radians) {
  return degrees_from_radians(radians);
}

}  // namespace

std::string axis_angle_text(const Camera& camera, const View& view) {
  const AxisAngleFactors factors = axis_angle_factors(camera.world_from_eye);
  const glm::dmat4& pose = camera.world_from_eye.columns;
  const glm::dvec3 gaze = -glm::dvec3(pose[2]), axis(-gaze.y, gaze.x, 0);
  const double turn = degrees(std::atan2(std::hypot(axis.x, axis.y), -gaze.z));
  const double roll = degrees(std::atan2(factors.rolled.at(1, 0), factors.rolled.at(0, 0)));
  std::string text =
      sentence(fmt::format("the eye stands at {} and looks along {}",
                           brief_triple(glm::dvec3(pose[3]), 9), brief_triple(gaze + 0.0, 9)));
  text += sentence(
      "eye_from_world = R_z(roll) R(a, theta) T(-eye): moved, turned until the gaze is -z, rolled "
      "until up lies in the upper half of the yz plane");
  text += sentence("T(-eye)") + rows(factors.moved.columns);
  text += sentence(fmt::format("R(a, theta): {} degrees about a = gaze x (-z) = {}", brief(turn, 9),
                               brief_triple(axis + 0.0, 9)));
  text += rows(factors.turned.columns);
  text += sentence(fmt::format("R_z(roll): {} degrees", brief(roll, 9)));
  text += rows(factors.rolled.columns);
  return text + sentence("their product, bit for bit:") + rows(view.eye_from_world.columns);
}

std::string entries_text(const View& view, ProjectionForm form) {
  const double a = view.clip_from_eye.at(0, 0), b = view.clip_from_eye.at(1, 1);
  const double n = view.near, f = view.far, aspect = b / a;
  const auto number = [](double value) { return brief(value, 9); };
  const char* const left_handed = "; times diag(1, 1, -1, 1), for the slides' eye looks along +z";
  switch (form) {
    case ProjectionForm::kPerspective:
      return "";
    case ProjectionForm::kFrustum:
      return sentence(
          "made as glFrustum from the window on the near plane: [0][0] = 2n/(r-l), [1][1] = "
          "2n/(t-b)");
    case ProjectionForm::kTPers:
      return sentence(fmt::format(
          "made as the slides' T_pers: the window on the view plane at d = n has the half-height h "
          "= {}: [1][1] = d/h, [0][0] = d/h over the aspect ratio {}{}",
          number(n / b), number(aspect), left_handed));
    case ProjectionForm::kAlphaBeta:
      return sentence(fmt::format(
          "made as the slides' alpha and beta: half the horizontal angle theta = {} degrees: "
          "[0][0] "
          "= cot theta, [1][1] = AR cot theta with AR = {}; alpha = f/(f-n) = {}, beta = f n/(n-f) "
          "= {}: z' = alpha + beta/z{}",
          number(degrees(std::atan(1 / a))), number(aspect),
          number(std::isinf(f) ? 1 : f / (f - n)), number(std::isinf(f) ? -n : f * n / (n - f)),
          left_handed));
  }
  return "";
}

std::string two_steps_text(const View& view) {
  const auto factors = perspective_factors(view.clip_from_eye);
  if (!factors) return "";
  std::string text = sentence(
      "the same in two steps, from an eye that looks along +z, diag(1, 1, -1, 1): a scale makes "
      "the viewing pyramid regular, |x|, |y| <= z,");
  text += rows(factors->scaled.columns);
  if (factors->has_moved) {
    text += sentence("a shear centres it on the gaze,") + rows(factors->moved.columns);
  }
  text += sentence("and the pyramid becomes the box:") + rows(factors->clip_from_pyramid.columns);
  return text + sentence("their product is clip_from_eye, bit for bit");
}

std::string view_difference_text(const SteppedTriangle& stepped) {
  if (!stepped.usual || stepped.formulation.view == ViewForm::kUvn) return "";
  const glm::dmat4& a = stepped.chosen.view.eye_from_world.columns;
  const glm::dmat4& b = stepped.usual->eye_from_world.columns;
  const auto distance = [](double x, double y) { return std::abs(x - y); };
  double moved = 0;
  for (int row = 0; row < 3; ++row) moved = std::max(moved, distance(a[3][row], b[3][row]));
  return sentence(fmt::format(
      "[U; V; N] T(-eye) is the same but for rounding: entries of the rotation differ by up to "
      "{:.1e}, of the translation by up to {:.1e}; {}",
      largest_over(3, a, b, distance), moved, other_floats(a, b)));
}

std::string projection_difference_text(const SteppedTriangle& stepped) {
  if (!stepped.usual || stepped.formulation.projection == ProjectionForm::kPerspective) return "";
  const glm::dmat4& a = stepped.chosen.view.clip_from_eye.columns;
  const glm::dmat4& b = stepped.usual->clip_from_eye.columns;
  const std::uint64_t ulps =
      largest_over(4, a, b, [](double x, double y) { return ulp_distance(x, y); });
  return sentence(
      fmt::format("the lens's own matrix is the same but for rounding: entries differ by up to "
                  "{}; {}",
                  counted(ulps, "ulp"), other_floats(a, b)));
}

}  // namespace glassbox::app
