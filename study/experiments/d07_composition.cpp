// D-7: view and projection as one matrix or as two, far from the origin (Upchurch and Desbrun 2012).
#include <cmath>
#include <limits>

#include <glassbox/pipeline/divide.h>

#include "study/experiment/experiment.h"
#include "study/experiments/consume.h"
#include "study/experiments/d01_shots.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace {

// ---- the scene ----

constexpr double kNear = 0.1, kDistance = 10;

// The vertices' coordinates in the world are floats exactly (multiples of 1/8 below 2^21), and so is the eye: all errors are
// the arithmetic's.
struct Field {
  exact::PythagoreanRotation eye_from_world;
  Vector<World, double> eye;
  std::vector<Point<World>> points;  // 10 units along the gaze, give or take rounding to eighths
};

double in_eighths(double x) {
  return std::floor(x * 8 + 0.5) / 8;
}

Field make_field(std::uint64_t seed, double offset, int points) {
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

DepthPlanes planes(Depth depth) {
  if (depth == Depth::kStandard) return {kNear, 1000};
  return {kNear, std::numeric_limits<double>::infinity(), DepthRange::kReversed};
}
Transform<Clip, Eye> projection(Depth depth) {
  return *perspective_degrees(90, 1, planes(depth));
}
Transform<Eye, World> view_of(const Field& field) {
  const glm::dvec3 moved = rounded(field.eye_from_world) * to_glm(field.eye);
  return placed<Eye, World>(field.eye_from_world, Vector<Eye, double>(-moved));
}

// ---- the ways ----

// One matrix, composed in double and rounded once.
class Composed {
public:
  Composed(const Field& field, Depth depth)
      : clip_from_world_(round_to_float(projection(depth) * view_of(field))) {}
  Point<Clip> operator()(const Point<World>& p) const { return clip_from_world_ * p; }

private:
  Transform<Clip, World, float> clip_from_world_;
};

// Two matrices, each rounded: the errors of the view are the same in z and w.
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

// The eye is subtracted first, here without error; then the camera's rotation alone.
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

constexpr int kPointsOfField = 64;

// The depth's error as a distance along the gaze: z^2 (f - n)/(f n) for each unit of depth.
double distance_of(Depth depth) {
  return square(kDistance) / kNear * (depth == Depth::kStandard ? 1 - kNear / 1000 : 1);
}

template <class Way>
double rms_error(Depth depth, double offset, int fields) {
  using exact::Decimal;
  double sum = 0;
  for (int i = 0; i < fields; ++i) {
    const Field field = make_field(std::uint64_t(i) + 1, offset, kPointsOfField);
    const Way way(field, depth);
    const auto rotation = exact::exactly<Decimal>(field.eye_from_world);
    const auto clip_from_eye = exact::exactly<Decimal>(projection(depth));
    for (const Point<World>& p : field.points) {
      const exact::Vector4<Decimal> from_eye{
          Decimal(double(p.x)) - Decimal(field.eye.x), Decimal(double(p.y)) - Decimal(field.eye.y),
          Decimal(double(p.z)) - Decimal(field.eye.z), Decimal(1)};
      const auto right = clip_from_eye * (rotation * from_eye);
      sum += square(exact::error_of(divide(way(p)).position.z, right[2] / right[3]));
    }
  }
  return std::sqrt(sum / (fields * kPointsOfField)) * distance_of(depth);
}

// ---- the theory, all as root mean squares ----

// A row of the view over coordinates of size D: entries, products and 5/3 sums of squares D^2/3 each, the translation's
// rounding another.
double of_row(double offset) {
  return rms_rounding<float> * offset * std::sqrt(14.0 / 9);
}
// The rotation alone over a vertex ~11.5 units away: the last sum is the result.
double of_rotation() {
  const double squared = square(kDistance) + 2 * 25.0 / 3;
  return rms_rounding<float> * std::sqrt(squared / 3 * (2 + 2.0 / 3) + square(kDistance));
}
// What the projection and the divide add to the depth d, in units of the world. Standard: d is just below 1, and so are the
// products before it: the matrix's two entries, a product, a sum, and a quotient in steps of 2^-24. Reversed: n and the quotient.
double of_depth(Depth depth) {
  if (depth == Depth::kStandard)
    return distance_of(depth) *
           std::sqrt(3 * square(rms_rounding<float>) + square(rms_of_step(unit_roundoff<float>)));
  return kDistance * std::sqrt(2.0) * rms_rounding<float>;
}

double combined(double a, double b) {
  return std::sqrt(square(a) + square(b));
}

using Theory = double (*)(Depth, double offset);

// Standard depth: z and w are off by of_row each, independently, and so d by sqrt(2) of_row / z, which is worth z/n times as much along
// the gaze. Reversed with an infinite far plane: z is n, exactly, and the error is w's, once.
double predict_composed(Depth depth, double offset) {
  const double row = of_row(offset);
  return combined(depth == Depth::kStandard ? std::sqrt(2.0) * row * kDistance / kNear : row,
                  of_depth(depth));
}
// The vertex is seen at a wrong distance, once.
double predict_separate(Depth depth, double offset) {
  return combined(of_row(offset), of_depth(depth));
}
double predict_eye_first(Depth depth, double) {
  return combined(of_rotation(), of_depth(depth));
}

// ---- the table ----

constexpr int kTimedPoints = 1 << 9, kRounds = 1 << 8;  // they stay in the first cache

template <class Way>
void add_series(std::vector<Configuration>& all, const std::string& series, Theory theory,
                Effort effort) {
  const int fields = effort == Effort::kFull ? 320 : 32;
  for (const Depth depth : {Depth::kStandard, Depth::kReversedInfinite}) {
    for (const double offset : {1e2, 1e3, 1e4, 1e5, 1e6}) {
      const Field field = make_field(1, offset, kTimedPoints);
      all.push_back({.series = series,
                     .parameter = offset,
                     .scene = depth == Depth::kStandard ? "depth 0..1, planes at 0.1 and 1000"
                                                        : "depth reversed, infinite far plane",
                     .error = [=] { return rms_error<Way>(depth, offset, fields); },
                     .predicted_error = theory(depth, offset),
                     .work = rounds_of(kRounds, field.points, Way(field, depth)),
                     .items = double(kTimedPoints) * kRounds});
    }
  }
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  add_series<Composed>(all, "one matrix", predict_composed, effort);
  add_series<Separate>(all, "view, then projection", predict_separate, effort);
  add_series<EyeFirst>(all, "minus the eye, rotation, projection", predict_eye_first, effort);
  return all;
}

}  // namespace

Experiment d07_composition() {
  return {
      .id = "D-7",
      .name = "View and projection: one matrix or two",
      .question =
          "How far apart must two surfaces be for the depth test to order them, when the matrices "
          "are composed?",
      .axis = "distance of the camera from the origin",
      .axis_unit = "units",
      .error =
          "root mean square error of the depth, as a distance along the gaze (at 10 units): "
          "surfaces closer than that are drawn in either order",
      .error_unit = "units",
      .reference = "50 digits, for vertices and an eye that are floats exactly",
      .theory =
          "roundings counted as random, 0.42 u each: 0.53 u D in a row of the matrix. In one "
          "matrix, z and w have their own, which for depth 0..1 is worth sqrt(2) z/n as much along "
          "the gaze; in two matrices they share it, and with z = n exactly (reversed, infinite far "
          "plane) only w has it. With the eye subtracted first nothing grows with D",
      .item = "vertex",
      .configurations = configurations};
}

}  // namespace glassbox::study
