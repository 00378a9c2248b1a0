// What is expected of crossings and of clipped polygons: tasks 5.3 to 5.5.
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

Case crossing_case(const lab_05::Edge& edge) {
  Case c;
  c.where = "crossing";
  c.restated = edge_text(edge);
  c.expected = {{"crossing", Shape::kPoint, exact_crossing(edge),
                 kRoundings * unit_roundoff<float> * largest(edge), "clip units", 0}};
  return c;
}

Case outline_case(const std::string& what, std::span<const Point<Clip>> polygon,
                  std::span<const ClipPlane> planes) {
  Case c;
  c.where = what;
  c.restated = restated(polygon);
  const Expected expected = exact_clip(polygon, planes);
  c.expected = {expected};
  c.judge = [expected](const Answer& answer) { return compare_outlines(expected, answer); };
  return c;
}

}  // namespace

std::vector<Case> crossing_cases() {
  std::vector<Case> cases;
  for (const lab_05::Edge& edge : lab_05::edges(53, 1)) cases.push_back(crossing_case(edge));
  return cases;
}

std::vector<Case> on_plane_cases() {
  std::vector<Case> cases;
  for (const lab_05::Edge& edge : lab_05::edges(54, 1)) {
    Case c = crossing_case(edge);
    const Expected near_enough = c.expected[0];
    c.judge = [edge, near_enough](const Answer& answer) {
      auto found = compare(near_enough, answer).first;
      if (found) return found;
      const auto& v = *find_field(answer, "crossing");
      const Point<Clip> cut{float(v[0]), float(v[1]), float(v[2]), float(v[3])};
      const double off = signed_distance(pipeline_plane(edge.plane), cut);
      if (off == 0) return found;
      found.emplace();
      found->kind = Divergence::Kind::kPosition;
      found->field = "crossing";
      found->element = "distance from the plane";
      found->actual = off;
      found->distance = std::abs(off);
      found->unit = "clip units";
      found->explanation = "the crossing is near the plane, but not on it to the bit";
      return found;
    };
    cases.push_back(c);
  }
  return cases;
}

std::vector<Case> both_ways_cases(const std::vector<lab_05::EdgesCase>& inputs) {
  std::vector<Case> cases;
  for (const lab_05::EdgesCase& edges : inputs) {
    Case c;
    c.where = fmt::format("{} edges", edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
      c.restated += fmt::format("{}edge {}: {}", i == 0 ? "" : "\n", i, edge_text(edges[i]));
    c.judge = [edges](const Answer& answer) -> std::optional<Divergence> {
      const auto* there = find_field(answer, "p to q");
      if (there == nullptr)
        return compare(Expected{"p to q", Shape::kNumbers, {0}, 0, "", 0}, answer).first;
      // Bits are no use at a wrong place.
      for (std::size_t i = 0; i < edges.size() && there->size() == 4 * edges.size(); ++i) {
        Expected exact = crossing_case(edges[i]).expected[0];
        exact.field = "p to q";
        const std::vector<double> one(there->begin() + std::ptrdiff_t(4 * i),
                                      there->begin() + std::ptrdiff_t(4 * i + 4));
        if (auto found = compare(exact, one).first) {
          found->element = fmt::format("edge {}, {}", i, found->element);
          return found;
        }
      }
      auto found =
          compare(Expected{"q to p", Shape::kPolygon, *there, 0, "clip units", 4}, answer).first;
      if (found) {
        found->element = fmt::format("edge {}, {}", found->index / 4, "xyzw"[found->index % 4]);
        found->explanation = "the crossing taken from q to p has other bits than from p to q";
      }
      return found;
    };
    cases.push_back(c);
  }
  return cases;
}

std::vector<Case> plane_cases(const std::vector<lab_05::PlaneCase>& inputs) {
  std::vector<Case> cases;
  for (const auto& [what, plane, polygon] : inputs) {
    cases.push_back(outline_case(what, polygon, std::array{pipeline_plane(plane)}));
    cases.back().restated +=
        fmt::format("\nplane {} x + {} y + {} z + {} w >= 0", plane.a, plane.b, plane.c, plane.d);
  }
  return cases;
}

std::vector<Case> frustum_cases(const std::vector<lab_05::FrustumCase>& inputs) {
  std::vector<Case> cases;
  for (const auto& [what, triangle] : inputs)
    cases.push_back(outline_case(what, triangle, pipeline_frustum()));
  return cases;
}

std::vector<Case> pair_cases() {
  std::vector<Case> cases;
  for (const lab_05::PairsCase& pairs : lab_05::pairs_of_triangles()) {
    Case c;
    c.where = fmt::format("{} pairs of triangles", pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
      c.restated += fmt::format("{}edge {}:\n{}", i == 0 ? "" : "\n", i, restated(pairs[i].shared));
    c.judge = [pairs](const Answer& answer) { return compare_shared_edges(pairs, answer); };
    cases.push_back(c);
  }
  return cases;
}

std::vector<Case> fan_cases() {
  std::vector<Case> cases;
  for (const int count : lab_05::kFanCounts) {
    Case c;
    c.where = fmt::format("{} triangles around a point", count);
    c.restated = "together they fill the picture, and most reach behind the eye";
    c.judge = [count](const Answer& answer) { return compare_coverage(count, answer); };
    cases.push_back(c);
  }
  return cases;
}

}  // namespace glassbox::labs
