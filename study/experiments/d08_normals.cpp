// Compares the normal of a polygon from three corners, from the best three, and from all of them
// (D-8).
#include <algorithm>
#include <cmath>
#include <span>

#include <glassbox/mesh/normals.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d08_polygons.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace d08 {

template <class T>
using Corners = std::array<Point<Object, T>, kPolygonCorners>;

// ---- the methods ----

template <class T>
Vector<Object, T> corner_normal(const Corners<T>& p, std::size_t middle) {
  return three_point_normal(p[(middle + kPolygonCorners - 1) % kPolygonCorners], p[middle],
                            p[(middle + 1) % kPolygonCorners]);
}

ExactVector widened(const Vector<Object>& v) {
  return {v.x, v.y, v.z};
}

ExactVector first_corner(const FloatPolygon& p) {
  return widened(corner_normal(p, 1));
}

// Uses the corner with the longest cross product. This is right for convex polygons only: a reflex
// corner gives the opposite direction.
ExactVector best_corner(const FloatPolygon& p) {
  Vector<Object> best(0, 0, 0);
  for (std::size_t i = 0; i < kPolygonCorners; ++i) {
    const Vector<Object> m = corner_normal(p, i);
    if (dot(m, m) > dot(best, best)) best = m;
  }
  return widened(best);
}

// Newell's sums over the coordinates as they are, not relative to a corner (S4.33).
ExactVector raw_newell(const FloatPolygon& p) {
  Vector<Object> m(0, 0, 0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point<Object>&a = p[i], &b = p[(i + 1) % p.size()];
    m.x += (a.y - b.y) * (a.z + b.z);
    m.y += (a.z - b.z) * (a.x + b.x);
    m.z += (a.x - b.x) * (a.y + b.y);
  }
  return widened(m);
}

// Newell's sums in the pipeline's own code, which uses coordinates relative to the first corner.
ExactVector newell(const FloatPolygon& p) {
  return widened(newell_vector<float>(std::span<const Point<Object>>(p)));
}

ExactVector double_newell(const FloatPolygon& p) {
  ExactPolygon wide;
  for (std::size_t i = 0; i < p.size(); ++i) wide[i] = {p[i].x, p[i].y, p[i].z};
  return newell_vector<double>(std::span<const Point<Object, double>>(wide));
}

using Method = ExactVector (*)(const FloatPolygon&);

// ---- the error ----

using MakeCase = NormalCase (*)(std::uint64_t seed, double parameter);

// The angle itself is computed in double, so an exact normal may seem to have an error of 2^-53.
double rms_angle(Method method, MakeCase make, double parameter, int polygons) {
  double sum = 0;
  for (int i = 0; i < polygons; ++i) {
    const NormalCase c = make(std::uint64_t(i) + 1, parameter);
    sum += square(angle_between(method(c.corners), c.normal));
  }
  return std::sqrt(sum / polygons);
}

// ---- the theory, all as root mean squares ----

// The tilt of the normal from noise. A corner that moves out of the polygon's plane changes
// Newell's vector m by its height times the vector between its two neighbours. With heights of the
// standard deviation sigma, the normal tilts by sigma sqrt(sum |p_(i+1) - p_(i-1)|^2) / |m|. This
// also holds for the normal of three corners, which are a polygon too.
double tilt_of_noise(std::span<const PlanePoint> p) {
  double across = 0, twice_area = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const PlanePoint &a = p[i], &b = p[(i + 1) % p.size()], &c = p[(i + 2) % p.size()];
    across += square(c.x - a.x) + square(c.y - a.y);
    twice_area += a.x * b.y - a.y * b.x;
  }
  return arctan(kNoise * std::sqrt(across) / std::abs(twice_area));
}
double tilt_of_corner(const PlanePolygon& p, std::size_t middle) {
  const std::array<PlanePoint, 3> corner{p[middle - 1], p[middle], p[(middle + 1) % p.size()]};
  return tilt_of_noise(corner);
}
double noisy_first(double bend) {
  return tilt_of_corner(bent_octagon(bend), 1);
}
// The best corner is one that the bend does not change.
double noisy_best(double bend) {
  return tilt_of_corner(bent_octagon(bend), 5);
}
double noisy_all(double bend) {
  return tilt_of_noise(bent_octagon(bend));
}

// The tilt of the normal from rounding errors. Sums and differences of two coordinates are exact on
// the grid; each product is rounded once, and so is each partial sum. `squares` returns the sum of
// the squared errors over all three components; only two of the components tilt the normal. The
// result is the mean over the first hundred polygons.
template <class Squares>
double tilt_of_roundings(double offset, const Squares& squares) {
  double sum = 0;
  constexpr int kPolygons = 100;
  for (int i = 0; i < kPolygons; ++i)
    sum += squares(far_case(std::uint64_t(i) + 1, offset).corners) * 2 / 3;
  return rms_rounding<float> * std::sqrt(sum / kPolygons);
}
// Whether coordinates have so few bits that their products and sums need at most the 24 bits of a
// float.
bool is_exact(double offset) {
  return 2 * (grid_bits(offset) + 3) <= 24;
}

