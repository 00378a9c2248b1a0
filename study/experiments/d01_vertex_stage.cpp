// Compares the number formats in which a vertex is transformed to the screen (D-1).
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "study/experiment/experiment.h"
#include "study/experiments/d01_methods.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/memoize.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace d01 {

// ---- the error ----

constexpr int kPointsPerScene = 64;

// The names of the measures.
constexpr const char* kLargest = "largest error";
constexpr const char* kPlanes = "near plane moved";
constexpr const char* kDepth = "depth";

// The length of the picture's diagonal in px. Errors are limited to it, because a vertex with a
// larger error is simply in a wrong place.
double diagonal() {
  return std::sqrt(square(kVertexSceneWidth) + square(kVertexSceneHeight));
}

struct Errors {
  double rms = 0, largest = 0;  // in px
  double depth = 0;             // root mean square, as a distance along the gaze
};

// Converts an error of the depth d to a distance along the gaze. d = (1 - n/z) f/(f - n) changes
// with the distance z by n/z^2 f/(f - n) per unit (n and f: near and far plane).
double distance_of_depth(double error, double distance, const DepthPlanes& planes) {
  return error * square(distance) / planes.near * (1 - planes.near / planes.far);
}

template <class Method>
Errors errors_of(double offset, const DepthPlanes& planes, int scenes) {
  Errors errors;
  double sum = 0, depths = 0;
  for (int i = 0; i < scenes; ++i) {
    const VertexScene scene =
        make_vertex_scene(std::uint64_t(i) + 1, offset, kPointsPerScene, planes);
    const Method method(scene);
    const ExactVertexScene exact(scene);
    for (const Point<Object, double>& p : scene.points) {
      const auto placed = method(Method::input(p));
      const Pixels seen = Method::pixels(placed);
      const auto right = exact.screen(p);
      const double squared = std::min(
          square(exact::error_of(seen[0], right.x)) + square(exact::error_of(seen[1], right.y)),
          square(diagonal()));
      sum += squared;
      errors.largest = std::max(errors.largest, std::sqrt(squared));
      if constexpr (requires { Method::depth(placed); }) {
        depths += square(distance_of_depth(exact::error_of(Method::depth(placed), right.depth),
                                           double(right.distance), planes));
      }
    }
  }
  errors.rms = std::sqrt(sum / (scenes * kPointsPerScene));
  errors.depth = std::sqrt(depths / (scenes * kPointsPerScene));
  return errors;
}

// ---- the theory, all as root mean squares ----

// Converts an error of each eye coordinate, in world units, to pixels: both x and y have this error
// (a factor of sqrt 2), and the projection multiplies it by focal length / distance.
double in_pixels(double in_eye) {
  return std::sqrt(2.0) * kVertexSceneFocal / kVertexSceneDistance * in_eye;
}

// The rounding error of the viewport's last addition, for x and y together. It gives numbers near
// the middle of the picture, 512 .. 1023 px, where floats have steps of 1024 u (u: the unit
// roundoff).
template <class T>
double pixel_rounding() {
  return std::sqrt(2.0) * rms_of_step(1024 * double(unit_roundoff<T>));
}

// The error from numbers of size D (`offset`), whose mean square is D^2/3 along each axis. The
// variance of an eye coordinate is that of 20/3 such rounding errors: one each for the model's
// translation, its addition, the view's entries, its products and its translation, and 2/3 + 1 for
// its two sums.
double far_rounding_error(double offset) {
  return rms_rounding<float> * offset * std::sqrt(20.0 / 9);
}

// The error that remains if the origin is at the eye. Now the rounded numbers have the size of the
// distance, 4, in place of D, and the view has no translation: 17/3 rounding errors. The rounded
// coordinates of the object (mean square 1/5 each in the unit ball) add 11/3 more: one for the
// entries, one for the products and 5/3 for the sums.
double near_rounding_error() {
  return rms_rounding<float> *
         std::sqrt(square(kVertexSceneDistance) / 3 * (17.0 / 3) + 0.2 * (11.0 / 3));
}

// The error with a single matrix. For the object's coordinates, a row rounds its entries, products
// and sums; besides, the translation and the result are rounded, which are of size 4 along the gaze
// and 0.7 across it. An error along the gaze moves a point on the screen by 0.18 (x/w) of an equal
// error across it.
double composed_matrix_error(double roundoff_rms) {
  const double object = 0.2 * (11.0 / 3), across = 2 * 0.43,
               along = 2 * square(kVertexSceneDistance);
  return roundoff_rms * std::sqrt(object + across + square(0.18) * (object + along));
}

