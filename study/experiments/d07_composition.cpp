// Compares view and projection as one matrix with two separate matrices, far from the origin
// (Upchurch and Desbrun 2012; D-7).
#include <cmath>
#include <limits>

#include <glassbox/pipeline/divide.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d07_field.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace d07 {

// ---- the methods ----

// Multiplies view and projection to one matrix in double, which is rounded to float once.
class Composed {
public:
  Composed(const Field& field, Depth depth)
      : clip_from_world_(round_to_float(projection(depth) * view_of(field))) {}
  Point<Clip> operator()(const Point<World>& p) const { return clip_from_world_ * p; }

private:
  Transform<Clip, World, float> clip_from_world_;
};

// Keeps view and projection as two matrices, each rounded to float. z and w are computed from the
// same eye coordinates, so the errors of the view affect both in the same way.
class Separate {
public:
  Separate(const Field& field, Depth depth)
      : eye_from_world_(round_to_float(view_of(field))),
        clip_from_eye_(round_to_float(projection(depth))) {}
  Point<Clip> operator()(const Point<World>& p) const {
    return clip_from_eye_ * (eye_from_world_ * p);
  }

private:
  Transform<Eye, World, float> eye_from_world_;
  Transform<Clip, Eye, float> clip_from_eye_;
};

// Subtracts the eye first, which is exact here (all numbers are multiples of 1/8); then only the
// camera's rotation is left.
class EyeFirst {
public:
  EyeFirst(const Field& field, Depth depth)
      : eye_(float(field.eye.x), float(field.eye.y), float(field.eye.z)),
        rotation_(round_to_float(placed<Eye, World>(field.eye_from_world, {0, 0, 0}))),
        clip_from_eye_(round_to_float(projection(depth))) {}
  Point<Clip> operator()(const Point<World>& p) const {
    const Vector<World> from_eye = p - eye_;
    const Vector<Eye> e = rotation_ * from_eye;
    return clip_from_eye_ * Point<Eye>(e.x, e.y, e.z);
  }

private:
  Point<World> eye_;
  Transform<Eye, World, float> rotation_;
  Transform<Clip, Eye, float> clip_from_eye_;
};

// ---- the error ----

template <class Method>
double rms_error(Depth depth, double offset, int fields) {
  double sum = 0;
  for (int i = 0; i < fields; ++i) {
    const Field field = make_field(std::uint64_t(i) + 1, offset, kPointsOfField);
    const Method method(field, depth);
    add_squared_errors(
        field, depth, [&](std::size_t k) { return divide(method(field.points[k])).position.z; },
        sum);
  }
  return rms_of(sum, depth, fields);
}

// ---- the theory, all as root mean squares ----

// The error of a row of the view matrix, applied to coordinates of size D (`offset`): it rounds
// entries, products and 5/3 sums, with a mean square of D^2/3 each, and the translation once more.
// This makes 14/3 rounding errors.
double row_error(double offset) {
  return rms_rounding<float> * offset * std::sqrt(14.0 / 9);
}
// The error with the rotation alone, applied to a vertex about 10.8 units away: it rounds entries,
// products and the first sum; the last sum is the result, of size kDistance.
double rotation_error() {
  const double squared = square(kDistance) + 2 * 25.0 / 3;
  return rms_rounding<float> * std::sqrt(squared / 3 * (2 + 2.0 / 3) + square(kDistance));
}
// The error that projection and divide add to the depth d, converted to world units. Standard
// depth: d and the numbers before it are just below 1; a matrix entry, a product, a sum, and a
// quotient in steps of 2^-24 are rounded. Reversed depth: n (the near plane) and the quotient are
// rounded.
double depth_error(Depth depth) {
  if (depth == Depth::kStandard)
    return distance_of(depth) *
           std::sqrt(3 * square(rms_rounding<float>) + square(rms_of_step(unit_roundoff<float>)));
  return kDistance * std::sqrt(2.0) * rms_rounding<float>;
}

double combined(double a, double b) {
  return std::sqrt(square(a) + square(b));
}

using Theory = double (*)(Depth, double offset);

// Standard depth: z and w have independent errors of row_error each, so the depth z/w has an error
// of sqrt(2) row_error / distance. As a distance along the gaze, this is sqrt(2) row_error times
// distance / near plane. Reversed depth with an infinite far plane: z is exactly the near plane,
// and only w has an error.
double predict_composed(Depth depth, double offset) {
  const double row = row_error(offset);
  return combined(depth == Depth::kStandard ? std::sqrt(2.0) * row * kDistance / kNear : row,
                  depth_error(depth));
}
// z and w have the same error, so the vertex only seems to be at a slightly different distance.
double predict_separate(Depth depth, double offset) {
  return combined(row_error(offset), depth_error(depth));
}
double predict_eye_first(Depth depth, double) {
  return combined(rotation_error(), depth_error(depth));
}

// ---- the table ----

// 512 points fit into the first-level cache
constexpr int kTimedPoints = 1 << 9, kRounds = 1 << 8;

template <class Method>
void add_series(std::vector<Configuration>& all, const std::string& series, Theory theory,
                Effort effort) {
  const int fields = effort == Effort::kFull ? 320 : 32;
  for (const Depth depth : {Depth::kStandard, Depth::kReversedInfinite}) {
    for (const double offset : {1e2, 1e3, 1e4, 1e5, 1e6}) {
      const Field field = make_field(1, offset, kTimedPoints);
      all.push_back({.series = series,
                     .parameter = offset,
                     .scene = name_of(depth),
                     .error = [=] { return rms_error<Method>(depth, offset, fields); },
                     .predicted_error = theory(depth, offset),
                     .work = repeated_work(kRounds, field.points, Method(field, depth)),
                     .items = double(kTimedPoints) * kRounds});
    }
  }
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  add_series<Composed>(all, "one matrix", predict_composed, effort);
  add_series<Separate>(all, "view, then projection", predict_separate, effort);
  add_series<EyeFirst>(all, "three steps: minus the eye, rotation, projection", predict_eye_first,
                       effort);
  return all;
}

}  // namespace d07

Experiment d07_composition() {
  using namespace d07;
  return {.id = "D-7",
          .name = "View and projection: one matrix or two",
          .question =
              "How far apart must two surfaces be for the depth test to order them, if the "
              "matrices are composed?",
          .axis = "distance of the camera from the origin",
          .axis_unit = "units",
          .error =
              "root mean square error of the depth, as a distance along the gaze (at 10 units): "
              "surfaces closer together than this may be drawn in either order",
          .error_unit = "units",
          .reference = "50 digits, for vertices and an eye that are exactly floats",
          .theory =
              "Each rounding error counts as random, 0.42 u (u = 2^-24), which gives 0.53 u D for "
              "a row of the matrix, where D is the distance from the origin. With one matrix, z "
              "and w have independent errors, which for depth 0..1 and the near plane n are "
              "sqrt(2) z/n times as large along the gaze. With two matrices z and w share one "
              "error, and if z = n exactly (reversed, infinite far plane), only w has one. If the "
              "eye is subtracted first, no error grows with D",
          .item = "vertex",
          .configurations = configurations};
}

}  // namespace glassbox::study
