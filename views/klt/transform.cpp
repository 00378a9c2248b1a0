#include "views/klt/transform.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>

namespace glassbox::views {

namespace {

// The sum of `at(i)` over all pixels i, summed row by row.
template <class At>
double sum_by_rows(const Bands& bands, At at) {
  double sum = 0;
  const auto width = std::size_t(bands.width);
  for (std::size_t first = 0; first < bands.pixels(); first += width) {
    double row = 0;
    for (std::size_t i = first; i < first + width; ++i) row += at(i);
    sum += row;
  }
  return sum;
}

const std::vector<double>& samples_of(const Bands& bands, int band) {
  return bands.bands[std::size_t(band)].samples;
}

Result<void> check_bands(const Bands& bands) {
  if (bands.count() < 1)
    return fail("the bands", "there are none", "give pictures, one for each band");
  if (bands.pixels() < 2)
    return fail("the bands", "a single pixel has no variance",
                "give pictures of at least two pixels");
  // The sum of the squares of all samples must not overflow.
  const double most = std::sqrt(std::numeric_limits<double>::max() /
                                (4.0 * double(bands.pixels()) * bands.count()));
  for (const Band& band : bands.bands) {
    if (band.samples.size() != bands.pixels()) {
      return fail(band.name,
                  fmt::format("has {} samples, but the pictures have {} x {} pixels",
                              band.samples.size(), bands.width, bands.height),
                  "give bands of one size");
    }
    for (std::size_t i = 0; i < band.samples.size(); ++i) {
      if (std::abs(band.samples[i]) <= most) continue;
      return fail(band.name,
                  fmt::format("the sample in column {}, row {} is {}, but samples must be finite "
                              "and at most {:.3g}",
                              i % std::size_t(bands.width), i / std::size_t(bands.width),
                              band.samples[i], most),
                  "correct the sample, or scale the band to smaller numbers");
    }
  }
  return {};
}

void make_positive(Eigen::Ref<Eigen::VectorXd> vector) {
  Eigen::Index at = 0;
  vector.cwiseAbs().maxCoeff(&at);
  if (vector[at] < 0) vector = -vector;
}

}  // namespace

double Klt::truncation_error(int kept) const {
  double sum = 0;
  for (Eigen::Index i = eigenvalues.size(); i-- > kept;) sum += eigenvalues[i];
  return sum;
}

Moments moments_of(const Bands& bands) {
  const int count = bands.count();
  const double pixels = double(bands.pixels());
  Moments moments{Eigen::VectorXd(count), Eigen::MatrixXd(count, count)};
  for (int b = 0; b < count; ++b) {
    const auto& samples = samples_of(bands, b);
    // The first sum is one of large numbers and has large rounding errors. The second sum corrects
    // it: it is one of small differences, so it has small rounding errors.
    const double about = sum_by_rows(bands, [&](std::size_t i) { return samples[i]; }) / pixels;
    const double rest = sum_by_rows(bands, [&](std::size_t i) { return samples[i] - about; });
    moments.mean[b] = about + rest / pixels;
  }
  for (int a = 0; a < count; ++a) {
    const auto& first = samples_of(bands, a);
    for (int b = a; b < count; ++b) {
      const auto& second = samples_of(bands, b);
      const double sum = sum_by_rows(bands, [&](std::size_t i) {
        return (first[i] - moments.mean[a]) * (second[i] - moments.mean[b]);
      });
      moments.covariance(a, b) = moments.covariance(b, a) = sum / pixels;
    }
  }
  return moments;
}

Result<Klt> klt_of(const Bands& bands) {
  if (const auto legal = check_bands(bands); !legal) return tl::unexpected(legal.error());
  Moments moments = moments_of(bands);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(moments.covariance);
  if (solver.info() != Eigen::Success)
    return fail("the bands", "the eigenvalues of their covariance cannot be computed",
                "scale the bands to numbers of similar size");
  Klt klt{std::move(moments.mean), std::move(moments.covariance),
          solver.eigenvalues().reverse().cwiseMax(0), solver.eigenvectors().rowwise().reverse()};
  for (Eigen::Index i = 0; i < klt.vectors.cols(); ++i) make_positive(klt.vectors.col(i));
  return klt;
}

Bands components_of(const Bands& bands, const Klt& klt, int end, int first) {
  Bands components{bands.width, bands.height, {}};
  for (int k = first; k < end; ++k) {
    Band component{fmt::format("component {}", k + 1), std::vector<double>(bands.pixels(), 0.0)};
    for (int b = 0; b < bands.count(); ++b) {
      const auto& samples = samples_of(bands, b);
      const double weight = klt.vectors(b, k), mean = klt.mean[b];
      for (std::size_t i = 0; i < samples.size(); ++i)
        component.samples[i] += weight * (samples[i] - mean);
    }
    components.bands.push_back(std::move(component));
  }
  return components;
}

Bands reconstructed(const Bands& components, const Klt& klt, const Bands& named) {
  Bands bands{components.width, components.height, {}};
  for (int b = 0; b < named.count(); ++b) {
    Band band{named.bands[std::size_t(b)].name, std::vector<double>(components.pixels(), 0.0)};
    for (int k = 0; k < components.count(); ++k) {
      const auto& samples = samples_of(components, k);
      const double weight = klt.vectors(b, k);
      for (std::size_t i = 0; i < samples.size(); ++i) band.samples[i] += weight * samples[i];
    }
    for (double& sample : band.samples) sample += klt.mean[b];
    bands.bands.push_back(std::move(band));
  }
  return bands;
}

double mean_squared_error(const Bands& a, const Bands& b) {
  double sum = 0;
  for (int band = 0; band < a.count(); ++band) {
    const auto &first = samples_of(a, band), &second = samples_of(b, band);
    sum += sum_by_rows(a, [&](std::size_t i) {
      const double off = first[i] - second[i];
      return off * off;
    });
  }
  return sum / double(a.pixels());
}

double eigenvalue_bound(const Bands& bands, const Klt& klt) {
  const double roundings = bands.width + bands.height + 3 * bands.count();
  return roundings * unit_roundoff<double> * klt.trace();
}

double identity_bound(const Bands& bands, const Klt& klt, int kept) {
  double largest = 0;
  for (const Band& band : bands.bands) {
    for (const double sample : band.samples) largest = std::max(largest, std::abs(sample));
  }
  const double root = std::sqrt(double(bands.count()));
  const double added = unit_roundoff<double> * root * (1 + 2 * root) * largest;
  return 1e-10 * klt.truncation_error(kept) + bands.count() * eigenvalue_bound(bands, klt) +
         2 * std::sqrt(klt.truncation_error(kept)) * added + added * added;
}

std::vector<int> eigenvalue_groups(const Eigen::VectorXd& eigenvalues, double resolution) {
  std::vector<int> groups;
  for (Eigen::Index i = 0; i < eigenvalues.size(); ++i) {
    const bool joins = i > 0 && eigenvalues[i - 1] - eigenvalues[i] <= resolution;
    groups.push_back(joins ? groups.back() : int(i));
  }
  return groups;
}

double angle_between(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::MatrixXd beside = b - a * (a.transpose() * b);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(beside);
  const double sine = std::min(1.0, svd.singularValues()[0]);
  return arctan2(sine, std::sqrt((1 - sine) * (1 + sine)));
}

double largest_correlation(const Bands& components) {
  const Eigen::MatrixXd covariance = moments_of(components).covariance;
  const double trace = covariance.trace();
  if (!(trace > 0)) return 0;
  Eigen::MatrixXd beside = covariance;
  beside.diagonal().setZero();
  return beside.cwiseAbs().maxCoeff() / trace;
}

}  // namespace glassbox::views
