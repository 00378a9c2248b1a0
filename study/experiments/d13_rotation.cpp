// Compares methods to turn a rotation a little further, a million times (D-13).
#include <algorithm>
#include <array>
#include <cmath>

#include "study/experiment/experiment.h"
#include "study/experiments/d13_defect.h"
#include "study/experiments/d13_methods.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace d13 {

// ---- the error ----

// The largest defect (distance from a rotation) over the whole run, measured about a thousand
// times, just before renormalisations.
template <class Method>
double largest_defect(int every, int steps) {
  Method method(every);
  double largest = 0;
  const int looks = std::max(steps / 1000, 1);
  for (int i = 1, due = looks; i <= steps; ++i) {
    method.advance();
    if (i < due && i != steps) continue;
    if (!method.is_worst() && i != steps) continue;
    largest = std::max(largest, frobenius(defect(method.matrix())));
    due = i + looks;
  }
  return largest;
}

// ---- the theory ----

// The drift, the systematic error of each step. A step S is rounded, with S S^T = I + E, and turns
// the matrix R to R' = R S. So R' R'^T = R (I + E) R^T, and each step adds R E R^T. R turns about
// the axis a of the step, so over a full turn only the part of E that this rotation does not change
// remains: p = a^T E a along the axis, and (trace E - p)/2 across it.
template <class T>
double drift_of_step() {
  const RotationMatrix<double> e = defect(step_matrix<T>());
  const glm::dvec3 a = axis_angle_of(step_rotation()).axis;
  double along = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) along += a[i] * e[std::size_t(i)][std::size_t(j)] * a[j];
  }
  const double across = (e[0][0] + e[1][1] + e[2][2] - along) / 2;
  return std::sqrt(square(along) + 2 * square(across));
}

// The mean square of the random errors of all steps. Each step rounds the products and sums of an
// entry, which adds the squares of 8/3 rounding errors. If all entries of a rotation R are rounded
// once, by an rms of 0.42 units roundoff, the error of R R^T - I is 3.1 times that (the mean fourth
// power of an entry is 1/5).
template <class T>
double walk_squared(int steps) {
  return square(3.1 * rms_rounding<T>) * 8 / 3 * steps;
}
// The mean square error that Gram and Schmidt's method leaves in R R^T - I. The lengths of both
// normalised rows have an error of 1.5 rounding errors (divisions, root, sum of squares), which is
// 2.9 in the diagonal; the third row, a cross product, has the errors of both rows and its own.
// With the six entries beside the diagonal, the squares add up to 48.
template <class T>
double renormalised_squared() {
  return 48 * square(rms_rounding<T>);
}
// The largest of about a thousand measured errors, divided by their rms. The square of an error is
// distributed like a sum of three squares: the 0.999 quantile of this distribution is 16.3, its
// mean is 3.
const double kLargestOfMany = std::sqrt(16.3 / 3);

template <class T>
double predict_product(int every, int steps) {
  if (every == 0) return steps * drift_of_step<T>() + std::sqrt(walk_squared<T>(steps));
  const int carried = every - 1;
  return carried * drift_of_step<T>() +
         kLargestOfMany * std::sqrt(renormalised_squared<T>() + walk_squared<T>(carried));
}

// The length of a normalised quaternion q has an error of 1.41 rounding errors (0.5 + 1 + 0.5 in
// squares: divisions, root, half of the sum). For a length near 1 its matrix, I + |q|^2 (R - I)
// with the rotation R, has twice that error times R - I. Then R R^T - I has 2 (2 I - R - R^T) times
// that error: 8 sqrt 2 after half a turn. The largest error in the few hundred samples near there
// is 2.5 times the rms.
double predict_quaternion(int, int) {
  return 8 * std::sqrt(2.0) * 1.41 * 2.5 * rms_rounding<float>;
}

// ---- the table ----

struct Series {
  const char* name;
  double (*error)(int every, int steps);
  double (*theory)(int every, int steps);
  int every;
  void (*work)(int every);
};

constexpr int kTimedSteps = 100'000;

template <class Method>
void advance_all(int every) {
  Method method(every);
  for (int i = 0; i < kTimedSteps; ++i) method.advance();
  do_not_optimize(method.matrix());
}

constexpr auto kFloat = largest_defect<RotationProduct<float>>;
constexpr auto kFloatTheory = predict_product<float>;
constexpr auto kFloatWork = advance_all<RotationProduct<float>>;

const Series kSeries[] = {
    {"float, never renormalised", kFloat, kFloatTheory, 0, kFloatWork},
    {"float, renormalised every 1000 steps", kFloat, kFloatTheory, 1000, kFloatWork},
    {"float, renormalised every 100 steps", kFloat, kFloatTheory, 100, kFloatWork},
    {"float, renormalised every 10 steps", kFloat, kFloatTheory, 10, kFloatWork},
    {"float, renormalised every step", kFloat, kFloatTheory, 1, kFloatWork},
    {"float quaternion", largest_defect<RotationQuaternion>, predict_quaternion, 1,
     advance_all<RotationQuaternion>},
    {"double, never renormalised", largest_defect<RotationProduct<double>>, predict_product<double>,
     0, advance_all<RotationProduct<double>>},
};

std::vector<Configuration> configurations(Effort effort) {
  std::vector<int> steps{1000, 10'000, 100'000};
  if (effort == Effort::kFull) steps.push_back(1'000'000);
  std::vector<Configuration> all;
  for (const Series& series : kSeries) {
    for (const int count : steps) {
      all.push_back({.series = series.name,
                     .parameter = double(count),
                     .error = [=] { return series.error(series.every, count); },
                     .predicted_error = series.theory(series.every, count),
                     .work = [series](int) { series.work(series.every); },
                     .items = kTimedSteps});
    }
  }
  return all;
}

}  // namespace d13

Experiment d13_rotation() {
  using namespace d13;
  return {.id = "D-13",
          .name = "Rotations after many multiplications",
          .question =
              "How soon does a matrix that is multiplied again and again stop being a rotation, "
              "and what prevents this?",
          .axis = "steps of 0.01 radian",
          .error =
              "largest |R R^T - I| (Frobenius); half of it is the relative error of lengths in the "
              "picture",
          .reference = "double with error-free products and sums",
          .theory =
              "The rounded step S is not quite a rotation: E = S S^T - I is not 0, and the part of "
              "E that is symmetric about the axis is added at each step, so the error grows "
              "linearly. Rounding errors add a random walk of 0.42 u * 3.1 sqrt(8/3 n) in n steps, "
              "where u is the unit roundoff. Each renormalisation sets both errors back",
          .item = "step",
          .configurations = configurations};
}

}  // namespace glassbox::study
