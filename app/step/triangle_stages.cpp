#include "app/step/stepped_triangle.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/step/number_text.h"
#include "app/step/stage_texts.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/rounding.h>
#include <glassbox/matrices/decimal.h>

namespace glassbox::app {

namespace {

// The data from which the texts of all stages are made.
struct Context {
  const Scene& scene;
  const SteppedTriangle& stepped;
  const StepTarget& target;
  bool bits;

  const TracedTriangle& triangle() const { return *stepped.triangle; }
};

// The coordinates of each chosen corner, one per line, after the corner's name.
template <class Coordinates>
std::string corners_text(const Context& c, const Coordinates& coordinates) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!c.target.wants(k)) continue;
    const char* heading = "vertex";
    for (const std::string& line : coordinates(k)) {
      text += fmt::format("     {:<6} {}  {}\n", heading, *heading ? std::to_string(k) : " ", line);
      heading = "";
    }
  }
  return text;
}

template <class T, int N, int M>
std::vector<std::string> number_lines(const glm::vec<N, T>& value, const glm::vec<M, double>& bound,
                                      bool bits) {
  static_assert(M >= N);
  std::vector<std::string> lines;
  for (int i = 0; i < N; ++i) lines.push_back(number_line(kAxes[i], value[i], bound[i], bits));
  return lines;
}

// ---- object, world, eye ----

std::string object_text(const Context& c) {
  const Instance& instance = c.scene.instances[c.stepped.place.instance];
  const Mesh& mesh = c.scene.meshes[instance.mesh];
  std::string text = sentence(fmt::format(
      "face {} of mesh {} (instance {}, node {}), material {}", c.stepped.place.face,
      in_quotes(mesh.name), c.stepped.place.instance, in_quotes(c.scene.nodes[instance.node].name),
      in_quotes(c.scene.materials[mesh.material].name)));
  text += corners_text(c, [&](std::size_t k) {
    return number_lines(to_glm(c.triangle().corners[k].object), glm::dvec3(0), c.bits);
  });
  return text;
}

std::string world_text(const Context& c) {
  return model_factors_text(c.scene, c.scene.instances[c.stepped.place.instance]) +
         corners_text(c, [&](std::size_t k) {
           return number_lines(to_glm(c.triangle().corners[k].world),
                               c.stepped.bounds.corners[k].world, c.bits);
         });
}

std::string eye_text(const Context& c) {
  return view_factors_text(c.stepped) + corners_text(c, [&](std::size_t k) {
           return number_lines(to_glm(c.triangle().corners[k].eye), c.stepped.bounds.corners[k].eye,
                               c.bits);
         });
}

// ---- clip ----

// The largest difference, in ulps of float, between the vertex's clip coordinates as drawn and
// those computed in double via world and eye space.
std::uint64_t ulps_from_chain(const View& view, const TracedCorner& corner) {
  const glm::dvec4 chain = view.clip_from_eye.columns * glm::dvec4(to_glm(corner.eye), 1);
  const glm::vec4 run = to_glm(corner.clip);
  std::uint64_t most = 0;
  for (int i = 0; i < 4; ++i) most = std::max(most, ulp_distance(run[i], float(chain[i])));
  return most;
}

std::string clip_text(const Context& c) {
  const View& view = c.stepped.chosen.view;
  std::string text =
      projection_factors_text(c.stepped) + composed_text(draw_of(c.stepped), c.stepped.draw_bounds);
  text += corners_text(c, [&](std::size_t k) {
    const TracedCorner& corner = c.triangle().corners[k];
    auto lines = number_lines(to_glm(corner.clip), c.stepped.bounds.corners[k].clip, c.bits);
    const std::uint64_t ulps = ulps_from_chain(view, corner);
    lines.push_back(
        ulps == 0
            ? "the bits are the same as with world and eye space in double"
            : fmt::format("computed in double through world and eye space, the position is {} away",
                          counted(ulps, "ulp")));
    return lines;
  });
  return text;
}

// ---- NDC and screen ----

// Returns k if the vertex is corner k of the triangle; nothing if clipping made the vertex.
std::optional<std::size_t> corner_of(const TracedVertex& vertex) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (vertex.clip.weights[k] == 1) return k;
  }
  return {};
}

// The chosen vertices of the clipped polygon, each with several lines of text.
template <class Lines>
std::string vertices_text(const Context& c, const Lines& lines) {
  std::string text;
  for (std::size_t i = 0; i < c.triangle().polygon.size(); ++i) {
    const std::optional<std::size_t> corner = corner_of(c.triangle().polygon[i]);
    if (corner && !c.target.wants(*corner)) continue;
    std::string name = corner ? fmt::format("vertex {}", *corner) : fmt::format("cut {}", i);
    for (const std::string& line : lines(c.triangle().polygon[i], c.stepped.bounds.polygon[i])) {
      text += fmt::format("     {:<8}  {}\n", name, line);
      name.clear();
    }
  }
  return text;
}

