// The middle part of the text about points: each point's coordinates from object space to the
// window.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "app/step/number_text.h"
#include "app/step/point_texts.h"
#include "cli/report/text_layout.h"

#include <glassbox/matrices/decimal.h>

namespace glassbox::app {

namespace {

bool is_identity(const glm::mat4& m) {
  return m == glm::mat4(1);
}

std::size_t widest(const std::vector<std::string>& texts) {
  std::size_t width = 0;
  for (const std::string& text : texts) width = std::max(width, text.size());
  return width;
}

// One multiplication as text: [ matrix ] [ before ]   [ after ] +- bound, with as many digits as
// fit into the width.
std::string product_text(const TransformStep& step, bool bits) {
  std::string text;
  for (const int digits : {6, 5, 4, 3, 2}) {
    text.clear();
    const auto rows = entry_rows(glm::dmat4(step.matrix), digits);
    std::vector<std::string> before, after;
    for (int i = 0; i < 4; ++i) {
      before.push_back(short_number(double(step.before[i]), digits));
      after.push_back(short_number(double(step.after[i]), 9));
    }
    const std::size_t before_width = widest(before), after_width = widest(after);
    std::size_t longest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::string line = fmt::format("     [ {} ] [ {:>{}} ] {} {} {:>{}}  {}{}", rows[i],
                                           before[i], before_width, i == 1 ? "=" : " ", kAxes[i],
                                           after[i], after_width, bound_text(step.bound[int(i)]),
                                           bits ? "  " + bits_text(step.after[int(i)]) : "");
      longest = std::max(longest, line.size());
      text += line + "\n";
    }
    if (longest <= kTextWidth) break;
  }
  return text;
}

std::string step_text(int number, const char* from_to, const char* matrix,
                      const TransformStep& step, bool bits) {
  std::string text = fmt::format("  {}  {}, by the {} matrix", number, from_to, matrix);
  if (is_identity(step.matrix)) return text + ": the identity, nothing changes\n";
  return text + "\n" + product_text(step, bits);
}

// The point's position as seen from the eye, in words.
std::string eye_sentence(const VertexChain& chain, const PointStep& step) {
  const glm::vec4& eye = chain.to_eye.after;
  const ProjectionFacts& p = step.lens;
  if (p.kind == ProjectionKind::kNone || eye.w != 1 || !std::isfinite(eye.x + eye.y + eye.z)) {
    return {};
  }
  const double along = p.looks_down_minus_z ? -double(eye.z) : double(eye.z);
  // Coordinates that are only rounding errors compared with the distance are shown as 0.
  const double rounding = 1e-6 * std::abs(along);
  const auto side = [&](double x, const char* plus, const char* minus) {
    if (std::abs(x) < rounding) x = 0;
    return short_number(std::abs(x)) + (x < 0 ? minus : plus);
  };
  return sentence(fmt::format("seen from the eye, which looks down {}z: {}, {}, {}",
                              p.looks_down_minus_z ? "-" : "+", side(along, " in front", " behind"),
                              side(double(eye.x), " to the right", " to the left"),
                              side(double(eye.y), " up", " down")));
}

// Compares the clip coordinates with those that a single matrix gives, the product of all matrices,
// which most programs use.
std::string combined_matrix_text(const VertexChain& chain) {
  const int factors = int(!is_identity(chain.to_world.matrix)) +
                      int(!is_identity(chain.to_eye.matrix)) +
                      int(!is_identity(chain.to_clip.matrix));
  const glm::dvec4 difference =
      glm::abs(glm::dvec4(to_glm(chain.clip_by_composed_matrix)) - glm::dvec4(chain.to_clip.after));
  const double most = std::max({difference.x, difference.y, difference.z, difference.w});
  if (factors < 2 || !std::isfinite(most)) return {};
  return fmt::format(
      "     multiplied first in double and rounded once, the matrices give the same{}\n",
      most == 0 ? " bits" : fmt::format(" to within {:.1e}", most));
}

// The side of a plane's inequality that has the coordinates: "z + w" for the plane 0 <= z + w.
std::string plane_form(const ClipPlane& plane) {
  std::string form;
  for (const auto& [coefficient, name] :
       {std::pair{plane.a, "x"}, {plane.b, "y"}, {plane.c, "z"}, {plane.d, "w"}}) {
    if (coefficient == 0) continue;
    if (form.empty()) {
      form = coefficient < 0 ? std::string("-") + name : name;
    } else {
      form += std::string(coefficient < 0 ? " - " : " + ") + name;
    }
  }
  // "w - x" reads better than "-x + w".
  if (form.size() == 6 && form[0] == '-') form = std::string("w - ") + form[1];
  return form;
}

std::string planes_table(const VertexChain& chain) {
  std::string text;
  for (const PlaneStep& at : chain.planes) {
    text += fmt::format("     {:<7}{:>5} = {:<15} {:<12} {}{}\n", at.plane.name,
                        plane_form(at.plane), short_number(at.distance, 9), bound_text(at.bound),
                        at.is_outside() ? "outside" : "inside",
                        at.is_certain() ? "" : ", uncertain because of rounding");
  }
  return text;
}

// Compares the point with the extent of the frustum at the point's distance: this shows why the
// point is outside the plane.
std::string frustum_sentence(const VertexChain& chain, const PointStep& step) {
  const ProjectionFacts& p = step.lens;
  const std::size_t plane = std::size_t(chain.deciding_plane);
  const glm::vec4& eye = chain.to_eye.after;
  if (p.kind == ProjectionKind::kNone || eye.w != 1 || p.w_offset != 0) return {};
  const double distance = p.looks_down_minus_z ? -double(eye.z) : double(eye.z);
  if (plane < 2) {
    const DepthReading& reading =
        step.setup.dialect.z_from_minus_w ? p.minus_one_to_one : p.zero_to_one;
    if (!reading.possible || p.oblique_depth) return {};
    return fmt::format("its distance along the gaze is {}, and this projection shows {} to {}",
                       short_number(distance), short_number(reading.near),
                       short_number(reading.far));
  }
  const int axis = plane < 4 ? 0 : 1;
  const double reach = p.kind == ProjectionKind::kPerspective ? distance : 1;
  const double a = ((-1 - p.centre[axis]) * reach - p.shift[axis]) / p.scale[axis];
  const double b = ((1 - p.centre[axis]) * reach - p.shift[axis]) / p.scale[axis];
  const std::string where = p.kind == ProjectionKind::kPerspective
                                ? "at its distance " + short_number(distance)
                                : "at any distance";
  return fmt::format("{} the picture spans {} from {} to {} in eye space, and the point is at {}",
                     where, kAxes[axis], short_number(std::min(a, b)), short_number(std::max(a, b)),
                     short_number(double(eye[axis])));
}

std::string decision_of(const VertexChain& chain) {
  const std::string w = short_number(double(chain.clip.w));
  switch (chain.verdict) {
    case VertexVerdict::kNotFinite:
      return "a coordinate is not finite, so it cannot be compared with the planes";
    case VertexVerdict::kBehindEye:
      return fmt::format(
          "w = {} is negative: behind the eye. Dividing by it would flip the point to the front "
          "(S3-13 in docs/references.md)",
          w);
    case VertexVerdict::kInEyePlane:
      return "w = 0: the point lies in the plane of the eye, and its image at infinity";
    case VertexVerdict::kOutside: {
      const PlaneStep& plane = chain.planes[std::size_t(chain.deciding_plane)];
      return fmt::format("outside the {} plane by {} (w = {})", plane.plane.name,
                         short_number(-plane.distance), w);
    }
    case VertexVerdict::kVisible:
      return "inside all six planes";
  }
  return "";
}

bool reaches_the_divide(const VertexChain& chain) {
  return chain.verdict == VertexVerdict::kVisible || chain.verdict == VertexVerdict::kOutside;
}

std::string clip_text(const VertexChain& chain, const PointStep& step) {
  const ApiDialect& dialect = step.setup.dialect;
  return fmt::format("  4  clip: {} shows -w <= x, y <= w and {} <= z <= w\n", dialect.title,
                     dialect.z_from_minus_w ? "-w" : "0") +
         (reaches_the_divide(chain) ? planes_table(chain) : "") +
         sentence("decided: " + decision_of(chain));
}

std::string divide_text(const VertexChain& chain, bool bits) {
  const DivideStep& d = *chain.divide;
  std::string text = "  5  clip -> NDC: divide by w\n";
  const float numerators[] = {chain.clip.x, chain.clip.y, chain.clip.z};
  const float values[] = {d.ndc.position.x, d.ndc.position.y, d.ndc.position.z};
  const std::string w = short_number(double(chain.clip.w), 9);
  for (int i = 0; i < 3; ++i) {
    text += fmt::format("     {} = {:>13} / {} = {:<15} {:<11} condition {}{}\n", kAxes[i],
                        short_number(double(numerators[i]), 9), w,
                        short_number(double(values[i]), 9), bound_text(d.bound.position[i]),
                        short_number(d.condition[i], 3), bits ? "  " + bits_text(values[i]) : "");
  }
  return text;
}

std::string snap_text(const SnapStability& snap) {
  return fmt::format(
      "snapped to {} ({})", short_number(snap.snapped, 10),
      snap.stable ? fmt::format("stable: {:.1e} px from the next step", snap.to_boundary)
                  : fmt::format("not stable: rounding may move it to a neighbour, {:.1e} px away",
                                snap.to_boundary));
}

std::string screen_text(const PointStep::Walk& walk, const PointStep& step) {
  const VertexChain& chain = walk.chain;
  const ScreenStep& s = *chain.screen;
  const Viewport& v = step.viewport;
  std::string text = fmt::format("  6  NDC -> window: pixels from the {} left, y {}\n",
                                 step.setup.dialect.window_y_up ? "lower" : "upper",
                                 step.setup.dialect.window_y_up ? "up" : "down");
  const auto line = [&](const char* name, float ndc, float from, float to, float value,
                        double bound, const SnapStability& snap) {
    text += fmt::format("     {} = {} * {} + {} = {} {} px{}\n", name, short_number(double(ndc), 7),
                        short_number(double((to - from) * 0.5f)),
                        short_number(double((to + from) * 0.5f)), short_number(double(value), 9),
                        bound_text(bound), step.bits ? "  " + bits_text(value) : "");
    if (std::isfinite(snap.snapped)) text += wrapped("         ", snap_text(snap));
  };
  const Point<Ndc>& ndc = chain.divide->ndc.position;
  line("x", ndc.x, v.left, v.right, s.screen.position.x, s.bound.x, s.snap_x);
  line("y", ndc.y, v.bottom, v.top, s.screen.position.y, s.bound.y, s.snap_y);
  const double scale = step.setup.dialect.z_from_minus_w ? 0.5 : 1;
  text += fmt::format("     depth {} {}", short_number(s.depth, 9), bound_text(s.bound.z * scale));
  if (const auto depth = known_distance(walk, step)) {
    text += fmt::format(": known to {:.1e} of distance", depth->uncertainty);
  }
  text += "\n";
  // An uncertainty below twice the rounding error bounds is not worth reporting.
  if (walk.digits_uncertainty_px > 2 * std::max(s.bound.x, s.bound.y)) {
    text +=
        sentence(fmt::format("the matrices are printed with too few digits, which adds an "
                             "uncertainty of {:.1e} px (%.9g prints a float without loss)",
                             walk.digits_uncertainty_px));
  }
  return text;
}

std::string round_trip_text(const VertexChain& chain, bool bits) {
  if (!chain.round_trip) return "";
  std::string text = "     back to object space in double, from x, y and z of NDC in float:\n";
  for (const std::string& line : round_trip_lines(*chain.round_trip, bits)) {
    text += "     " + line + "\n";
  }
  return text;
}

}  // namespace

