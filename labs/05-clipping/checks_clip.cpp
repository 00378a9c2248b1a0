// The expected answers for crossings and clipped polygons: tasks 5.3 to 5.5.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

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

// How far a crossing may be off: 8 roundings of the largest coordinate, and the step of the
// smallest floats.
double crossing_error(const lab_05::Edge& edge) {
  return kRoundings * unit_roundoff<float> * largest(edge) + 0x1p-149;
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
  return point(field, exact_crossing(edge), crossing_error(edge), "clip units");
}

Case expect_outline(const std::string& what, const std::string& text,
                    std::span<const Point<Clip>> polygon, std::span<const ClipPlane> planes) {
  const ExactOutline outline = exact_clip(polygon, planes);
  return {.where = what,
          .restated = restated(polygon) + text,
          .expected = {outline.expected},
          .judge = [outline](const Answer& answer) { return compare_outlines(outline, answer); }};
}

// The distance of a vertex of an answer from a plane of the frustum: a sum of at most two floats,
// so its sign is exact.
double answer_distance(const lab_05::Plane& plane, const double* v) {
  return distance_from(plane, {float(v[0]), float(v[1]), float(v[2]), float(v[3])});
}

// Checks that the crossing is near where it should be, and that its distance from the plane is
// exactly 0.
std::optional<Divergence> judge_on_plane(const lab_05::Edge& edge, const Expected& crossing,
                                         const Answer& answer) {
  auto found = compare(crossing, answer).first;
  if (found) return found;
  const double plane_distance =
      answer_distance(edge.plane, find_field(answer, crossing.field)->data());
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

// ---- generated inputs ----

using Numbers4 = std::array<double, 4>;

Numbers4 numbers_of(const Point<Clip>& p) {
  return {p.x, p.y, p.z, p.w};
}

// The crossing in double. It differs from the exact one by a few roundings of double: less than
// 2^-48 of the edge's largest coordinate, or 2^-24 of its error bound.
constexpr double kShareOfBound = 0x1p-24;
Numbers4 crossing_in_double(const lab_05::Edge& edge) {
  const Numbers4 p = numbers_of(edge.p), q = numbers_of(edge.q);
  const double at_p = std::abs(distance_from(edge.plane, edge.p));
  const double at_q = std::abs(distance_from(edge.plane, edge.q));
  Numbers4 cut{};
  for (std::size_t i = 0; i < 4; ++i) cut[i] = (p[i] * at_q + q[i] * at_p) / (at_p + at_q);
  return cut;
}

double distance_between_points(const Numbers4& a, const double* b) {
  double distance = 0;
  for (std::size_t i = 0; i < 4; ++i) distance = std::max(distance, distance_between(a[i], b[i]));
  return distance;
}

// A vertex of the part of a polygon inside a plane: a corner that is kept, or a crossing.
struct PartVertex {
  Numbers4 place{};
  double bound = 0;  // 0 for a corner, which keeps its bits
};

std::vector<PartVertex> part_of(const lab_05::PlaneCase& input) {
  std::vector<PartVertex> part;
  const std::size_t n = input.polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const lab_05::Edge edge{input.plane, input.polygon[i], input.polygon[(i + 1) % n]};
    const double here = distance_from(input.plane, edge.p);
    const double next = distance_from(input.plane, edge.q);
    if (here >= 0) part.push_back({numbers_of(edge.p), 0});
    if ((here < 0 && next > 0) || (here > 0 && next < 0)) {
      part.push_back({crossing_in_double(edge), crossing_error(edge) * (1 + kShareOfBound)});
    }
  }
  return part;
}

bool is_vertex(const lab_05::Plane& plane, const PartVertex& vertex, const double* actual) {
  const double distance = distance_between_points(vertex.place, actual);
  if (vertex.bound > 0) return distance <= vertex.bound && answer_distance(plane, actual) == 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (std::signbit(vertex.place[i]) != std::signbit(actual[i])) return false;
  }
  return distance == 0;
}

// Whether the answer has the vertices of `part`, beginning with any. Neighbours that are both new
// may be one vertex of the answer.
bool has_vertices(const lab_05::Plane& plane, const std::vector<PartVertex>& part,
                  const std::vector<double>& actual) {
  const std::size_t given = actual.size() / 4;
  if (given > part.size()) return false;
  for (std::size_t start = 0; start < part.size(); ++start) {
    // Bit j is set if the vertices so far may be those of the answer up to its number j.
    std::uint32_t ends = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const PartVertex& vertex = part[(start + i) % part.size()];
      const PartVertex& before = part[(start + i + part.size() - 1) % part.size()];
      const bool both_new = vertex.bound > 0 && before.bound > 0;
      std::uint32_t next = i == 0 ? 1 : ends << 1 | (both_new ? ends : 0);
      for (std::size_t j = 0; j < given; ++j) {
        if ((next >> j & 1) != 0 && !is_vertex(plane, vertex, actual.data() + 4 * j))
          next &= ~(1u << j);
      }
      ends = next & ((1u << given) - 1);
    }
    if ((ends >> (given - 1) & 1) != 0) return true;
  }
  return false;
}

