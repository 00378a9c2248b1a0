#include <array>
#include <cstdint>

#include <Eigen/Geometry>

#include <glassbox/base/random.h>
#include <glassbox/base/rounding.h>

#include "study/extremes/common/extreme_case.h"
#include "study/naive/klt.h"

namespace glassbox::study {
namespace c115 {

struct Subject115 {
  Eigen::MatrixXd (*covariance)(const views::Bands& bands);
  double (*angle)(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
};

Eigen::MatrixXd two_passes(const views::Bands& bands) {
  return views::moments_of(bands).covariance;
}

constexpr int kSide = 48;

views::Bands empty_bands(int count) {
  views::Bands bands{kSide, kSide, {}};
  for (int b = 0; b < count; ++b)
    bands.bands.push_back({fmt::format("band {}", b + 1), std::vector<double>(bands.pixels())});
  return bands;
}

// The samples are 10^6 + k/16 with small integers k, so that the covariance of two bands with the
// integers k and l is a quotient of integers: (N sum k l - sum k sum l)/(16 N)^2, where N is the
// number of pixels.
void measure_mean_error(const Subject115& subject, WorstError& worst) {
  Random random(115);
  views::Bands bands = empty_bands(3);
  const auto pixels = std::int64_t(bands.pixels());
  std::array<std::vector<std::int64_t>, 3> wholes;
  for (std::int64_t i = 0; i < pixels; ++i) {
    const std::int64_t shared = random.integer(-16, 16);
    for (std::size_t b = 0; b < 3; ++b) {
      wholes[b].push_back(shared * std::int64_t(b) + random.integer(-8, 8));
      bands.bands[b].samples[std::size_t(i)] = 1e6 + double(wholes[b].back()) / 16;
    }
  }
  Eigen::MatrixXd right(3, 3);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      std::int64_t sum_a = 0, sum_b = 0, sum_ab = 0;
      for (std::size_t i = 0; i < std::size_t(pixels); ++i) {
        sum_a += wholes[a][i];
        sum_b += wholes[b][i];
        sum_ab += wholes[a][i] * wholes[b][i];
      }
      right(Eigen::Index(a), Eigen::Index(b)) =
          double(pixels * sum_ab - sum_a * sum_b) / double(256 * pixels * pixels);
    }
  }
  // The bound has the unit roundoff u. The mean has a relative error of u, which changes the sums
  // of squares by the square of that error. The differences from the mean are computed from numbers
  // near 10^6, so they have errors of u 10^6 for a deviation of about 1. The sums have 2 kSide
  // rounding errors.
  const double u = unit_roundoff<double>, trace = right.trace();
  const double bound = 2 * kSide * u + 4 * u * 1e6 / std::sqrt(trace);
  const double error = (subject.covariance(bands) - right).cwiseAbs().maxCoeff() / trace;
  worst.add(error, bound, fmt::format("covariance off by {:.3g} of the trace", error),
            1e12 / trace);
}

// The variance is the same in two directions of space and smaller in the third; then all samples
// are rotated. The plane of the first two components rotates with them, while the two vectors
// themselves depend on rounding errors in the last digit.
void measure_space_error(const Subject115& subject, WorstError& worst) {
  Random random(116);
  for (int turn = 0; turn < 20; ++turn) {
    views::Bands bands = empty_bands(3), turned = bands;
    const Eigen::Vector3d axis{random.between(-1, 1), random.between(-1, 1),
                               random.between(0.5, 1)};
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(random.between(0.2, 1.3), axis.normalized()).matrix();
    for (std::size_t i = 0; i < bands.pixels(); ++i) {
      const double side = i % 2 == 0 ? 1 : -1;
      const Eigen::Vector3d at(i % 4 < 2 ? side : 0, i % 4 < 2 ? 0 : side,
                               i % 8 < 4 ? 0.25 : -0.25);
      const Eigen::Vector3d there = rotation * at;
      for (int b = 0; b < 3; ++b) {
        bands.bands[std::size_t(b)].samples[i] = at[b];
        turned.bands[std::size_t(b)].samples[i] = there[b];
      }
    }
    const auto klt = views::klt_of(bands), other = views::klt_of(turned);
    const double angle =
        subject.angle(rotation * klt->vectors.leftCols(2), other->vectors.leftCols(2));
    // The bound of the angle is |C' - C|/gap for the computed covariance C' and the exact one C
    // (theorem of Davis and Kahan). The covariance has 2 kSide + 9 rounding errors of the size of
    // the trace, and the solver as many again (transform.h).
    const double gap = klt->eigenvalues[1] - klt->eigenvalues[2];
    const double bound = 2 * (2 * kSide + 9) * unit_roundoff<double> * klt->trace() / gap;
    worst.add(angle, bound, fmt::format("turn {}: {:.3g} radians", turn, angle));
  }
}

Outcome measure_error(auto covariance_by, auto angle_by) {
  const Subject115 subject{covariance_by, angle_by};
  WorstError worst;
  measure_mean_error(subject, worst);
  measure_space_error(subject, worst);
  return worst.outcome();
}

}  // namespace c115

ExtremeCase c115_klt() {
  using namespace c115;
  return {
      .id = "C-115",
      .name = "A large mean, equal eigenvalues",
      .construction =
          "three bands of 48 x 48 samples 10^6 + k/16; pixels that vary equally along two "
          "directions, and the same pixels rotated, 20 times",
      .stage = "components of bands",
      .right_answer =
          "the covariance has at most 2 W rounding errors, and 4 u 10^6 of a deviation for the "
          "differences from the mean; the space of two components has at most the error of the "
          "covariance divided by the gap between the eigenvalues",
      .unit = "of the trace, radian",
      .oracle = Oracle::kInteger,
      .ours = {"two passes; spaces of components are compared by their angles",
               [] { return measure_error(two_passes, views::angle_between); }},
      .naive = {"E[xy] - E[x] E[y]; single components are compared by their angles",
                [] {
                  return measure_error(naive::covariance_by_moments<double>,
                                       naive::angle_of_vectors);
                }},
      .mutants =
          {{"E[xy] - E[x] E[y] in float",
            [] {
              return measure_error(naive::covariance_by_moments<float>, views::angle_between);
            }},
           {"E[xy] - E[x] E[y] in double",
            [] {
              return measure_error(naive::covariance_by_moments<double>, views::angle_between);
            }},
           {"divided by N - 1",
            [] { return measure_error(naive::covariance_of_a_sample, views::angle_between); }},
           {"the mean is not subtracted",
            [] { return measure_error(naive::covariance_about_zero, views::angle_between); }},
           {"single components are compared, not the spaces that they span",
            [] { return measure_error(two_passes, naive::largest_angle_of_vectors); }},
           {"angles are computed as arccosines",
            [] { return measure_error(two_passes, naive::angle_by_cosine); }}},
      .not_drawn = "the case computes components from given bands; no engine draws them",
  };
}

}  // namespace glassbox::study
