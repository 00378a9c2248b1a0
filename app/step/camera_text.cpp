// Stages 2 to 4 of a stepped triangle: the three matrices, their factors, and how the slides
// compute them.
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "app/step/number_text.h"
#include "app/step/point_texts.h"
#include "app/step/stage_texts.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/elementary.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/matrices/decimal.h>

namespace glassbox::app {

namespace {

std::string triple(const glm::dvec3& v) {
  return short_vector_text(v, 9);
}

std::string rows(const glm::dmat4& m) {
  return matrix_rows(m, kIndent, 9);
}

// `distance` is a function of two numbers. Returns its largest value over all corresponding entries
// of two matrices.
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

// ---- world from object ----

// The nodes from the root down to the given one.
std::vector<std::uint32_t> path_to(const Scene& scene, std::uint32_t node) {
  std::vector<std::uint32_t> path;
  for (; node != kNone; node = scene.nodes[node].parent) path.push_back(node);
  std::reverse(path.begin(), path.end());
  return path;
}

// ---- eye from world ----

std::string axes_text(const Camera& camera, const View& view) {
  const glm::dmat4& pose = camera.world_from_eye.columns;
  const glm::dvec3 right(pose[0]), up(pose[1]), back(pose[2]), eye(pose[3]);
  std::string text = sentence(fmt::format("the eye stands at {}, looks along {}, with {} up",
                                          triple(eye), triple(-back + 0.0), triple(up)));
  text += sentence(
      "eye_from_world = [U; V; N] T(-eye): rows U, V, N, last column -eye.U, -eye.V, -eye.N");
  text += sentence(fmt::format("U = {}", triple(right)));
  text += sentence(fmt::format("V = {}", triple(up)));
  text += sentence(fmt::format("N = {}", triple(back)));
  return text + rows(view.eye_from_world.columns);
}

// eye_from_world as the product of a translation, a rotation about an axis and a roll.
std::string axis_angle_text(const Camera& camera, const View& view) {
  const AxisAngleFactors factors = axis_angle_factors(camera.world_from_eye);
  const glm::dmat4& pose = camera.world_from_eye.columns;
  const glm::dvec3 gaze = -glm::dvec3(pose[2]), axis(-gaze.y, gaze.x, 0);
  const double turn = degrees_from_radians(arctan2(hypotenuse(axis.x, axis.y), -gaze.z));
  const double roll = degrees_from_radians(arctan2(factors.roll.at(1, 0), factors.roll.at(0, 0)));
  std::string text = sentence(fmt::format("the eye stands at {} and looks along {}",
                                          triple(glm::dvec3(pose[3])), triple(gaze + 0.0)));
  text += sentence(
      "eye_from_world = R_z(roll) R(a, theta) T(-eye): translate, rotate until the gaze is -z, "
      "roll until up is in the upper half of the yz plane");
  text += sentence("T(-eye)") + rows(factors.translation.columns);
  text += sentence(fmt::format("R(a, theta): {} degrees about a = gaze x (-z) = {}",
                               short_number(turn, 9), triple(axis + 0.0)));
  text += rows(factors.rotation.columns);
  text += sentence(fmt::format("R_z(roll): {} degrees", short_number(roll, 9)));
  text += rows(factors.roll.columns);
  return text + sentence("their product has the same bits as eye_from_world:") +
         rows(view.eye_from_world.columns);
}

// The difference between this view's eye_from_world and the usual formulation's; empty if this is
// the usual formulation.
std::string view_difference_text(const SteppedTriangle& stepped) {
  if (!stepped.usual_view || stepped.formulation.view == ViewForm::kUvn) return "";
  const glm::dmat4& a = stepped.chosen.view.eye_from_world.columns;
  const glm::dmat4& b = stepped.usual_view->eye_from_world.columns;
  const auto distance = [](double x, double y) { return std::abs(x - y); };
  double moved = 0;
  for (int row = 0; row < 3; ++row) moved = std::max(moved, distance(a[3][row], b[3][row]));
  return sentence(
      fmt::format("[U; V; N] T(-eye) is the same except for rounding: entries of the rotation "
                  "differ by up to {:.1e}, of the translation by up to {:.1e}; {}",
                  largest_over(3, a, b, distance), moved, other_floats(a, b)));
}

// ---- clip from eye ----

std::string far_text(double far) {
  return std::isinf(far) ? "infinity" : short_number(far, 9);
}

struct LensText {
  double aspect;
  std::string operator()(const PerspectiveLens& lens) const {
    const double degrees = degrees_from_radians(lens.fovy_radians);
    return fmt::format(
        "a perspective projection: vertical angle of view {} degrees, aspect ratio {}",
        short_number(degrees, 9), short_number(aspect, 9));
  }
  std::string operator()(const OrthographicLens& lens) const {
    return fmt::format("a parallel projection: half height {} world units, aspect ratio {}",
                       short_number(lens.half_height, 9), short_number(aspect, 9));
  }
  std::string operator()(const FrustumLens& lens) const {
    return fmt::format("a frustum: left {}, right {}, bottom {}, top {} on the near plane",
                       short_number(lens.left, 9), short_number(lens.right, 9),
                       short_number(lens.bottom, 9), short_number(lens.top, 9));
  }
};

// The formula of the entries that depend on the near and far planes (projection.h).
std::string depth_formula(const View& view) {
  const bool reversed = view.depth_range == DepthRange::kReversed;
  if (!view.perspective) {
    return reversed ? "[2][2] = 1/(f-n), [2][3] = f/(f-n), w = 1"
                    : "[2][2] = -1/(f-n), [2][3] = -n/(f-n), w = 1";
  }
  if (std::isinf(view.far)) {
    return reversed ? "[2][2] = 0, [2][3] = n, w = -z" : "[2][2] = -1, [2][3] = -n, w = -z";
  }
  return reversed ? "[2][2] = n/(f-n), [2][3] = n f/(f-n), w = -z"
                  : "[2][2] = -f/(f-n), [2][3] = -n f/(f-n), w = -z";
}

// The formulas of the other entries, in the forms that the slides use: the scales [0][0] and
// [1][1], and for kAlphaBeta also alpha and beta.
std::string entries_text(const View& view, ProjectionForm form) {
  const double a = view.clip_from_eye.at(0, 0), b = view.clip_from_eye.at(1, 1);
  const double n = view.near, f = view.far, aspect = b / a;
  const auto number = [](double value) { return short_number(value, 9); };
  const char* const left_handed =
      "; times diag(1, 1, -1, 1), because the slides' eye looks along +z";
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
          number(degrees_from_radians(arctan(1 / a))), number(aspect),
          number(std::isinf(f) ? 1 : f / (f - n)), number(std::isinf(f) ? -n : f * n / (n - f)),
          left_handed));
  }
  return "";
}