// How many vertices are left at least if new ones become one wherever their bounds allow it.
std::size_t least_vertices(const std::vector<PartVertex>& part) {
  std::size_t merged = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const PartVertex &a = part[i], &b = part[(i + 1) % part.size()];
    const bool both_new = a.bound > 0 && b.bound > 0;
    merged += both_new && distance_between_points(a.place, b.place.data()) <= a.bound + b.bound;
  }
  return part.size() - merged;
}

}  // namespace

bool right_part(const lab_05::PlaneCase& input, const Answer& answer) {
  const auto* actual = find_field(answer, "polygon");
  if (actual == nullptr || actual->size() % 4 != 0) return false;
  const std::vector<PartVertex> part = part_of(input);
  if (actual->empty()) return part.size() < 3 || least_vertices(part) < 3;
  return actual->size() >= 12 && part.size() >= 3 && has_vertices(input.plane, part, *actual);
}

Case expect_edge(const lab_05::Edge& edge) {
  Case c{.where = "an edge", .restated = edge_text(edge)};
  c.judge = [edge](const Answer& answer) -> std::optional<Divergence> {
    if (auto found = judge_both_ways({edge}, answer)) return found;
    Answer forward;
    forward.emit("crossing", *find_field(answer, "p to q"));
    if (auto found = judge_on_plane(edge, crossing_of(edge), forward)) {
      found->field = "p to q";
      return found;
    }
    const auto &there = *find_field(answer, "p to q"), &back = *find_field(answer, "q to p");
    for (std::size_t i = 0; i < 4; ++i) {
      if (std::signbit(there[i]) == std::signbit(back[i])) continue;
      return Divergence{.field = "q to p",
                        .index = i,
                        .expected = there[i],
                        .actual = back[i],
                        .unit = "clip units",
                        .explanation = "the two directions give zeros of different signs"};
    }
    return std::nullopt;
  };
  return c;
}

bool right_edge(const lab_05::Edge& edge, const Answer& answer) {
  const auto *there = find_field(answer, "p to q"), *back = find_field(answer, "q to p");
  if (there == nullptr || back == nullptr || there->size() != 4 || back->size() != 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    if ((*there)[i] != (*back)[i] || std::signbit((*there)[i]) != std::signbit((*back)[i]))
      return false;
  }
  if (answer_distance(edge.plane, there->data()) != 0) return false;
  const Numbers4 cut = crossing_in_double(edge);
  const auto judged = judge_nearly({cut.begin(), cut.end()}, crossing_error(edge), there);
  return judged ? *judged : !judge_case(expect_edge(edge), answer);
}

bool right_triangle(const lab_05::FrustumCase& input, const Answer& answer) {
  return !compare_outlines(exact_clip(input.triangle, pipeline_frustum()), answer);
}

bool right_pairs(const lab_05::PairsCase& pairs, const Answer& answer) {
  return !compare_shared_edges(pairs, answer);
}

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
  c.judge = [input, outline = c.judge](const Answer& answer) -> std::optional<Divergence> {
    if (right_part(input, answer)) return std::nullopt;
    if (auto found = outline(answer)) return found;
    return Divergence{.kind = Divergence::Kind::kPosition,
                      .field = "polygon",
                      .unit = "clip units",
                      .explanation =
                          "a corner that is kept must keep its bits, and a new vertex "
                          "must be within the bound of 5.3 and exactly on the plane"};
  };
  return c;
}

Case expect_triangle(const lab_05::FrustumCase& input) {
  Case c = expect_outline(input.what, "", input.triangle, pipeline_frustum());
  c.slipped = {{"opengl-depth", {exact_clip(input.triangle, opengl_frustum()).expected}},
               {"no-near-plane", {exact_clip(input.triangle, frustum_without_near()).expected}}};
  return c;
}

Case expect_pairs(const lab_05::PairsCase& pairs) {
  std::string text;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    text += fmt::format("{}edge {}:\n{}", i == 0 ? "" : "\n", i, restated(pairs[i].shared));
  const auto clipped_by = [&](const std::vector<ClipPlane>& planes) {
    std::vector<Expected> polygons;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      polygons.push_back(exact_clip(pairs[i].first(), planes).expected);
      polygons.back().field = fmt::format("first {}", i);
      polygons.push_back(exact_clip(pairs[i].second(), planes).expected);
      polygons.back().field = fmt::format("second {}", i);
    }
    return polygons;
  };
  return {.where = fmt::format("{} pairs of triangles", pairs.size()),
          .restated = text,
          .judge = [pairs](const Answer& answer) { return compare_shared_edges(pairs, answer); },
          .slipped = {{"opengl-depth", clipped_by(opengl_frustum())},
                      {"no-near-plane", clipped_by(frustum_without_near())}}};
}

Case expect_fan(const int& count) {
  return {.where = fmt::format("{} triangles around a point", count),
          .restated = "together they fill the picture, and most of them reach behind the eye",
          .judge = [count](const Answer& answer) { return compare_coverage(count, answer); }};
}

}  // namespace glassbox::labs
