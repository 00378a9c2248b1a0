// The causes of an empty picture in words: what is wrong, its evidence in numbers, and what mends
// it.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "app/why/verdict_text.h"

#include <glassbox/base/printable.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox {

namespace {

using std::string;

// What a cause is told about.
struct Told {
  const Scene& scene;
  const View& view;
  const SceneVerdict& found;
  const SceneCause& cause;

  const SceneExtent& extent() const { return found.extent; }
  const Instance& instance() const { return scene.instances[cause.instance]; }
  const Node& node() const { return scene.nodes[instance().node]; }
  const Material& material() const {
    return scene.materials[scene.meshes[instance().mesh].material];
  }
};

string named(const char* what, const string& name, std::uint32_t index) {
  return fmt::format("{} {}", what, name.empty() ? std::to_string(index) : in_quotes(name));
}

string node_text(const Told& t) {
  return named("node", t.node().name, t.instance().node);
}

string material_text(const Told& t) {
  return named("material", t.material().name, t.scene.meshes[t.instance().mesh].material);
}

string size_text(const Told& t) {
  const Vector<World, double>& s = t.extent().size;
  return fmt::format("{:.4g} x {:.4g} x {:.4g}", s.x, s.y, s.z);
}

// ---- the camera ----

string range_text(const SceneExtent& e) {
  return fmt::format("{:.4g} to {:.4g} in front of the eye", e.nearest, e.farthest);
}

// One axis of the direction in which the camera would have to turn; empty if the middle of the
// scene is within the picture on this axis.
string turn_text(const Told& t, double by, double half, const char* plus, const char* minus) {
  if (std::abs(by) <= half) return {};
  return fmt::format("{:.4g}{} {} the gaze (the picture ends at {:.4g})", std::abs(by),
                     t.view.perspective ? " degrees" : "", by > 0 ? plus : minus, half);
}

string direction_text(const Told& t) {
  const SceneExtent& e = t.extent();
  std::vector<string> turns{
      turn_text(t, e.to_the_right, e.half_width, "to the right of", "to the left of"),
      turn_text(t, e.up, e.half_height, "above", "below")};
  std::erase(turns, string());
  if (turns.empty()) return "its middle is in the picture, but nothing else is";
  return "its middle is " + list_in_words(turns);
}

string point_words(const Point<World, double>& p) {
  const double rounding = 1e-9 * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const auto word = [&](double x) { return std::abs(x) <= rounding ? 0.0 : x; };
  return fmt::format("{:.6g},{:.6g},{:.6g}", word(p.x), word(p.y), word(p.z));
}

double eye_from_middle(const SceneExtent& e) {
  const Vector<World, double> to_middle = e.middle - e.eye;
  return std::sqrt(dot(to_middle, to_middle));
}

string look_at_mend(const Told& t) {
  return fmt::format("look at it: --eye {} --look-at {}", point_words(t.extent().eye),
                     point_words(t.extent().middle));
}

// The position on the line of sight through the middle of the scene from which all of it is seen.
string stand_back_mend(const Told& t) {
  const SceneExtent& e = t.extent();
  const double radius = std::sqrt(dot(e.size, e.size)) / 2;
  if (!t.view.perspective) return fmt::format("choose the height: --ortho {:.4g}", 2.2 * radius);
  const double half = radians_from_degrees(std::min(e.half_width, e.half_height));
  const double distance = 1.1 * radius / sin_cos(half).sin;
  return fmt::format("stand at a distance of {:.4g}: --eye {} --look-at {}", distance,
                     point_words(e.middle + e.gaze * -distance), point_words(e.middle));
}

// A hundredth of the scene's depth, to spare at the planes.
double margin_of(const SceneExtent& e) {
  return 0.01 * (e.farthest - e.nearest) + 0.001 * std::abs(e.farthest);
}

string near_mend(const Told& t) {
  const SceneExtent& e = t.extent();
  const double near = e.nearest - margin_of(e);
  if (near > 0 || !t.view.perspective) return fmt::format("--near {:.4g} lets all of it in", near);
  return fmt::format("--near {:.4g}, or a camera further away", e.farthest / 1000);
}

// ---- the matrices ----

string degenerate_text(const Told& t) {
  const glm::dmat4& m = t.node().world_from_node.columns;
  if (inverse_affine(t.node().world_from_node)) return "the view or the projection has no inverse";
  return fmt::format(
      "the matrix of {} has no inverse: its axes have the lengths {:.4g}, {:.4g} and {:.4g}",
      node_text(t), glm::length(m[0]), glm::length(m[1]), glm::length(m[2]));
}

string determinant_text(const Told& t) {
  return fmt::format("{:.4g}", glm::determinant(glm::dmat3(t.node().world_from_node.columns)));
}

// ---- the causes ----

string why_text(const Told& t) {
  const SceneExtent& e = t.extent();
  const string mesh = mesh_text(t.scene, t.cause.instance);
  switch (t.cause.cause) {
    case Cause::kEmptyScene:
      return "the scene is empty: it has no faces, no lines and no points";
    case Cause::kNoArea:
      return "the faces have no area as modelled: their corners are at one place or on one line, "
             "or "
             "their outlines cross themselves";
    case Cause::kDegenerateMatrix:
      return degenerate_text(t);
    case Cause::kMixedHands:
      return explain(t.found.conventions).front();
    case Cause::kNotFinite:
      return fmt::format(
          "corners overflow float (3.4e38) on the way to clip space: the scene is {} "
          "units large",
          size_text(t));
    case Cause::kInside:
      return fmt::format(
          "the camera is inside {}, and sees only backs, which are culled: the scene "
          "is {} units large, and the eye is {:.4g} from its middle",
          mesh, size_text(t), eye_from_middle(e));
    case Cause::kBehind:
      return fmt::format("the whole scene is behind the camera, {:.4g} to {:.4g} behind the eye",
                         -e.farthest, -e.nearest);
    case Cause::kLooksAway:
      return "the camera looks past the scene: " + direction_text(t);
    case Cause::kNearPlane:
      if (t.found.conventions.opengl_range) return explain(t.found.conventions).back();
      return fmt::format("nearer than the near plane, which is at {:.4g}: the scene is {}",
                         t.view.near, range_text(e));
    case Cause::kFarPlane:
      return fmt::format("beyond the far plane, which is at {:.4g}: the scene is {}", t.view.far,
                         range_text(e));
    case Cause::kTooSmall:
      return fmt::format("too small: all of the scene is {:.3g} x {:.3g} px large, {}", e.width_px,
                         e.height_px, range_text(e));
    case Cause::kInsideOut:
      return fmt::format(
          "all of {} that is in the picture shows its back: its faces are wound "
          "inside out, or the camera is behind it",
          mesh);
    case Cause::kMirroredNode:
      return fmt::format(
          "all of {} that is in the picture shows its back: {} mirrors (its "
          "determinant is {}), which turns the winding round",
          mesh, node_text(t), determinant_text(t));
    case Cause::kAlphaTest:
      return fmt::format(
          "discarded by the alpha test: the highest alpha is {:.4g}, below the "
          "cutoff of {:.4g} of {}",
          t.found.highest_discarded_alpha, t.material().alpha_cutoff, material_text(t));
    case Cause::kTransparent:
      return fmt::format("transparent: {} is blended, and its alpha is {:.4g}", material_text(t),
                         t.material().base_color.a);
    case Cause::kMasked:
      return "the colour mask lets no channel through";
    case Cause::kSameColor:
      return "drawn in the colours that were there before: the background's";
  }
  return {};
}

string mend_text(const Told& t) {
  const SceneExtent& e = t.extent();
  switch (t.cause.cause) {
    case Cause::kEmptyScene:
      return "look at the file with glassbox info";
    case Cause::kNoArea:
      return "check the order of the corners: they have to go round the face";
    case Cause::kDegenerateMatrix:
      return "look for a scale of 0";
    case Cause::kMixedHands:
      return "use a view and a projection for the same handedness";
    case Cause::kNotFinite:
      return "scale the scene down";
    case Cause::kInside:
      return stand_back_mend(t) + "; or scale the scene, if it is in millimetres (by 0.001)";
    case Cause::kBehind:
    case Cause::kLooksAway:
      return look_at_mend(t);
    case Cause::kNearPlane:
      return near_mend(t);
    case Cause::kFarPlane:
      return fmt::format("--far {:.4g} lets all of it in", e.farthest + margin_of(e));
    case Cause::kTooSmall:
      return stand_back_mend(t);
    case Cause::kInsideOut:
      return "look with --cull none: if the picture is right then, reverse the winding of the "
             "faces";
    case Cause::kMirroredNode:
      return "reverse the winding of the faces, or take the mirror out; --cull none shows them";
    case Cause::kAlphaTest:
      return "raise the alpha of the colour or of the texture, or lower the cutoff";
    case Cause::kTransparent:
      return "raise the alpha of the colour or of the texture, or make the material opaque";
    case Cause::kMasked:
      return "leave the mask out";
    case Cause::kSameColor:
      return "choose another --background";
  }
  return {};
}

}  // namespace

CauseText explain(const Scene& scene, const View& view, const SceneVerdict& verdict,
                  const SceneCause& cause) {
  const Told told{scene, view, verdict, cause};
  return {why_text(told), mend_text(told)};
}

}  // namespace glassbox