std::string lens_text(const Camera& camera, const View& view, ProjectionForm form) {
  const double aspect = std::abs(double(view.viewport.width()) / double(view.viewport.height()));
  std::string text =
      sentence("clip_from_eye: " + std::visit(LensText{aspect}, camera.lens)) +
      sentence(fmt::format("near n = {}, far f = {}{}", short_number(view.near, 9),
                           far_text(view.far),
                           view.depth_range == DepthRange::kReversed ? ", reversed depth" : ""));
  if (form != ProjectionForm::kPerspective) {
    text += entries_text(view, form);
  } else if (std::holds_alternative<PerspectiveLens>(camera.lens)) {
    text += sentence("[0][0] = cot(angle/2)/aspect, [1][1] = cot(angle/2)");
  } else if (std::holds_alternative<OrthographicLens>(camera.lens)) {
    text += sentence("[0][0] = 1/(half height aspect), [1][1] = 1/half height");
  } else {
    text += sentence(
        "[0][0] = 2n/(r-l), [1][1] = 2n/(t-b), [0][2] = (r+l)/(r-l), [1][2] = (t+b)/(t-b)");
  }
  return text + sentence(depth_formula(view)) + rows(view.clip_from_eye.columns);
}

// A perspective matrix as the product of two steps: the first scales the viewing pyramid so that it
// becomes |x|, |y| <= z, and the second turns this pyramid into the box of NDC. Empty for parallel
// views.
std::string two_steps_text(const View& view) {
  const auto factors = perspective_factors(view.clip_from_eye);
  if (!factors) return "";
  std::string text = sentence(
      "the same in two steps, from an eye that looks along +z, diag(1, 1, -1, 1): a scale makes "
      "the viewing pyramid regular, |x|, |y| <= z,");
  text += rows(factors->scale.columns);
  if (factors->has_shear) {
    text += sentence("a shear centres it on the gaze,") + rows(factors->shear.columns);
  }
  text += sentence("and the pyramid becomes the box:") + rows(factors->clip_from_pyramid.columns);
  return text + sentence("their product is clip_from_eye, bit for bit");
}

// The difference between this view's clip_from_eye and the usual formulation's; empty if this is
// the usual formulation.
std::string projection_difference_text(const SteppedTriangle& stepped) {
  if (!stepped.usual_view || stepped.formulation.projection == ProjectionForm::kPerspective)
    return "";
  const glm::dmat4& a = stepped.chosen.view.clip_from_eye.columns;
  const glm::dmat4& b = stepped.usual_view->clip_from_eye.columns;
  const std::uint64_t ulps =
      largest_over(4, a, b, [](double x, double y) { return ulp_distance(x, y); });
  return sentence(
      fmt::format("the usual matrix of this lens is the same except for rounding: entries differ "
                  "by up to {}; {}",
                  counted(ulps, "ulp"), other_floats(a, b)));
}