std::string vertex_verdict_text(const PointStep::Walk& walk, const PointStep& step) {
  constexpr double kLastDigitPx = 0.005;
  const VertexChain& chain = walk.chain;
  switch (chain.verdict) {
    case VertexVerdict::kVisible: {
      const Point<Screen>& p = chain.screen->screen.position;
      const double px = uncertainty_px(walk);
      return fmt::format("visible at ({:.2f}, {:.2f})", p.x, p.y) +
             (px > kLastDigitPx ? fmt::format(" +- {} px", short_number(px, 3)) : "");
    }
    case VertexVerdict::kNotFinite:
      return "not finite";
    case VertexVerdict::kInEyePlane:
      return "in the plane of the eye (w = 0)";
    case VertexVerdict::kBehindEye:
      return fmt::format("behind the eye (w = {})", short_number(double(chain.clip.w)));
    case VertexVerdict::kOutside: {
      const char* plane = chain.planes[std::size_t(chain.deciding_plane)].plane.name;
      const std::string frustum = frustum_sentence(chain, step);
      return fmt::format("outside the {} plane{}", plane, frustum.empty() ? "" : ": " + frustum);
    }
  }
  return "";
}

std::string walk_text(const PointStep::Walk& walk, const PointStep& step) {
  const VertexChain& chain = walk.chain;
  std::string text = step_text(1, "object -> world", "model", chain.to_world, step.bits) +
                     step_text(2, "world -> eye", "view", chain.to_eye, step.bits);
  if (!step.setup.projection.given) return text;
  text += eye_sentence(chain, step) +
          step_text(3, "eye -> clip", "projection", chain.to_clip, step.bits) +
          combined_matrix_text(chain) + clip_text(chain, step);
  if (!reaches_the_divide(chain)) return text;
  return text + divide_text(chain, step.bits) + screen_text(walk, step) +
         round_trip_text(chain, step.bits);
}

}  // namespace glassbox::app
