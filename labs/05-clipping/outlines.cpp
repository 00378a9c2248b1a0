#include "labs/05-clipping/outlines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "exact/clip.h"
#include "exact/number.h"
#include "labs/framework/compare.h"

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/clip_bounds.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/rasterise_polygon.h>

namespace glassbox::labs {

namespace {

using exact::Rational;

constexpr double kU = unit_roundoff<float>;

double largest(const Point<Clip>& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(p.w)});
}

// The largest error that a vertex may have after clipping by any of the planes, including the error
// that the ends of a clipped edge had before (pipeline/clip_bounds.h). The pipeline's own polygon
// is used in place of the exact one: it differs by less than the bound.
double bound_of(std::span<const Point<Clip>> corners, std::span<const ClipPlane> planes) {
  ClipPolygon polygon;
  for (const Point<Clip>& p : corners) polygon.vertices[std::size_t(polygon.count++)].position = p;
  std::vector<ClipVertexBound> bounds(corners.size());
  double worst = 0;           // a vertex that is not cut off keeps its bits
  if (corners.size() != 3) {  // a polygon and one plane: no earlier errors
    for (const Point<Clip>& p : corners) worst = std::max(worst, kRoundings * kU * largest(p));
    return worst;
  }
  std::vector<ClipStep> steps;
  clip_triangle({polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]}, planes, &steps);
  for (std::size_t s = 0; s < steps.size(); ++s) {
    const ClipStep& step = steps[s];
    std::vector<ClipVertexBound> after;
    for (int i = 0; i < step.after.count; ++i) {
      const auto [from, to] = step.sources[std::size_t(i)];
      const auto f = std::size_t(from), t = std::size_t(to);
      ClipVertexBound bound = bounds[f];
      if (from != to) {
        const ClipVertex &p = polygon.vertices[f], &q = polygon.vertices[t];
        bound = crossing_bound(planes[s], p, bounds[f], step.distances[f], q, bounds[t],
                               step.distances[t], step.after.vertices[std::size_t(i)]);
        const double rounding =
            kRoundings * kU * std::max(largest(p.position), largest(q.position));
        bound.position += glm::dvec4(rounding);
      }
      for (int k = 0; k < 4; ++k) worst = std::max(worst, bound.position[k]);
      after.push_back(bound);
    }
    polygon = step.after;
    bounds = after;
  }
  return worst;
}

const std::vector<double>& field_of(const Answer& answer, const std::string& name) {
  static const std::vector<double> none;
  const auto* values = find_field(answer, name);
  return values != nullptr ? *values : none;
}

std::vector<Point<Clip>> outline_of(const std::vector<double>& values) {
  std::vector<Point<Clip>> outline;
  for (std::size_t i = 0; i + 4 <= values.size(); i += 4) {
    outline.push_back(
        {float(values[i]), float(values[i + 1]), float(values[i + 2]), float(values[i + 3])});
  }
  return outline;
}

double vertex_distance(const Point<Clip>& a, const Point<Clip>& b) {
  return std::max({std::abs(double(a.x) - b.x), std::abs(double(a.y) - b.y),
                   std::abs(double(a.z) - b.z), std::abs(double(a.w) - b.w)});
}

// The vertex of the outline that is nearest to the given point; nothing if the outline is empty.
std::optional<Point<Clip>> nearest(const std::vector<Point<Clip>>& outline,
                                   const Point<Clip>& place) {
  if (outline.empty()) return std::nullopt;
  return *std::min_element(outline.begin(), outline.end(), [&](const auto& a, const auto& b) {
    return vertex_distance(a, place) < vertex_distance(b, place);
  });
}

// The coverage of the clipped polygons is compared in a picture of 48 x 32 pixels.
constexpr PixelRect kWindow{0, 0, 48, 32};
constexpr Viewport kViewport{0, 0, 48, 32};

// The reason why a vertex cannot be drawn; nothing if all can be.
std::optional<std::string> cannot_be_drawn(const std::vector<Point<Clip>>& outline) {
  for (const Point<Clip>& p : outline) {
    if (!(p.w > 0)) return fmt::format("a vertex has w = {}: it is at or behind the eye", p.w);
    if (!(std::abs(p.x) <= 2 * p.w && std::abs(p.y) <= 2 * p.w && std::isfinite(p.z)))
      return fmt::format("a vertex ({}, {}, {}, {}) lies far outside the frustum", p.x, p.y, p.z,
                         p.w);
  }
  return std::nullopt;
}

}  // namespace

ClipPlane pipeline_plane(const lab_05::Plane& plane) {
  return {plane.a, plane.b, plane.c, plane.d, 0, ""};
}