std::string ndc_text(const Context& c) {
  std::string text = vertices_text(c, [&](const TracedVertex& vertex, const VertexBounds& bounds) {
    auto lines = number_lines(to_glm(vertex.ndc.position), bounds.ndc.position, c.bits);
    if (bounds.condition != glm::dvec3(0)) {
      for (int i = 0; i < 3; ++i)
        lines[std::size_t(i)] += "  condition " + short_number(bounds.condition[i], 3);
    }
    lines.push_back(number_line("1/w", vertex.ndc.inverse_w, bounds.ndc.inverse_w, c.bits));
    return lines;
  });
  return text + singular_text(c.stepped, c.target);
}

std::string snap_text(std::int32_t snapped, const SnapStability& snap) {
  return fmt::format(
      "  -> {}/256 {}", snapped,
      snap.stable ? "(sure)"
                  : fmt::format("(not sure: the next step is {:.1e} px away)", snap.to_boundary));
}

// The transformation back from the screen to object space, as text.
std::string round_trip_text(const Context& c) {
  const auto& corners = c.stepped.bounds.corners;
  if (std::none_of(corners.begin(), corners.end(),
                   [](const CornerBounds& corner) { return corner.round_trip.has_value(); })) {
    return "";
  }
  return sentence(
             "back to object space in double, from x, y and depth in float: how well they give the "
             "position") +
         corners_text(c, [&](std::size_t k) {
           return corners[k].round_trip
                      ? round_trip_lines(*corners[k].round_trip, c.bits)
                      : std::vector<std::string>{
                            "behind the eye, so it has no position on the screen"};
         });
}

std::string screen_text(const Context& c) {
  const Viewport& v = c.stepped.chosen.view.viewport;
  std::string text = sentence(fmt::format(
      "x = {} + {} x_ndc, y = {} - {} y_ndc; pixels from the upper left corner, then to 1/256",
      short_number((double(v.left) + double(v.right)) / 2),
      short_number((double(v.right) - double(v.left)) / 2),
      short_number((double(v.top) + double(v.bottom)) / 2),
      short_number((double(v.bottom) - double(v.top)) / 2)));
  text += vertices_text(c, [&](const TracedVertex& vertex, const VertexBounds& bounds) {
    return std::vector<std::string>{
        number_line("x", vertex.screen.position.x, bounds.screen.x, c.bits) +
            snap_text(vertex.snapped.x, bounds.snap_x),
        number_line("y", vertex.screen.position.y, bounds.screen.y, c.bits) +
            snap_text(vertex.snapped.y, bounds.snap_y)};
  });
  return text + round_trip_text(c);
}

// ---- setup and facing ----

char sign(std::int64_t number) {
  return number < 0 ? '-' : '+';
}

std::string edges_text(const TriangleSetup& setup) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeFunction& e = setup.edges[k];
    text += fmt::format("     edge {}: E = {} x {} {} y {} {}{}\n", k, e.a, sign(e.b),
                        std::abs(e.b), sign(e.c), std::abs(e.c),
                        e.owns_zero ? ", owns the points on it (top or left)" : "");
  }
  return text;
}

std::string facing_text(const Context& c, const TracedPiece& piece, double area_bound) {
  const TriangleSetup& setup = *piece.setup;
  const double area = double(setup.double_area) / (kSubpixels * kSubpixels);
  std::string text = sentence(fmt::format(
      "twice the area {}/65536 = {} px^2, {} on the screen{}{}: the {} is seen, and the piece {}",
      setup.double_area, short_number(area, 9), setup.clockwise ? "clockwise" : "counter-clockwise",
      area > area_bound ? "" : fmt::format(" (not sure: {})", bound_text(area_bound)),
      draw_of(c.stepped).mirrored ? ", with a model matrix that mirrors" : "",
      piece.front ? "front" : "back", piece.culled ? "is culled" : "goes on"));
  return text;
}

