// The vertices of the matrix-composition experiment (D-7), in front of a camera that is far from
// the origin.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/projection.h>

#include "exact/matrix.h"
#include "exact/number.h"
#include "study/experiments/d01_scenes.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study::d07 {

// ---- the scene ----

inline constexpr double kNear = 0.1, kDistance = 10;

// The eye and the vertices' world coordinates are exact floats (multiples of 1/8 below 2^21), so
// that every error comes from the arithmetic.
struct Field {
  exact::PythagoreanRotation eye_from_world;
  Vector<World, double> eye;
  std::vector<Point<World>> points;  // 10 units away along the gaze, rounded to multiples of 1/8
};

inline double in_eighths(double x) {
  return std::floor(x * 8 + 0.5) / 8;
}

inline Field make_field(std::uint64_t seed, double offset, int points) {
  Random random(seed);
  Field field;
  field.eye_from_world = exact::pythagorean_rotation(random);
  const Vector<World, double> eye = random_direction<World>(random) * offset;
  field.eye = {in_eighths(eye.x), in_eighths(eye.y), in_eighths(eye.z)};
  const glm::dmat3 world_from_eye = glm::transpose(rounded(field.eye_from_world));
  for (int i = 0; i < points; ++i) {
    const double x = random.between(-5, 5), y = random.between(-5, 5);
    const glm::dvec3 p = world_from_eye * glm::dvec3(x, y, -kDistance);
    field.points.emplace_back(float(in_eighths(p.x) + field.eye.x),
                              float(in_eighths(p.y) + field.eye.y),
                              float(in_eighths(p.z) + field.eye.z));
  }
  return field;
}

enum class Depth { kStandard, kReversedInfinite };

inline const char* name_of(Depth depth) {
  return depth == Depth::kStandard ? "depth 0..1, planes at 0.1 and 1000"
                                   : "depth reversed, infinite far plane";
}

inline DepthPlanes planes(Depth depth) {
  if (depth == Depth::kStandard) return {kNear, 1000};
  return {kNear, std::numeric_limits<double>::infinity(), DepthRange::kReversed};
}
inline Transform<Clip, Eye> projection(Depth depth) {
  return *perspective_degrees(90, 1, planes(depth));
}
inline Transform<Eye, World> view_of(const Field& field) {
  const glm::dvec3 moved = rounded(field.eye_from_world) * to_glm(field.eye);
  return placed<Eye, World>(field.eye_from_world, Vector<Eye, double>(-moved));
}

// ---- the error ----

inline constexpr int kPointsOfField = 64;

// Converts the depth's error to a distance along the gaze: z^2 (f - n)/(f n) for each unit of depth
// (z: distance; n and f: near and far plane).
inline double distance_of(Depth depth) {
  return square(kDistance) / kNear * (depth == Depth::kStandard ? 1 - kNear / 1000 : 1);
}

// Adds the squares of the errors of all depths in the field; `depth_of(i)` returns the computed
// depth of vertex i.
template <class DepthOf>
void add_squared_errors(const Field& field, Depth depth, const DepthOf& depth_of, double& sum) {
  using exact::Decimal;
  const auto rotation = exact::exactly<Decimal>(field.eye_from_world);
  const auto clip_from_eye = exact::exactly<Decimal>(projection(depth));
  for (std::size_t i = 0; i < field.points.size(); ++i) {
    const Point<World>& p = field.points[i];
    const exact::Vector4<Decimal> from_eye{Decimal(double(p.x)) - Decimal(field.eye.x),
                                           Decimal(double(p.y)) - Decimal(field.eye.y),
                                           Decimal(double(p.z)) - Decimal(field.eye.z), Decimal(1)};
    const auto right = clip_from_eye * (rotation * from_eye);
    sum += square(exact::error_of(depth_of(i), right[2] / right[3]));
  }
}

// The root mean square as a distance along the gaze, for `count` fields with this sum of squares.
inline double rms_of(double squares, Depth depth, int count) {
  return std::sqrt(squares / (count * kPointsOfField)) * distance_of(depth);
}

}  // namespace glassbox::study::d07
