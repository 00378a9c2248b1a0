// D-1: in which numbers a vertex is carried to the screen.
#include <algorithm>
#include <cmath>
#include <limits>

#include "study/experiment/experiment.h"
#include "study/experiments/consume.h"
#include "study/experiments/d01_ways.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace {

// ---- the error ----

constexpr int kPointsOfShot = 64;

// The distance beyond which a vertex is simply wrong: the picture's diagonal.
double diagonal() {
  return std::sqrt(square(kShotWidth) + square(kShotHeight));
}

template <class Way>
double rms_error(double offset, int shots) {
  double sum = 0;
  for (int i = 0; i < shots; ++i) {
    const Shot shot = make_shot(std::uint64_t(i) + 1, offset, kPointsOfShot);
    const Way way(shot);
    const ExactShot exact(shot);
    for (const Point<Object, double>& p : shot.points) {
      const Pixels seen = Way::pixels(way(Way::input(p)));
      const auto right = exact.screen(p);
      const double squared =
          square(exact::error_of(seen[0], right[0])) + square(exact::error_of(seen[1], right[1]));
      sum += std::min(squared, square(diagonal()));
    }
  }
  return std::sqrt(sum / (shots * kPointsOfShot));
}

// ---- the theory, all as root mean squares ----

// An error of each eye coordinate, in units of the world, seen on the screen: two axes, focal length over distance.
double in_pixels(double in_eye) {
  return std::sqrt(2.0) * kShotFocal / kShotDistance * in_eye;
}

// The last addition of the viewport gives numbers about the picture's middle, 512 .. 1023 px.
template <class T>
double pixel_rounding() {
  return std::sqrt(2.0) * rms_of_step(1024 * double(unit_roundoff<T>));
}

// Numbers of size D in the float stages, whose squares are D^2/3 along each axis, are rounded 20/3 times on their way to
// an eye coordinate: the model's translation, its addition, the view's entries, its products and its translation once
// each, its two sums together 2/3 + 1.
double of_far_roundings(double offset) {
  return rms_rounding<float> * offset * std::sqrt(20.0 / 9);
}

// What is left when the origin is in the eye: distance 4 in place of D, where the view has no translation, and the
// object's own coordinates (a square of 1/5 each in the unit ball): entries, products and 5/3 sums.
double of_near_roundings() {
  return rms_rounding<float> * std::sqrt(square(kShotDistance) / 3 * (17.0 / 3) + 0.2 * (11.0 / 3));
}

// One matrix: a row's entries, products and sums over the object, and the rounding of the translation and of the result,
// which are of size 4 along the gaze and 0.7 across it; errors along the gaze count as x/w = 0.18.
double of_composed(double roundoff_rms) {
  const double object = 0.2 * (11.0 / 3), across = 2 * 0.43, along = 2 * square(kShotDistance);
  return roundoff_rms * std::sqrt(object + across + square(0.18) * (object + along));
}

// Composing in double: R e and R T with their products and sums (8/3 roundings each) and the result's, of size D.
double of_composition(double offset) {
  return rms_rounding<double> * offset * std::sqrt(19.0 / 9);
}

// 2^-32 steps: 3.6 roundings of each world coordinate (the model's entries over the object, the sum, two positions), then
// the view's entries over the distance, and its sum.
double of_fixed() {
  return rms_of_step(0x1p-32) * std::sqrt(3.6 + square(kShotDistance) + 1 + 1);
}

using Theory = double (*)(double offset);

double predict_float(double offset) {
  const double in_eye = std::sqrt(square(of_far_roundings(offset)) + square(of_near_roundings()));
  return std::min(diagonal(),
                  std::sqrt(square(in_pixels(in_eye)) + square(pixel_rounding<float>())));
}
double predict_relative(double) {
  return std::sqrt(square(in_pixels(of_near_roundings())) + square(pixel_rounding<float>()));
}
double predict_composed(double offset) {
  const double in_eye =
      std::sqrt(square(of_composed(rms_rounding<float>)) + square(of_composition(offset)));
  return std::sqrt(square(in_pixels(in_eye)) + square(pixel_rounding<float>()));
}
double predict_double(double offset) {
  const double in_eye =
      std::sqrt(square(of_composed(rms_rounding<double>)) + square(of_composition(offset)));
  return std::sqrt(square(in_pixels(in_eye)) + square(pixel_rounding<double>()));
}
double predict_fixed(double) {
  return in_pixels(of_fixed());
}

// ---- the table ----

constexpr int kTimedPoints = 1 << 13, kRounds = 16;

template <class Way>
void add_series(std::vector<Configuration>& all, const std::string& series, Theory theory,
                Effort effort) {
  const int shots = effort == Effort::kFull ? 160 : 16;
  for (const double offset : {1.0, 1e2, 1e4, 1e6, 1e8}) {
    const Shot shot = make_shot(1, offset, kTimedPoints);
    std::vector<typename Way::Input> vertices;
    for (const Point<Object, double>& p : shot.points) vertices.push_back(Way::input(p));
    all.push_back({.series = series,
                   .parameter = offset,
                   .error = [=] { return rms_error<Way>(offset, shots); },
                   .predicted_error = theory(offset),
                   .work = rounds_of(kRounds, vertices, Way(shot)),
                   .items = double(kTimedPoints) * kRounds});
  }
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  add_series<FloatStages>(all, "float", predict_float, effort);
  add_series<CameraRelative>(all, "float, relative to the camera", predict_relative, effort);
  add_series<ComposedOnce>(all, "composed in double, then float", predict_composed, effort);
  add_series<DoubleStages>(all, "double", predict_double, effort);
  add_series<Fixed32>(all, "32.32 fixed point", predict_fixed, effort);
  return all;
}

}  // namespace

Experiment d01_vertex_stage() {
  return {.id = "D-1",
          .name = "Vertices: in which numbers they are carried to the screen",
          .question =
              "How far from the origin may a scene be before its vertices tremble, and what do the "
              "remedies cost?",
          .axis = "distance of camera and object from the origin",
          .axis_unit = "units; the object has a radius of 1",
          .error = "root mean square distance from the right place on the screen",
          .error_unit = "px",
          .reference = "50 digits, for the same rotations and positions",
          .theory =
              "roundings counted as random, 0.42 u each (u = 2^-24 or 2^-53): float 0.63 u D "
              "sqrt(2) F/z px for focal length F and distance z, at most the picture's diagonal; "
              "composed in double 0.62 u D the same way; relative to the camera, and fixed point "
              "after the eye is subtracted, flat; the last rounding of a float in px adds 2.5e-5",
          .item = "vertex",
          .configurations = configurations};
}

}  // namespace glassbox::study