// The squared rounding errors of Newell's sums with coordinates relative to `origin`, divided by
// the squared length of the vector.
double squares_of_sums(const FloatPolygon& p, const glm::dvec3& origin) {
  glm::dvec3 partial(0);
  double squares = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const glm::dvec3 a = glm::dvec3(to_glm(p[i])) - origin;
    const glm::dvec3 b = glm::dvec3(to_glm(p[(i + 1) % p.size()])) - origin;
    const glm::dvec3 d = a - b, s = a + b;
    const glm::dvec3 term(d.y * s.z, d.z * s.x, d.x * s.y);
    partial += term;
    squares += glm::dot(term, term) + glm::dot(partial, partial);
  }
  return squares / glm::dot(partial, partial);
}
double far_raw(double offset) {
  return tilt_of_roundings(offset,
                           [](const FloatPolygon& p) { return squares_of_sums(p, glm::dvec3(0)); });
}
double far_newell(double offset) {
  if (is_exact(offset)) return 0;
  return tilt_of_roundings(
      offset, [](const FloatPolygon& p) { return squares_of_sums(p, glm::dvec3(to_glm(p[0]))); });
}
// For each component, a cross product rounds two products and their difference.
double far_cross(double offset) {
  if (is_exact(offset)) return 0;
  return tilt_of_roundings(offset, [](const FloatPolygon& p) {
    const glm::dvec3 a(to_glm(p[1] - p[0])), b(to_glm(p[2] - p[1]));
    const glm::dvec3 m = glm::cross(a, b);
    const glm::dvec3 plus(a.y * b.z, a.z * b.x, a.x * b.y), minus = plus - m;
    return (glm::dot(plus, plus) + glm::dot(minus, minus)) / glm::dot(m, m) + 1;
  });
}
double far_double(double) {
  return 0;
}

// ---- the table ----

struct Series {
  const char* name;
  Method method;
  double (*noisy)(double bend);
  double (*far)(double offset);
};
constexpr Series kSeries[] = {
    {"cross product at the first corner", first_corner, noisy_first, far_cross},
    {"cross product at the best corner", best_corner, noisy_best, far_cross},
    {"Newell, coordinates as they are", raw_newell, noisy_all, far_raw},
    {"Newell, relative to the first corner", newell, noisy_all, far_newell},
    {"Newell in double", double_newell, noisy_all, far_double},
};

constexpr int kTimedPolygons = 4096, kRounds = 20;

std::vector<FloatPolygon> timed_polygons() {
  std::vector<FloatPolygon> timed;
  for (int i = 0; i < kTimedPolygons; ++i)
    timed.push_back(noisy_case(std::uint64_t(i % 64) + 1, 0.1).corners);
  return timed;
}

std::vector<Configuration> configurations(Effort effort) {
  const int polygons = effort == Effort::kFull ? 5000 : 500;
  const std::vector<FloatPolygon> timed = timed_polygons();
  std::vector<Configuration> all;
  for (const Series& series : kSeries) {
    const auto add = [&](const char* scene, MakeCase make, double parameter, double predicted) {
      all.push_back(
          {.series = series.name,
           .parameter = parameter,
           .scene = scene,
           .error = [=, method =
                            series.method] { return rms_angle(method, make, parameter, polygons); },
           .predicted_error = predicted,
           .work = repeated_work(kRounds, timed, series.method),
           .items = double(kTimedPolygons) * kRounds});
    };
    for (const double bend : {1e-4, 1e-3, 1e-2, 1e-1})
      add("octagon whose second corner is bent by the value of the axis, heights wrong by up to "
          "1e-4",
          noisy_case, bend, series.noisy(bend));
    for (const double offset : {1.0, 1e2, 1e4, 1e6})
      add("flat octagon, as far from the origin as the value of the axis", far_case, offset,
          series.far(offset));
  }
  return all;
}

}  // namespace d08

Experiment d08_normals() {
  using namespace d08;
  return {.id = "D-8",
          .name = "Normals of polygons",
          .question =
              "From which corners should a polygon's normal be computed, and from which origin "
              "should they be measured?",
          .axis = "bend of the second corner, or distance from the origin",
          .axis_unit = "units; an octagon of radius 1",
          .error = "root mean square angle to the right normal",
          .error_unit = "radian",
          .reference =
              "the normal of the plane before the corners are moved off it; 50 digits for flat "
              "octagons far away",
          .theory =
              "Errors of the heights with the standard deviation sigma tilt the normal by sigma "
              "sqrt(sum |p_(i+1) - p_(i-1)|^2) / (2 area), where the sum is over the corners that "
              "are used. This is sigma sqrt(3/2)/bend for a cross product at the bent corner, and "
              "sigma for all corners. At the distance D from the origin, Newell's sums of raw "
              "coordinates round terms of size D, which gives an error of about 0.42 u D, where u "
              "is the unit roundoff, 2^-24 for floats; differences of corners are exact",
          .item = "polygon",
          .configurations = configurations};
}

}  // namespace glassbox::study