std::vector<ClipPlane> pipeline_frustum() {
  std::vector<ClipPlane> planes;
  for (const lab_05::Plane& plane : lab_05::kFrustum) planes.push_back(pipeline_plane(plane));
  return planes;
}

std::vector<ClipPlane> opengl_frustum() {
  std::vector<ClipPlane> planes = pipeline_frustum();
  planes[0].d = 1;
  return planes;
}

std::vector<ClipPlane> frustum_without_near() {
  std::vector<ClipPlane> planes = pipeline_frustum();
  planes.erase(planes.begin());
  return planes;
}

std::string restated(std::span<const Point<Clip>> polygon) {
  std::string text;
  double twice_area = 0;
  bool all_in_front = !polygon.empty();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<Clip>& p = polygon[i];
    text += fmt::format("vertex {}: clip ({}, {}, {}, {})", i, p.x, p.y, p.z, p.w);
    if (!(p.w > 0)) {
      text += ", which is at or behind the eye\n";
      all_in_front = false;
      continue;
    }
    const NdcVertex ndc = divide(p);
    const ScreenVertex screen = to_screen(ndc, {0, 0, 640, 480});
    text += fmt::format(", NDC ({:.6g}, {:.6g}, {:.6g}), screen ({:.2f}, {:.2f}) of 640 x 480\n",
                        ndc.position.x, ndc.position.y, ndc.position.z, screen.position.x,
                        screen.position.y);
    const Point<Clip>& next = polygon[(i + 1) % polygon.size()];
    twice_area += double(p.x) / p.w * (double(next.y) / next.w) -
                  double(next.x) / next.w * (double(p.y) / p.w);
  }
  if (all_in_front && polygon.size() > 2)
    text += fmt::format("winding in NDC: {}\n", twice_area > 0   ? "counter-clockwise"
                                                : twice_area < 0 ? "clockwise"
                                                                 : "no area");
  if (!text.empty()) text.pop_back();
  return text;
}

ExactOutline exact_clip(std::span<const Point<Clip>> polygon, std::span<const ClipPlane> planes) {
  exact::ExactPolygon<Rational> corners;
  for (const Point<Clip>& p : polygon) corners.push_back(exact::exact_point<Rational>(p));
  const exact::ExactPolygon<Rational> kept = exact::clip(corners, planes);
  ExactOutline made{
      labs::polygon("polygon", 4, {}, bound_of(polygon, planes), "clip units"), {}, {}};
  std::vector<double>& values = kept.size() < 3 ? made.touched : made.expected.values;
  for (const auto& p : kept) {
    for (const Rational* each : {&p.x, &p.y, &p.z, &p.w}) values.push_back(double(*each));
  }
  for (const Point<Clip>& p : polygon)
    made.corners.insert(made.corners.end(), {p.x, p.y, p.z, p.w});
  return made;
}

