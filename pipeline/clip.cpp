#include <glassbox/pipeline/clip.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/expansion.h>
#include <glassbox/base/rounding.h>

namespace glassbox {
namespace {

constexpr double kLargestFloat = double(std::numeric_limits<float>::max());

bool is_finite(const Point<Clip>& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

float round_to_float(double x) {
  return float(std::clamp(x, -kLargestFloat, kLargestFloat));
}

// Moves a rounded point onto the plane: recomputes one coordinate from the plane's equation and the
// rounded w. That is x, y or z if the plane has only one of these, or w if it has none.
void put_on_plane(const ClipPlane& plane, Point<Clip>& p) {
  const int coordinates = int(plane.a != 0) + int(plane.b != 0) + int(plane.c != 0);
  const auto solve = [](double others, double coefficient) {
    return round_to_float(-others / coefficient + 0.0);  // + 0.0: never -0
  };
  if (coordinates == 0 && plane.d != 0) p.w = solve(plane.e, plane.d);
  if (coordinates != 1) return;  // slanted plane: the rounded crossing is kept as it is
  const double others = plane.d * double(p.w) + plane.e;
  if (plane.a != 0) p.x = solve(others, plane.a);
  if (plane.b != 0) p.y = solve(others, plane.b);
  if (plane.c != 0) p.z = solve(others, plane.c);
}

// The point where the edge from p to q crosses the plane; their distances have opposite signs.
// Swapping p and q only swaps the terms of sums, which changes no bit of the result.
//
// Nothing overflows: coordinates are below 2^128, distances below 2^200 * 2^130. The result lies
// between two floats, so it rounds to one of them or to a float between them.
ClipVertex crossing(const ClipPlane& plane, const ClipVertex& p, double p_distance,
                    const ClipVertex& q, double q_distance) {
  const double p_size = std::abs(p_distance), q_size = std::abs(q_distance);
  const double sum = p_size + q_size;
  const auto between = [&](double at_p, double at_q) {
    return (at_p * q_size + at_q * p_size) / sum;
  };
  ClipVertex cut;
  cut.position = {
      round_to_float(between(p.position.x, q.position.x)),
      round_to_float(between(p.position.y, q.position.y)),
      round_to_float(between(p.position.z, q.position.z)),
      round_to_float(between(p.position.w, q.position.w)),
  };
  put_on_plane(plane, cut.position);
  for (std::size_t i = 0; i < 3; ++i) cut.weights[i] = between(p.weights[i], q.weights[i]);
  return cut;
}

using Distances = decltype(ClipStep::distances);

// In exact arithmetic the vertices outside a plane are consecutive, because the polygon is convex
// and flat. Earlier crossings were rounded, so a polygon that is nearly in the plane may have two
// separate runs of vertices outside it. Then only the run with the most distant vertex is cut off.
// The other vertices outside, which are outside only because of rounding, get the distance 0, as if
// they were on the plane. So each plane adds one vertex at most, and kMaxClipVertices are enough
// for any input.
void keep_deepest_dip(Distances& distances, int count) {
  const auto at = [&](int i) -> double& { return distances[std::size_t((i + count) % count)]; };
  int deepest = 0;
  for (int i = 1; i < count; ++i) {
    if (at(i) < at(deepest)) deepest = i;
  }
  int first = deepest, last = deepest;
  while (last - first + 1 < count && at(first - 1) < 0) --first;
  while (last - first + 1 < count && at(last + 1) < 0) ++last;
  for (int i = last + 1; i < first + count; ++i) {
    if (at(i) < 0) at(i) = 0;
  }
}

void append(ClipPolygon& polygon, const ClipVertex& vertex) {
  polygon.vertices[std::size_t(polygon.count++)] = vertex;
}

// Clips a polygon by one plane.
ClipStep clip_by_plane(const ClipPolygon& polygon, const ClipPlane& plane) {
  ClipStep step;
  bool any_outside = false;
  for (int i = 0; i < polygon.count; ++i) {
    double& distance = step.distances[std::size_t(i)];
    distance = signed_distance(plane, polygon.vertices[std::size_t(i)].position);
    any_outside = any_outside || distance < 0;
  }
  if (any_outside) keep_deepest_dip(step.distances, polygon.count);
  const auto keep = [&step](const ClipVertex& vertex, int from, int to) {
    step.sources[std::size_t(step.after.count)] = {from, to};
    append(step.after, vertex);
  };
  for (int i = 0; i < polygon.count; ++i) {
    const int j = (i + 1) % polygon.count;
    const ClipVertex& here = polygon.vertices[std::size_t(i)];
    const ClipVertex& next = polygon.vertices[std::size_t(j)];
    const double d_here = step.distances[std::size_t(i)], d_next = step.distances[std::size_t(j)];
    if (d_here >= 0) keep(here, i, i);
    if ((d_here > 0 && d_next < 0) || (d_here < 0 && d_next > 0)) {
      keep(crossing(plane, here, d_here, next, d_next), i, j);
    }
  }
  return step;
}

// Removes each vertex that has the same position as the vertex before it. If fewer than three
// vertices are left, the result is empty.
ClipPolygon without_repetitions(const ClipPolygon& polygon) {
  ClipPolygon tidy;
  for (int i = 0; i < polygon.count; ++i) {
    const ClipVertex& vertex = polygon.vertices[std::size_t(i)];
    if (tidy.count > 0 && tidy.vertices[std::size_t(tidy.count - 1)].position == vertex.position) {
      continue;
    }
    append(tidy, vertex);
  }
  while (tidy.count > 1 &&
         tidy.vertices[std::size_t(tidy.count - 1)].position == tidy.vertices[0].position) {
    --tidy.count;
  }
  if (tidy.count < 3) tidy.count = 0;
  return tidy;
}

Vector<Object, double> sizes_of(const Vector<Object, double>& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

}  // namespace

std::array<ClipPlane, 6> frustum_planes(DepthRange depth_range) {
  const bool standard = depth_range == DepthRange::kStandard;
  const ClipPlane z_low{0, 0, 1, 0, 0, standard ? "near" : "far"};
  const ClipPlane z_high{0, 0, -1, 1, 0, standard ? "far" : "near"};
  return {standard ? z_low : z_high, standard ? z_high : z_low, {1, 0, 0, 1, 0, "left"},
          {-1, 0, 0, 1, 0, "right"}, {0, 1, 0, 1, 0, "bottom"}, {0, -1, 0, 1, 0, "top"}};
}

ClipPlane opengl_near_plane() {
  return {0, 0, 1, 1, 0, "near (OpenGL)"};
}

std::array<ClipPlane, 4> guard_band_planes(const Viewport& viewport) {
  const double width = std::abs(double(viewport.width()));
  const double height = std::abs(double(viewport.height()));
  constexpr double kBand = 2 * kGuardBandPx;
  return {{{width, 0, 0, kBand, 0, "guard band, left"},
           {-width, 0, 0, kBand, 0, "guard band, right"},
           {0, height, 0, kBand, 0, "guard band, bottom"},
           {0, -height, 0, kBand, 0, "guard band, top"}}};
}

std::array<ClipPlane, kMaxClipPlanes> render_planes(const View& view) {
  const std::array<ClipPlane, 6> frustum = frustum_planes(view.depth_range);
  // The smallest w is a float, so that the w of a vertex can be equal to it, and not subnormal, so
  // that 1/w is finite.
  const double smallest_w =
      std::max(double(std::numeric_limits<float>::min()),
               double(round_to_float(view.perspective ? view.near / 2 : 0.5)));
  const ClipPlane eye{0, 0, 0, 1, -smallest_w, "eye"};
  const bool noise_only = view.depth_range == DepthRange::kStandard && std::isinf(view.far);
  const ClipPlane far = noise_only ? ClipPlane{0, 0, -1, 2, 0, "far (infinite)"} : frustum[1];
  const std::array<ClipPlane, 4> guard = guard_band_planes(view.viewport);
  return {frustum[0], eye, far, guard[0], guard[1], guard[2], guard[3]};
}

double signed_distance(const ClipPlane& plane, const Point<Clip>& p) {
  const std::array<double, 5> coefficients{plane.a, plane.b, plane.c, plane.d, plane.e};
  const std::array<double, 5> coordinates{p.x, p.y, p.z, p.w, 1};
  return sum_of_products(coefficients, coordinates);
}

Outcode outcode(const Point<Clip>& position, std::span<const ClipPlane> planes) {
  if (!is_finite(position)) return ~Outcode{0};
  Outcode code = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (signed_distance(planes[i], position) < 0) code |= Outcode{1} << i;
  }
  return code;
}

ClipVerdict trivial_verdict(std::span<const Outcode> outcodes) {
  Outcode all = ~Outcode{0}, any = 0;
  for (const Outcode code : outcodes) {
    all &= code;
    any |= code;
  }
  if (any == 0) return ClipVerdict::kAccept;
  return all != 0 || (any & kNotFinite) != 0 ? ClipVerdict::kReject : ClipVerdict::kClip;
}

bool may_overflow(const Box<Object>& box, const Transform<Clip, Object, float>& clip_from_object) {
  const Vector<Object, double> low = sizes_of({box.low.x, box.low.y, box.low.z});
  const Vector<Object, double> high = sizes_of({box.high.x, box.high.y, box.high.z});
  const auto size_of_row = [&](int row) {
    const auto slope = [&](int k) { return std::abs(double(clip_from_object.at(row, k))); };
    return slope(0) * std::max(low.x, high.x) + slope(1) * std::max(low.y, high.y) +
           slope(2) * std::max(low.z, high.z) + slope(3);
  };
  const auto is_large = [&](int row) { return !(size_of_row(row) <= kLargestFloat / 2); };
  return is_large(0) || is_large(1) || is_large(2) || is_large(3);
}

PlaneOverBoxes::PlaneOverBoxes(const ClipPlane& plane,
                               const Transform<Clip, Object, float>& clip_from_object) {
  const std::array<double, 4> coefficients{plane.a, plane.b, plane.c, plane.d};
  // The relative error of a term: four roundings of the float transform, a dozen in double here and
  // in distance_range(), and a few in the error bound itself.
  constexpr double kShare = gamma<float>(4) * (1 + 0x1p-40) + gamma<double>(20);
  std::array<double, 4> slope{}, error{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double term = coefficients[row] * double(clip_from_object.at(int(row), int(k)));
      slope[k] += term;
      error[k] += kShare * std::abs(term);
    }
    error[3] += std::abs(coefficients[row]) * (4 * 0x1p-149);  // for products that are subnormal
  }
  slope_ = {slope[0], slope[1], slope[2]};
  error_ = {error[0], error[1], error[2]};
  offset_ = slope[3] + plane.e;
  error_offset_ = error[3] + gamma<double>(20) * std::abs(plane.e);
}

PlaneOverBoxes::Distances PlaneOverBoxes::distance_range(const Box<Object>& box) const {
  return distance_range(box.center(),
                        {box.high.x * 0.5 - box.low.x * 0.5, box.high.y * 0.5 - box.low.y * 0.5,
                         box.high.z * 0.5 - box.low.z * 0.5});
}

PlaneOverBoxes::Distances PlaneOverBoxes::distance_range(const Point<Object, double>& centre,
                                                         const Vector<Object, double>& half) const {
  const Vector<Object, double> middle{centre.x, centre.y, centre.z};
  const double distance = dot(slope_, middle) + offset_;
  const double reach =
      dot(sizes_of(slope_), half) + dot(error_, sizes_of(middle) + half) + error_offset_;
  return {distance - reach, distance + reach};
}

ClipVerdict classify_box(const Box<Object>& box,
                         const Transform<Clip, Object, float>& clip_from_object,
                         std::span<const ClipPlane> planes) {
  if (box.empty()) return ClipVerdict::kReject;
  // The bounds below do not hold if a coordinate overflows, so each vertex has to be tested.
  if (may_overflow(box, clip_from_object)) return ClipVerdict::kClip;
  bool inside_all = true;
  for (const ClipPlane& plane : planes) {
    const auto [least, greatest] = PlaneOverBoxes(plane, clip_from_object).distance_range(box);
    if (greatest < 0) return ClipVerdict::kReject;
    inside_all = inside_all && least >= 0;
  }
  return inside_all ? ClipVerdict::kAccept : ClipVerdict::kClip;
}

ClipPolygon clip_triangle(const std::array<ClipVertex, 3>& triangle,
                          std::span<const ClipPlane> planes, std::vector<ClipStep>* steps) {
  ClipPolygon polygon;
  for (const ClipVertex& vertex : triangle) {
    if (!is_finite(vertex.position)) return {};
    append(polygon, vertex);
  }
  for (const ClipPlane& plane : planes) {
    const ClipStep step = clip_by_plane(polygon, plane);
    if (steps != nullptr) steps->push_back(step);
    polygon = step.after;
    if (polygon.count == 0) return polygon;
  }
  return without_repetitions(polygon);
}

int fan_size(const ClipPolygon& polygon) {
  return std::max(0, polygon.count - 2);
}

std::array<ClipVertex, 3> fan_triangle(const ClipPolygon& polygon, int i) {
  return {polygon.vertices[0], polygon.vertices[std::size_t(i + 1)],
          polygon.vertices[std::size_t(i + 2)]};
}

std::optional<std::array<ClipVertex, 2>> clip_segment(const std::array<ClipVertex, 2>& segment,
                                                      std::span<const ClipPlane> planes) {
  auto [p, q] = segment;
  if (!is_finite(p.position) || !is_finite(q.position)) return std::nullopt;
  const bool is_a_point = p.position == q.position;
  for (const ClipPlane& plane : planes) {
    const double d_p = signed_distance(plane, p.position);
    const double d_q = signed_distance(plane, q.position);
    if (d_p >= 0 && d_q >= 0) continue;
    if (d_p <= 0 && d_q <= 0) return std::nullopt;
    (d_p < 0 ? p : q) = crossing(plane, p, d_p, q, d_q);
  }
  if (p.position == q.position && !is_a_point) return std::nullopt;
  return std::array{p, q};
}

bool clip_point(const Point<Clip>& position, std::span<const ClipPlane> planes) {
  return outcode(position, planes) == 0;
}

}  // namespace glassbox