std::string setup_text(const Context& c) {
  std::string text;
  const auto& pieces = c.triangle().pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces.size() > 1) {
      const auto& p = pieces[i].polygon;
      text += sentence(
          fmt::format("piece {}: vertices {}, {}, {} of the polygon", i, p[0], p[1], p[2]));
    }
    if (!pieces[i].setup) {
      text += sentence("no area after snapping, so it covers no pixel");
      continue;
    }
    text += facing_text(c, pieces[i], c.stepped.bounds.double_area[i]);
    if (pieces[i].culled) continue;
    const PixelRect& box = pieces[i].setup->bounds;
    text += edges_text(*pieces[i].setup);
    text += sentence(fmt::format("pixel centres to test: columns {} to {}, rows {} to {}", box.x0,
                                 box.x1 - 1, box.y0, box.y1 - 1));
  }
  if (const auto& test = c.stepped.bounds.back_face) {
    text += sentence(fmt::format("the same test in object space: (P - eye).m = {} {}{}: {}",
                                 short_number(test->value, 9),
                                 bound_text(test->bound + test->viewer_error_bound),
                                 test->used_exact ? ", decided exactly" : "",
                                 test->facing == Facing::kBack    ? "a back face"
                                 : test->facing == Facing::kFront ? "a front face"
                                                                  : "edge-on"));
  }
  return text;
}

// ---- fragments ----

std::string fragments_text(const Context& c) {
  const auto& fragments = c.stepped.trace.fragments;
  std::map<FragmentResult, int> results;
  for (const TracedFragment& fragment : fragments) ++results[fragment.result];
  std::string text =
      sentence(fmt::format("{} covered: {} hidden, {} discarded, {} written, {} blended",
                           counted(fragments.size(), "pixel centre is", "pixel centres are"),
                           results[FragmentResult::kHidden], results[FragmentResult::kDiscarded],
                           results[FragmentResult::kWritten], results[FragmentResult::kBlended]));
  if (fragments.empty()) return text;
  const auto chosen =
      std::find_if(fragments.begin(), fragments.end(), [&](const TracedFragment& f) {
        return c.target.pixel && f.fragment.x == c.target.pixel->x &&
               f.fragment.y == c.target.pixel->y;
      });
  if (c.target.pixel && chosen == fragments.end()) {
    return text + sentence(fmt::format("pixel ({}, {}) is not among the covered ones",
                                       c.target.pixel->x, c.target.pixel->y));
  }
  const TracedFragment& shown = c.target.pixel ? *chosen : fragments[fragments.size() / 2];
  return text + fragment_text(c.stepped, shown, c.bits);
}

std::string picture_text(const Context& c) {
  const auto& fragments = c.stepped.trace.fragments;
  return sentence(fmt::format("{} of the finished picture {} this triangle, of {} that it covered",
                              counted(c.stepped.visible_pixels, "pixel"),
                              singular_or_plural(c.stepped.visible_pixels, "shows", "show"),
                              fragments.size()));
}

std::string without_trailing_blanks(const std::string& text) {
  std::string trimmed;
  for (const char c : text) {
    while (c == '\n' && trimmed.ends_with(' ')) trimmed.pop_back();
    trimmed += c;
  }
  return trimmed;
}

StageText stage(const char* name, int number, const char* title, const std::string& text) {
  return {name, without_trailing_blanks(fmt::format("  {:<2} {}\n{}", number, title, text))};
}

}  // namespace

std::vector<StageText> stage_texts(const Scene& scene, const SteppedTriangle& stepped,
                                   const StepTarget& target, bool bits) {
  if (!stepped.triangle) {
    return {stage(
        "object", 1, "object space",
        sentence(
            "this triangle has no area as modelled, so it is not drawn; glassbox why tells more"))};
  }
  const Context c{scene, stepped, target, bits};
  std::vector<StageText> stages;
  stages.push_back(stage("object", 1, "object space: as modelled", object_text(c)));
  stages.push_back(stage("world", 2, "object -> world, in double", world_text(c)));
  stages.push_back(stage("eye", 3, "world -> eye, in double", eye_text(c)));
  stages.push_back(stage("clip", 4, "eye -> clip, in float", clip_text(c)));
  stages.push_back(
      stage("clipping", 5, "clipping, before the divide", clipping_text(stepped, target)));
  if (stepped.triangle->polygon.empty()) return stages;
  stages.push_back(stage("ndc", 6, "clip -> NDC: divide by w", ndc_text(c)));
  stages.push_back(stage("screen", 7, "NDC -> screen: viewport and snap", screen_text(c)));
  stages.push_back(
      stage("setup", 8, "setup: integer edge functions, and which side is seen", setup_text(c)));
  if (stepped.trace.fragments.empty()) return stages;
  stages.push_back(stage("fragments", 9, "fragments", fragments_text(c)));
  stages.push_back(stage("picture", 10, "the picture", picture_text(c)));
  return stages;
}

}  // namespace glassbox::app