namespace {

constexpr std::size_t kMostVertices = 9;

// Reports what no polygon may have: equal neighbours, only one or two vertices, or more than nine.
std::optional<Divergence> find_degenerate_outline(const std::vector<double>& values) {
  const auto outline = outline_of(values);
  Divergence found{.kind = Divergence::Kind::kExtra, .field = "polygon", .unit = "clip units"};
  if (outline.size() == 1 || outline.size() == 2) {
    found.explanation =
        "a polygon has at least three vertices; the answer must be empty if fewer are left";
    return found;
  }
  if (outline.size() > kMostVertices) {
    found.index = 4 * kMostVertices;
    found.element = fmt::format("vertex {}", kMostVertices);
    found.explanation = "three corners and six planes make nine vertices at most";
    return found;
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    if (!(outline[i] == outline[next])) continue;
    found.index = 4 * next;
    found.element = fmt::format("vertex {}", next);
    found.explanation = fmt::format("it has the same coordinates as its neighbour, vertex {}", i);
    return found;
  }
  return std::nullopt;
}

// The outline without vertices that are nearer than `min_distance` to the one before them; empty if
// fewer than three are left.
std::vector<double> without_near_vertices(const std::vector<double>& values, double min_distance) {
  std::vector<Point<Clip>> kept;
  for (const Point<Clip>& p : outline_of(values)) {
    if (kept.empty() || vertex_distance(kept.back(), p) > min_distance) kept.push_back(p);
  }
  while (kept.size() > 1 && vertex_distance(kept.back(), kept.front()) <= min_distance)
    kept.pop_back();
  std::vector<double> left;
  for (const Point<Clip>& p : kept) left.insert(left.end(), {p.x, p.y, p.z, p.w});
  if (kept.size() < 3) left.clear();
  return left;
}

// Compares the polygons with each vertex of the answer as the first one, and returns the result
// with the fewest differences.
std::optional<Divergence> compare_from_any(const Expected& expected,
                                           const std::vector<double>& actual) {
  Comparison best = compare(expected, actual);
  if (actual.size() != expected.values.size()) return best.first;
  for (std::size_t start = 4; start < actual.size(); start += 4) {
    std::vector<double> turned = actual;
    std::rotate(turned.begin(), turned.begin() + std::ptrdiff_t(start), turned.end());
    Comparison comparison = compare(expected, turned);
    if (comparison.differing < best.differing) best = std::move(comparison);
  }
  return best.first;
}

// Where on the outline, which is closed, the point is: number of the edge, plus the share of the
// edge that is before it. Nothing if no edge passes within `reach`.
std::optional<double> place_on_outline(const std::vector<double>& outline, const double* point,
                                       double reach) {
  std::optional<double> place;
  double least = reach;
  const std::size_t count = outline.size() / 4;
  for (std::size_t i = 0; i < count; ++i) {
    const double *a = outline.data() + 4 * i, *b = outline.data() + 4 * ((i + 1) % count);
    double along = 0, length = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      along += (point[k] - a[k]) * (b[k] - a[k]);
      length += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    double distance = 0;
    for (std::size_t k = 0; k < 4; ++k)
      distance = std::max(distance, std::abs(a[k] + t * (b[k] - a[k]) - point[k]));
    if (!(distance <= least) || (place && distance == least)) continue;
    least = distance;
    place = double(i) + t;
  }
  return place;
}

// Whether all vertices are near a place where the triangle only touches the frustum. Rounding may
// leave a tiny triangle there.
bool is_near(const std::vector<double>& touched, const std::vector<double>& actual, double reach) {
  for (std::size_t i = 0; i + 4 <= actual.size(); i += 4) {
    if (!place_on_outline(touched, actual.data() + i, reach)) return false;
  }
  return true;
}

bool has_vertex_near(const std::vector<double>& outline, const double* point, double reach) {
  for (std::size_t i = 0; i < outline.size(); i += 4) {
    double distance = 0;
    for (std::size_t k = 0; k < 4; ++k)
      distance = std::max(distance, std::abs(outline[i + k] - point[k]));
    if (distance <= reach) return true;
  }
  return false;
}

// How many planes of the frustum pass within `reach` of the point, measured along each axis. Such a
// step changes the distance from the plane by `reach` times its coefficients' sum at most.
std::ptrdiff_t planes_near(const double* point, double reach) {
  return std::count_if(lab_05::kFrustum.begin(), lab_05::kFrustum.end(), [&](const auto& p) {
    const double sum = std::abs(p.a) + std::abs(p.b) + std::abs(p.c) + std::abs(p.d);
    const double distance = p.a * point[0] + p.b * point[1] + p.c * point[2] + p.d * point[3];
    return std::abs(distance) <= sum * reach;
  });
}

// Whether rounding may have put a vertex there that the exact outline does not have: a crossing of
// a plane with an edge of the triangle, or with an edge that another plane made.
bool may_be_crossing(const ExactOutline& outline, const double* point, double reach) {
  const bool on_own_edge = place_on_outline(outline.corners, point, reach).has_value();
  return planes_near(point, reach) >= (on_own_edge ? 1 : 2);
}

// Whether two outlines are the same line, passed in the same direction, although their vertices
// differ. If a crossing is exactly on a later plane, its rounding decides whether that plane cuts
// it off, which may add or remove a vertex; the line moves by no more than the bound.
bool are_one_line(const ExactOutline& outline, const std::vector<double>& actual, double reach) {
  const std::vector<double>& exact = outline.expected.values;
  if (exact.size() < 12 || actual.size() < 12 || actual.size() % 4 != 0) return false;
  for (std::size_t i = 0; i < exact.size(); i += 4) {
    if (!place_on_outline(actual, exact.data() + i, reach)) return false;
  }
  std::vector<double> places;
  for (std::size_t i = 0; i < actual.size(); i += 4) {
    const double* vertex = actual.data() + i;
    const auto place = place_on_outline(exact, vertex, reach);
    if (!place) return false;
    if (!has_vertex_near(exact, vertex, reach) && !may_be_crossing(outline, vertex, reach))
      return false;
    places.push_back(*place);
  }
  // Around the outline each place is larger than the one before, except once, where the outline
  // closes.
  int descents = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    descents += places[(i + 1) % places.size()] < places[i] ? 1 : 0;
  return descents == 1;
}

}  // namespace