// ---- the user's own matrices ----

// "your view matrix, view.txt, read by rows"
std::string given_name(const char* what, const GivenMatrix& matrix) {
  return fmt::format("your {}, {}", what, matrix.given ? matrix.origin : "the identity");
}

std::string given_view_text(const MatrixView& made) {
  std::string text = sentence(given_name("view matrix", made.setup.view) + ": " +
                              affine_sentence(matrix_facts(made.setup.view.m)));
  if (made.looks_along_plus_z) {
    text += rows(made.setup.view.m) +
            sentence(
                "your eye looks along +z, and Glassbox's along -z: eye_from_world is "
                "diag(1, 1, -1, 1) times your matrix");
  } else if (!made.eye_space_is_given) {
    text += rows(made.setup.view.m) +
            sentence(
                "eye space is that of the eye found in your projection times your view: it "
                "stands where x, y and w of clip space are 0, and looks where w grows");
  }
  return text + rows(made.view.eye_from_world.columns);
}

std::string given_projection_text(const MatrixView& made) {
  const View& view = made.view;
  std::string text = sentence(given_name("projection", made.setup.projection) + ", to the clip " +
                              "space of " + made.setup.dialect.title) +
                     rows(made.setup.projection.m);
  if (!made.conversion.empty()) {
    text += sentence("to Glassbox's clip space: " + made.conversion);
  }
  text += sentence(fmt::format(
      "clip_from_eye: {}; near n = {}, far f = {}{}",
      view.perspective ? "w is the distance along the gaze" : "w is 1", short_number(view.near, 9),
      far_text(view.far), view.depth_range == DepthRange::kReversed ? ", reversed depth" : ""));
  return text + rows(view.clip_from_eye.columns);
}

}  // namespace

std::string model_factors_text(const Scene& scene, const Instance& instance) {
  const glm::dmat4& product = scene.nodes[instance.node].world_from_node.columns;
  if (product == glm::dmat4(1)) return sentence("world_from_object is the identity");
  std::string text =
      sentence("world_from_object: " + affine_sentence(matrix_facts(product))) + rows(product);
  const std::vector<std::uint32_t> path = path_to(scene, instance.node);
  if (path.size() == 1) return text;
  text += sentence("the product of these nodes, from the root down:");
  for (const std::uint32_t index : path) {
    const Node& node = scene.nodes[index];
    text += wrapped("       ",
                    fmt::format("{} {}: {}", index, in_quotes(node.name),
                                affine_sentence(matrix_facts(node.parent_from_node.columns))));
  }
  return text;
}

std::string view_factors_text(const SteppedTriangle& stepped) {
  const ChosenView& chosen = stepped.chosen;
  if (chosen.of_matrices) return given_view_text(*chosen.of_matrices);
  const bool turned = stepped.formulation.view == ViewForm::kAxisAngle;
  return (turned ? axis_angle_text(chosen.camera, chosen.view)
                 : axes_text(chosen.camera, chosen.view)) +
         view_difference_text(stepped);
}

std::string projection_factors_text(const SteppedTriangle& stepped) {
  const View& view = stepped.chosen.view;
  if (stepped.chosen.of_matrices) return given_projection_text(*stepped.chosen.of_matrices);
  return lens_text(stepped.chosen.camera, view, stepped.formulation.projection) +
         projection_difference_text(stepped) + two_steps_text(view);
}

std::string composed_text(const TracedDraw& draw, const DrawBounds& bounds) {
  std::string text = sentence(
      "the product of all three in double, rounded to float once, which is the matrix that the "
      "renderer uses:");
  text += rows(glm::dmat4(draw.clip_from_anchored.columns));
  double largest = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row)
      largest = std::max(largest, bounds.clip_from_anchored[column][row]);
  }
  text += sentence(fmt::format("its entries are known {}",
                               largest == 0 ? "exactly" : "to " + bound_text(largest)));
  if (draw.anchor.x == 0 && draw.anchor.y == 0 && draw.anchor.z == 0) return text;
  return text +
         sentence(fmt::format("applied to the vertex minus the anchor {}, a point near the mesh, "
                              "so that rounding does not make a mesh far from its origin jitter",
                              triple({draw.anchor.x, draw.anchor.y, draw.anchor.z})));
}

}  // namespace glassbox::app
