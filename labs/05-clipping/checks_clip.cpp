// The expected answers for crossings and clipped polygons: tasks 5.3 to 5.5.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exact/clip.h"
#include "exact/number.h"
#include "labs/05-clipping/outlines.h"
#include "labs/framework/compare.h"

#include <glassbox/base/rounding.h>

namespace glassbox::labs {

namespace {

using exact::Rational;

double largest(const lab_05::Edge& edge) {
  double m = 0;
  for (const Point<Clip>* p : {&edge.p, &edge.q})
    m = std::max({m, double(std::abs(p->x)), double(std::abs(p->y)), double(std::abs(p->z)),
                  double(std::abs(p->w))});
  return m;
}

std::vector<double> exact_crossing(const lab_05::Edge& edge) {
  const ClipPlane plane = pipeline_plane(edge.plane);
  const auto p = exact::exact_point<Rational>(edge.p), q = exact::exact_point<Rational>(edge.q);
  const Rational at_p = exact::distance(plane, p), at_q = exact::distance(plane, q);
  const Rational t = at_p / (at_p - at_q);
  return {double(p.x + t * (q.x - p.x)), double(p.y + t * (q.y - p.y)),
          double(p.z + t * (q.z - p.z)), double(p.w + t * (q.w - p.w))};
}

std::string edge_text(const lab_05::Edge& edge) {
  const lab_05::Plane& plane = edge.plane;
  return fmt::format("plane {} x + {} y + {} z + {} w >= 0\n{}", plane.a, plane.b, plane.c, plane.d,
                     restated(std::array{edge.p, edge.q}));
}

Expected crossing_of(const lab_05::Edge& edge, const char* field = "crossing") {
  return point(field, exact_crossing(edge), kRoundings * unit_roundoff<float> * largest(edge),
               "clip units");
}

// Checks that every vertex is either a vertex of the polygon itself or exactly on the plane, as a
// crossing is.
std::optional<Divergence> find_vertex_off_plane(const lab_05::PlaneCase& input,
                                                const Answer& answer) {
  const auto* values = find_field(answer, "polygon");
  // compare_outlines() has reported a missing field before
  if (values == nullptr) return std::nullopt;
  for (std::size_t i = 0; i + 4 <= values->size(); i += 4) {
    const double* v = values->data() + i;
    const Point<Clip> p{float(v[0]), float(v[1]), float(v[2]), float(v[3])};
    const double plane_distance = signed_distance(pipeline_plane(input.plane), p);
    const bool kept =
        std::find(input.polygon.begin(), input.polygon.end(), p) != input.polygon.end();
    if (kept || plane_distance == 0) continue;
    return Divergence{
        .kind = Divergence::Kind::kPosition,
        .field = "polygon",
        .index = i,
        .element = fmt::format("vertex {}, distance from the plane", i / 4),
        .actual = plane_distance,
        .distance = std::abs(plane_distance),
        .unit = "clip units",
        .explanation =
            "this vertex is neither exactly a vertex of the polygon nor exactly on the plane"};
  }
  return std::nullopt;
}

Case expect_outline(const std::string& what, const std::string& text,
                    std::span<const Point<Clip>> polygon, std::span<const ClipPlane> planes) {
  const Expected expected = exact_clip(polygon, planes);
  return {.where = what,
          .restated = restated(polygon) + text,
          .expected = {expected},
          .judge = [expected](const Answer& answer) { return compare_outlines(expected, answer); }};
}

// Checks that the crossing is near where it should be, and that its distance from the plane is
// exactly 0.
std::optional<Divergence> judge_on_plane(const lab_05::Edge& edge, const Expected& crossing,
                                         const Answer& answer) {
  auto found = compare(crossing, answer).first;
  if (found) return found;
  const auto& v = *find_field(answer, crossing.field);
  const Point<Clip> cut{float(v[0]), float(v[1]), float(v[2]), float(v[3])};
  const double plane_distance = signed_distance(pipeline_plane(edge.plane), cut);
  if (plane_distance == 0) return found;
  return Divergence{.kind = Divergence::Kind::kPosition,
                    .field = "crossing",
                    .element = "distance from the plane",
                    .actual = plane_distance,
                    .distance = std::abs(plane_distance),
                    .unit = "clip units",
                    .explanation = "the crossing is near the plane, but not exactly on it"};
}

// Checks first that each crossing is near where it should be, because equal bits mean nothing at a
// wrong place; then that both directions give the same bits.
std::optional<Divergence> judge_both_ways(const lab_05::EdgesCase& edges, const Answer& answer) {
  const auto* there = find_field(answer, "p to q");
  if (there == nullptr) return compare(numbers("p to q", {0}), answer).first;
  for (std::size_t i = 0; i < edges.size() && there->size() == 4 * edges.size(); ++i) {
    const auto one = there->begin() + std::ptrdiff_t(4 * i);
    if (auto found =
            compare(crossing_of(edges[i], "p to q"), std::vector<double>(one, one + 4)).first) {
      found->element = fmt::format("edge {}, {}", i, found->element);
      return found;
    }
  }
  const Expected same_bits = polygon("q to p", 4, *there, 0, "clip units");
  auto found = compare(same_bits, answer).first;
  if (found) {
    found->element = fmt::format("edge {}, {}", found->index / 4, "xyzw"[found->index % 4]);
    found->explanation = "the crossing from q to p must have the same bits as the one from p to q";
  }
  return found;
}

}  // namespace

Case expect_crossing(const lab_05::Edge& edge) {
  return {"crossing", edge_text(edge), {crossing_of(edge)}};
}

Case expect_on_plane(const lab_05::Edge& edge) {
  Case c = expect_crossing(edge);
  c.judge = [edge, crossing = c.expected[0]](const Answer& answer) {
    return judge_on_plane(edge, crossing, answer);
  };
  return c;
}

Case expect_both_ways(const lab_05::EdgesCase& edges) {
  std::string text;
  for (std::size_t i = 0; i < edges.size(); ++i)
    text += fmt::format("{}edge {}: {}", i == 0 ? "" : "\n", i, edge_text(edges[i]));
  return {.where = fmt::format("{} edges", edges.size()),
          .restated = text,
          .judge = [edges](const Answer& answer) { return judge_both_ways(edges, answer); }};
}

Case expect_polygon(const lab_05::PlaneCase& input) {
  const auto& [what, plane, polygon] = input;
  Case c = expect_outline(
      what,
      fmt::format("\nplane {} x + {} y + {} z + {} w >= 0", plane.a, plane.b, plane.c, plane.d),
      polygon, std::array{pipeline_plane(plane)});
  c.judge = [input, outline = c.judge](const Answer& answer) {
    auto found = outline(answer);
    return found ? found : find_vertex_off_plane(input, answer);
  };
  return c;
}

Case expect_triangle(const lab_05::FrustumCase& input) {
  Case c = expect_outline(input.what, "", input.triangle, pipeline_frustum());
  c.slipped = {{"opengl-depth", {exact_clip(input.triangle, opengl_frustum())}}};
  return c;
}

Case expect_pairs(const lab_05::PairsCase& pairs) {
  std::string text;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    text += fmt::format("{}edge {}:\n{}", i == 0 ? "" : "\n", i, restated(pairs[i].shared));
  return {.where = fmt::format("{} pairs of triangles", pairs.size()),
          .restated = text,
          .judge = [pairs](const Answer& answer) { return compare_shared_edges(pairs, answer); }};
}

Case expect_fan(const int& count) {
  return {.where = fmt::format("{} triangles around a point", count),
          .restated = "together they fill the picture, and most of them reach behind the eye",
          .judge = [count](const Answer& answer) { return compare_coverage(count, answer); }};
}

}  // namespace glassbox::labs