std::optional<Divergence> compare_outlines(const ExactOutline& outline, const Answer& answer) {
  const Expected& expected = outline.expected;
  const auto* actual = find_field(answer, expected.field);
  if (actual == nullptr) return compare(expected, answer).first;
  if (auto found = find_degenerate_outline(*actual)) return found;
  const auto found = compare_from_any(expected, *actual);
  if (!found) return found;
  if (expected.values.empty() && is_near(outline.touched, *actual, 2 * expected.bound))
    return std::nullopt;
  // Two vertices that differ by less than the bound may be one vertex in the answer.
  Expected fewer = expected;
  fewer.values = without_near_vertices(expected.values, 2 * expected.bound);
  const bool some_are_near = fewer.values.size() < expected.values.size();
  const auto merged =
      some_are_near ? compare_from_any(fewer, without_near_vertices(*actual, 2 * expected.bound))
                    : found;
  if (!merged || are_one_line(outline, *actual, 2 * expected.bound)) return std::nullopt;
  return merged;
}

std::optional<Divergence> compare_shared_edges(const lab_05::PairsCase& pairs,
                                               const Answer& answer) {
  const std::vector<ClipPlane> planes = pipeline_frustum();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& shared = pairs[i].shared;
    const auto left = clip_segment({ClipVertex{shared[0], {}}, ClipVertex{shared[1], {}}}, planes);
    if (!left) continue;
    const auto first = pairs[i].first(), second = pairs[i].second();
    // Twice the bound, because the ends of the expected segment are rounded as well.
    const double bound = 2 * std::max(bound_of(first, planes), bound_of(second, planes));
    const auto one = outline_of(field_of(answer, fmt::format("first {}", i)));
    const auto two = outline_of(field_of(answer, fmt::format("second {}", i)));
    for (const ClipVertex& end : *left) {
      const auto at_one = nearest(one, end.position), at_two = nearest(two, end.position);
      const auto there = [&](const std::optional<Point<Clip>>& vertex) {
        return vertex && vertex_distance(*vertex, end.position) <= bound;
      };
      Divergence found{
          .kind = Divergence::Kind::kPosition,
          .field = fmt::format("second {}", i),
          .element = fmt::format("edge {}", i),
          .unit = "clip units",
          .explanation = fmt::format("the shared edge ends at ({}, {}, {}, {})", end.position.x,
                                     end.position.y, end.position.z, end.position.w)};
      if (!there(at_one) || !there(at_two)) {
        const bool is_second = there(at_one);
        const auto& vertex = is_second ? at_two : at_one;
        found.kind = Divergence::Kind::kMissing;
        found.field = fmt::format("{} {}", is_second ? "second" : "first", i);
        found.element += ", x of its end";
        found.expected = end.position.x;
        found.actual = std::numeric_limits<double>::quiet_NaN();
        found.bound = bound;
        found.distance = std::numeric_limits<double>::infinity();
        found.explanation +=
            vertex ? fmt::format(", but this polygon's nearest vertex is ({}, {}, {}, {})",
                                 vertex->x, vertex->y, vertex->z, vertex->w)
                   : ", but this polygon is empty";
        return found;
      }
      if (*at_one == *at_two) continue;
      const std::array<float, 4> a{at_one->x, at_one->y, at_one->z, at_one->w};
      const std::array<float, 4> b{at_two->x, at_two->y, at_two->z, at_two->w};
      std::size_t k = 0;
      while (a[k] == b[k]) ++k;
      found.index = k;
      found.element += fmt::format(", {}", "xyzw"[k]);
      found.expected = a[k];
      found.actual = b[k];
      found.distance = std::abs(found.expected - found.actual);
      found.ulps = double(ulp_distance(a[k], b[k]));
      found.explanation +=
          ": the triangle that passes it in the other direction cuts it at a different place, "
          "which leaves a crack";
      return found;
    }
  }
  return std::nullopt;
}

std::optional<Divergence> compare_coverage(int count, const Answer& answer) {
  const Expected expected{.field = "coverage",
                          .shape = Shape::kCoverage,
                          .values = std::vector<double>(std::size_t(kWindow.x1 * kWindow.y1), 1),
                          .unit = "triangles",
                          .columns = kWindow.x1};
  std::vector<double> counts(expected.values.size(), 0);
  for (int i = 0; i < count; ++i) {
    const std::string name = fmt::format("triangle {}", i);
    const auto outline = outline_of(field_of(answer, name));
    if (const auto why = cannot_be_drawn(outline)) {
      return Divergence{.kind = Divergence::Kind::kPosition,
                        .field = name,
                        .distance = std::numeric_limits<double>::infinity(),
                        .explanation = *why};
    }
    for_each_covered(outline, kViewport, kWindow, [&](const Coverage& pixel) {
      ++counts[std::size_t(pixel.y * kWindow.x1 + pixel.x)];
    });
  }
  return compare(expected, counts).first;
}

}  // namespace glassbox::labs