// The error of composing the matrix in double from R e and R T (R: the view's rotation, e: the eye,
// T: the object's translation). Each has 8/3 rounding errors from its products and sums, and their
// sum has one more: 19/3 in all, of size D (mean square D^2/3).
double composition_error(double offset) {
  return rms_rounding<double> * offset * std::sqrt(19.0 / 9);
}

// The error of fixed point with steps of 2^-32. Each world coordinate has 3.6 rounding errors (the
// model's entries times the object, the sum, two positions); then come the view's entries times the
// distance, and its sum.
double fixed_point_error() {
  return rms_of_step(0x1p-32) * std::sqrt(3.6 + square(kVertexSceneDistance) + 1 + 1);
}

using Theory = double (*)(double offset);  // predicts the root mean square of the error

double predict_float(double offset) {
  const double in_eye =
      std::sqrt(square(far_rounding_error(offset)) + square(near_rounding_error()));
  return std::min(diagonal(),
                  std::sqrt(square(in_pixels(in_eye)) + square(pixel_rounding<float>())));
}
double predict_relative(double) {
  return std::sqrt(square(in_pixels(near_rounding_error())) + square(pixel_rounding<float>()));
}
double predict_composed(double offset) {
  const double in_eye = std::sqrt(square(composed_matrix_error(rms_rounding<float>)) +
                                  square(composition_error(offset)));
  return std::sqrt(square(in_pixels(in_eye)) + square(pixel_rounding<float>()));
}
double predict_double(double offset) {
  const double in_eye = std::sqrt(square(composed_matrix_error(rms_rounding<double>)) +
                                  square(composition_error(offset)));
  return std::sqrt(square(in_pixels(in_eye)) + square(pixel_rounding<double>()));
}
double predict_fixed(double) {
  return in_pixels(fixed_point_error());
}

// Predicts the largest error. The largest of n distances with two normally distributed axes is
// about rms sqrt(ln n). Far from the origin, all points of a scene have the same error, so n is the
// number of scenes; near it, their errors are independent, so n is the number of points. The mean
// of both logarithms is used.
double expected_largest(double rms, int scenes) {
  const double few = std::log(scenes), many = std::log(scenes * kPointsPerScene);
  return std::min(diagonal(), rms * std::sqrt((few + many) / 2));
}

// ---- the theory of depth errors, converted to distances along the gaze ----

// The rounding error of the quotient z/w, which is just below 1, so its steps are 2^-24 (double:
// 2^-53).
template <class T>
double quotient_error(double near) {
  return square(kVertexSceneDistance) / near * rms_of_step(double(unit_roundoff<T>));
}
// The rounding errors of a projection matrix that is applied after the view matrix: of two entries,
// a product and a sum, each relative to a depth of about 1.
double projection_error(double near) {
  return square(kVertexSceneDistance) / near * std::sqrt(4.0) * rms_rounding<float>;
}
double root_sum_square(double a, double b, double c) {
  return std::sqrt(square(a) + square(b) + square(c));
}
// z and w come from the same eye coordinate. So an error of this coordinate has the effect of a
// slightly different distance, and is added only once.
double predict_depth_float(double near) {
  const double eye = root_sum_square(far_rounding_error(1), near_rounding_error(), 0);
  return root_sum_square(eye, projection_error(near), quotient_error<float>(near));
}
double predict_depth_relative(double near) {
  return root_sum_square(near_rounding_error(), projection_error(near),
                         quotient_error<float>(near));
}
// With a single matrix, z and w have independent errors, each from its own row, so z/w has sqrt(2)
// times the error of one row. As a distance along the gaze, this is z/n times as much (n: near
// plane).
template <class T>
double predict_depth_composed(double near) {
  const double row =
      rms_rounding<T> * std::sqrt(0.2 * (11.0 / 3) + 2 * square(kVertexSceneDistance));
  return root_sum_square(std::sqrt(2.0) * row * kVertexSceneDistance / near,
                         quotient_error<T>(near), 0);
}

// The explanation for near planes n so close that the depth, 1 - n/z, is within 8 units of the last
// place of 1.
std::optional<Finding> few_depths(double near) {
  if (near / kVertexSceneDistance > 8 * 0x1p-24) return std::nullopt;
  return Finding{
      "depth is so close to 1 (n/z = 4 u) that only four floats are left; the matrix entry is 1, "
      "so its product is exact, and the quotient is one of the four",
      0.25, 0.5};
}

// ---- the table ----

constexpr double kFar = 100;  // far plane of the scenes in which the near plane is moved
// 512 points in double, 12 KiB, fit into the first-level cache
constexpr int kTimedPoints = 1 << 9, kRounds = 1 << 8;

