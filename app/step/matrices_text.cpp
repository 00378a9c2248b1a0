#include "app/step/matrices_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "app/report/text_layout.h"
#include "app/step/chain_text.h"
#include "app/step/formulation_text.h"
#include "app/step/matrices/decimal.h"
#include "app/step/matrix_report.h"
#include "app/step/numbers_text.h"

#include <glassbox/base/printable.h>
#include <glassbox/base/trig.h>

namespace glassbox::app {

namespace {

constexpr const char* kIndent = "     ";

std::string sentence(const std::string& text) {
  return wrapped(kIndent, text);
}

std::string triple(const glm::dvec3& v) {
  return brief_triple(v, 9);
}

// From the root down to the node.
std::vector<std::uint32_t> path_to(const Scene& scene, std::uint32_t node) {
  std::vector<std::uint32_t> path;
  for (; node != kNone; node = scene.nodes[node].parent) path.push_back(node);
  std::reverse(path.begin(), path.end());
  return path;
}

std::string far_text(double far) {
  return std::isinf(far) ? "infinity" : brief(far, 9);
}

struct LensText {
  double aspect;
  std::string operator()(const PerspectiveLens& lens) const {
    const double degrees = degrees_from_radians(lens.fovy_radians);
    return fmt::format("a perspective: vertical angle of view {} degrees, aspect ratio {}",
                       brief(degrees, 9), brief(aspect, 9));
  }
  std::string operator()(const OrthographicLens& lens) const {
    return fmt::format("a parallel projection: half height {} world units, aspect ratio {}",
                       brief(lens.half_height, 9), brief(aspect, 9));
  }
  std::string operator()(const FrustumLens& lens) const {
    return fmt::format("a frustum: left {}, right {}, bottom {}, top {} on the near plane",
                       brief(lens.left, 9), brief(lens.right, 9), brief(lens.bottom, 9),
                       brief(lens.top, 9));
  }
};

// Which entries follow from the planes (projection.h).
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

}  // namespace

std::string model_factors_text(const Scene& scene, const Instance& instance) {
  const glm::dmat4& product = scene.nodes[instance.node].world_from_node.columns;
  if (product == glm::dmat4(1)) return sentence("world_from_object is the identity");
  std::string text = sentence("world_from_object: " + affine_sentence(facts_of(product))) +
                     matrix_rows(product, kIndent, 9);
  const std::vector<std::uint32_t> path = path_to(scene, instance.node);
  if (path.size() == 1) return text;
  text += sentence("the product of these nodes, from the root down:");
  for (const std::uint32_t index : path) {
    const Node& node = scene.nodes[index];
    text +=
        wrapped("       ", fmt::format("{} {}: {}", index, in_quotes(node.name),
                                       affine_sentence(facts_of(node.parent_from_node.columns))));
  }
  return text;
}

std::string view_factors_text(const Camera& camera, const View& view) {
  const glm::dmat4& pose = camera.world_from_eye.columns;
  const glm::dvec3 right(pose[0]), up(pose[1]), back(pose[2]), eye(pose[3]);
  std::string text = sentence(fmt::format("the eye stands at {}, looks along {}, with {} up",
                                          triple(eye), triple(-back + 0.0), triple(up)));
  text += sentence(
      "eye_from_world = [U; V; N] T(-eye): rows U, V, N, last column -eye.U, -eye.V, -eye.N");
  text += sentence(fmt::format("U = {}", triple(right)));
  text += sentence(fmt::format("V = {}", triple(up)));
  text += sentence(fmt::format("N = {}", triple(back)));
  return text + matrix_rows(view.eye_from_world.columns, kIndent, 9);
}

std::string projection_factors_text(const Camera& camera, const View& view, ProjectionForm form) {
  const double aspect = std::abs(double(view.viewport.width()) / double(view.viewport.height()));
  std::string text =
      sentence("clip_from_eye: " + std::visit(LensText{aspect}, camera.lens)) +
      sentence(fmt::format("near n = {}, far f = {}{}", brief(view.near, 9), far_text(view.far),
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
  return text + sentence(depth_formula(view)) + matrix_rows(view.clip_from_eye.columns, kIndent, 9);
}

std::string composed_text(const TracedDraw& draw, const DrawBounds& bounds) {
  std::string text = sentence(
      "all three composed in double and rounded to float once, which is what the run multiplies "
      "with:");
  text += matrix_rows(glm::dmat4(draw.clip_from_anchored.columns), kIndent, 9);
  double largest = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row)
      largest = std::max(largest, bounds.clip_from_anchored[column][row]);
  }
  text += sentence(fmt::format("its entries are known {}",
                               largest == 0 ? "exactly" : "to " + bound_text(largest)));
  if (draw.anchor.x == 0 && draw.anchor.y == 0 && draw.anchor.z == 0) return text;
  return text +
         sentence(fmt::format(
             "applied to the vertex less the anchor {}, near the mesh, so that a mesh far from its "
             "origin does not shake",
             triple({draw.anchor.x, draw.anchor.y, draw.anchor.z})));
}

}  // namespace glassbox::app