template <class Method>
std::function<void(int)> vertices_of(double offset, const DepthPlanes& planes) {
  const VertexScene scene = make_vertex_scene(1, offset, kTimedPoints, planes);
  std::vector<typename Method::Input> vertices;
  for (const Point<Object, double>& p : scene.points) vertices.push_back(Method::input(p));
  return repeated_work(kRounds, vertices, Method(scene));
}

struct Series {
  const char* name;
  Theory position;
  double (*depth)(double near);  // null: the method has no depth
};

template <class Method>
void add_series(std::vector<Configuration>& all, const Series& series, Effort effort) {
  const int scenes = effort == Effort::kFull ? 160 : 16;
  constexpr double kItems = double(kTimedPoints) * kRounds;
  for (const double offset : {1.0, 1e2, 1e4, 1e6, 1e8}) {
    const auto errors = memoize([=] { return errors_of<Method>(offset, {}, scenes); });
    all.push_back({.series = series.name,
                   .parameter = offset,
                   .error = [=] { return errors().rms; },
                   .predicted_error = series.position(offset),
                   .work = vertices_of<Method>(offset, {}),
                   .items = kItems});
    all.push_back({.series = series.name,
                   .parameter = offset,
                   .measure = kLargest,
                   .error = [=] { return errors().largest; },
                   .predicted_error = expected_largest(series.position(offset), scenes)});
  }
  for (const double ratio : {1e2, 1e4, 1e6, 1e8}) {
    const DepthPlanes planes{kFar / ratio, kFar};
    const auto errors = memoize([=] { return errors_of<Method>(1, planes, scenes); });
    all.push_back({.series = series.name,
                   .parameter = ratio,
                   .measure = kPlanes,
                   .error = [=] { return errors().rms; },
                   .predicted_error = series.position(1),
                   .work = vertices_of<Method>(1, planes),
                   .items = kItems});
    if (series.depth == nullptr) continue;
    all.push_back({.series = series.name,
                   .parameter = ratio,
                   .measure = kDepth,
                   .error = [=] { return errors().depth; },
                   .predicted_error = series.depth(planes.near),
                   .finding = few_depths(planes.near)});
  }
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  add_series<FloatStages>(all, {"float", predict_float, predict_depth_float}, effort);
  add_series<CameraRelative>(
      all, {"float, coordinates relative to the camera", predict_relative, predict_depth_relative},
      effort);
  add_series<ComposedOnce>(all,
                           {"matrices composed in double, vertices in float", predict_composed,
                            predict_depth_composed<float>},
                           effort);
  add_series<DoubleStages>(all, {"double", predict_double, predict_depth_composed<double>}, effort);
  add_series<Fixed32>(all, {"32.32 fixed point", predict_fixed, nullptr}, effort);
  return all;
}

}  // namespace d01

Experiment d01_vertex_stage() {
  using namespace d01;
  return {
      .id = "D-1",
      .name = "Vertices: which number format transforms them to the screen",
      .question =
          "How far from the origin may a scene be before its vertices visibly jump, and what do "
          "the remedies cost?",
      .axis = "distance of camera and object from the origin",
      .axis_unit = "units; the object has a radius of 1",
      .error = "root mean square distance from the right place on the screen",
      .error_unit = "px",
      .reference = "50 digits, for the same rotations and positions",
      .theory =
          "Each rounding error counts as random with the standard deviation 0.42 u (u = 2^-24 or "
          "2^-53). Float has an error of 0.63 u D sqrt(2) F/z px for the distance D from the "
          "origin, the focal length F in px and the distance z from the camera, and at most the "
          "picture's diagonal. Matrices composed in double have 0.62 u D in the same formula. "
          "Coordinates relative to the camera, and fixed point after the eye is subtracted, have "
          "an error that does not depend on D. The last rounding of a float in px adds 2.5e-5. The "
          "largest of n errors is sqrt(ln n) times as large. The near and the far plane are in "
          "none of the rows that give x, y and w. Depth is within n/z of 1, where n is the near "
          "plane: a rounding error of depth there is z^2/n times as large along the gaze, and "
          "rounding errors of z and w, if they come from one matrix, z/n times each",
      .item = "vertex",
      .measures = {{kLargest, "largest distance from the right place on the screen", "px"},
                   {kPlanes,
                    "root mean square distance from the right place on the screen, at "
                    "1 unit from the origin",
                    "px", "far plane, at 100 units, over near plane"},
                   {kDepth,
                    "root mean square error of the depth as a distance along the gaze, "
                    "at 1 unit from the origin and 4 from the camera",
                    "units", "far plane, at 100 units, over near plane"}},
      .configurations = configurations};
}

}  // namespace glassbox::study
