// Components of bands: what they preserve, what they lose, and what is determined at all.
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <glassbox/base/random.h>
#include <glassbox/base/rounding.h>

#include "views/klt/clouds.h"
#include "views/klt/globe.h"
#include "views/klt/transform.h"

namespace glassbox::views {
namespace {

Bands random_bands(Random& random, int count, int width, int height, double mean) {
  Bands bands{width, height, {}};
  for (int b = 0; b < count; ++b)
    bands.bands.push_back({"band", std::vector<double>(bands.pixels())});
  Eigen::MatrixXd mix(count, count);
  for (double& entry : mix.reshaped()) entry = random.between(-1, 1);
  for (std::size_t i = 0; i < bands.pixels(); ++i) {
    Eigen::VectorXd sources(count);
    for (int b = 0; b < count; ++b) sources[b] = random.between(-1, 1) * std::pow(0.3, b);
    const Eigen::VectorXd pixel = mix * sources;
    for (int b = 0; b < count; ++b) bands.bands[std::size_t(b)].samples[i] = mean + pixel[b];
  }
  return bands;
}

Eigen::MatrixXd as_matrix(const Bands& bands) {
  Eigen::MatrixXd matrix(Eigen::Index(bands.pixels()), bands.count());
  for (int b = 0; b < bands.count(); ++b) {
    for (std::size_t i = 0; i < bands.pixels(); ++i)
      matrix(Eigen::Index(i), b) = bands.bands[std::size_t(b)].samples[i];
  }
  return matrix;
}

}  // namespace

TEST_CASE(
    "the mean square error is the sum of the eigenvalues that were dropped, to 1e-10 (S1-14)") {
  Random random(14);
  for (int i = 0; i < 200; ++i) {
    const int count = int(random.integer(1, 8));
    const double mean = i % 2 == 0 ? 0 : 1000;
    const int width = int(random.integer(2, 40)), height = int(random.integer(1, 30));
    const Bands bands = random_bands(random, count, width, height, mean);
    const auto klt = klt_of(bands);
    REQUIRE(klt);
    for (int kept = 0; kept <= count; ++kept) {
      INFO("run " << i << ", " << count << " bands, " << kept << " kept");
      const Bands again = reconstructed(components_of(bands, *klt, kept), *klt, bands);
      const double error = mean_squared_error(bands, again);
      const double bound = identity_bound(bands, *klt, kept);
      CHECK(std::abs(error - klt->truncation_error(kept)) <= bound);
      // At most 8 (40 + 30 + 24) u = 8.4e-14 of the trace, added to the required 1e-10, and the
      // rounding caused by a large mean.
      if (mean == 0) CHECK(bound <= 1.001e-10 * klt->truncation_error(kept) + 1e-13 * klt->trace());
      // The check must be able to fail: one eigenvalue more or less gives a different number.
      if (kept > 0 && klt->eigenvalues[kept - 1] > 1e-6 * klt->trace())
        CHECK(std::abs(error - klt->truncation_error(kept - 1)) >
              identity_bound(bands, *klt, kept));
    }
  }
}

TEST_CASE(
    "the dropped eigenvalues are the error where the mean is large beside what varies, too "
    "(C-115)") {
  Random random(17);
  for (const auto& [mean, spread] : {std::pair{1e6, 1e-3}, {1e12, 1.0}, {-3e9, 1e-2}}) {
    Bands bands{8, 8, {{"a", {}}, {"b", {}}}};
    for (int i = 0; i < 64; ++i) {
      const double shared = random.between(-1, 1);
      bands.bands[0].samples.push_back(mean + spread * shared);
      bands.bands[1].samples.push_back(mean + spread * (0.3 * shared + random.between(-1, 1)));
    }
    const auto klt = klt_of(bands);
    REQUIRE(klt);
    for (int kept = 0; kept <= 2; ++kept) {
      INFO(mean << ", " << kept << " kept");
      const Bands again = reconstructed(components_of(bands, *klt, kept), *klt, bands);
      const double error = mean_squared_error(bands, again),
                   bound = identity_bound(bands, *klt, kept);
      CHECK(std::abs(error - klt->truncation_error(kept)) <= bound);
      CHECK(bound < klt->eigenvalues[1] / 10);  // otherwise one eigenvalue more or less would pass
    }
  }
}

TEST_CASE("components are uncorrelated, and their vectors orthonormal") {
  Random random(15);
  for (int i = 0; i < 50; ++i) {
    const Bands bands = random_bands(random, int(random.integer(1, 8)), 40, 30, 500);
    const auto klt = klt_of(bands);
    REQUIRE(klt);
    CHECK(largest_correlation(components_of(bands, *klt, bands.count())) <= 1e-12);
    const auto identity = Eigen::MatrixXd::Identity(bands.count(), bands.count());
    CHECK((klt->vectors.transpose() * klt->vectors - identity).norm() < 1e-14 * bands.count());
    for (int k = 1; k < bands.count(); ++k) CHECK(klt->eigenvalues[k - 1] >= klt->eigenvalues[k]);
    for (const auto vector : klt->vectors.colwise())
      CHECK(vector.maxCoeff() == vector.cwiseAbs().maxCoeff());
    // From the third component on they are the same.
    const Bands all = components_of(bands, *klt, bands.count());
    const Bands rest = components_of(bands, *klt, bands.count(), std::min(2, bands.count()));
    for (int k = 2; k < bands.count(); ++k) {
      CHECK(rest.bands[std::size_t(k - 2)].samples == all.bands[std::size_t(k)].samples);
      CHECK(rest.bands[std::size_t(k - 2)].name == all.bands[std::size_t(k)].name);
    }
  }
}

TEST_CASE("moments and correlation are those of numbers that are known") {
  // The means are 2 and 5. The differences are (-1, 1), (1, -1), (-1, -1), (1, 1), doubled in b; c
  // is the sum of a and b.
  const Bands bands{4, 1, {{"a", {1, 3, 1, 3}}, {"b", {7, 3, 3, 7}}, {"c", {8, 6, 4, 10}}}};
  const Moments moments = moments_of(bands);
  CHECK(moments.mean == Eigen::Vector3d(2, 5, 7));
  Eigen::Matrix3d expected;
  expected << 1, 0, 1, 0, 4, 4, 1, 4, 5;
  CHECK(moments.covariance == expected);
  CHECK(largest_correlation(bands) == 0.4);
}

TEST_CASE("components are the singular vectors of the bands without their mean") {
  Random random(16);
  for (int i = 0; i < 20; ++i) {
    const int count = int(random.integer(2, 6));
    const Bands bands = random_bands(random, count, 20, 20, 10);
    const auto klt = klt_of(bands);
    REQUIRE(klt);
    Eigen::MatrixXd matrix = as_matrix(bands);
    matrix.rowwise() -= matrix.colwise().mean();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinV);
    const double u = unit_roundoff<double>, trace = klt->trace();
    for (int k = 0; k < count; ++k) {
      const double value =
          svd.singularValues()[k] * svd.singularValues()[k] / double(bands.pixels());
      // The error of a covariance of 20 + 20 + 3 B roundings (transform.h), and as much for the
      // other way.
      CHECK(std::abs(value - klt->eigenvalues[k]) <= 2 * (40 + 3 * count) * u * trace);
      double gap = k > 0 ? klt->eigenvalues[k - 1] - klt->eigenvalues[k] : trace;
      if (k + 1 < count) gap = std::min(gap, klt->eigenvalues[k] - klt->eigenvalues[k + 1]);
      const double angle = angle_between(klt->vectors.col(k), svd.matrixV().col(k));
      CHECK(angle <= 4 * (40 + 3 * count) * u * trace / gap);
    }
  }
}

TEST_CASE("of equal eigenvalues the space is compared, and not the vectors") {
  // The corners of a cube, where all directions are equivalent.
  Bands bands{8, 1, {}};
  for (int b = 0; b < 3; ++b) {
    Band band{"band", {}};
    for (int i = 0; i < 8; ++i) band.samples.push_back((i >> b & 1) != 0 ? 1 : -1);
    bands.bands.push_back(band);
  }
  const auto klt = klt_of(bands);
  REQUIRE(klt);
  CHECK(eigenvalue_groups(klt->eigenvalues, 1e-12) == std::vector<int>{0, 0, 0});
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 1, 1).normalized()) * klt->vectors;
  CHECK(angle_between(klt->vectors, turned) < 1e-15);
  CHECK(angle_between(klt->vectors.leftCols(1), turned.leftCols(1)) > 0.1);
  // Small angles are distinguished from 0, which their cosine is not.
  const Eigen::Matrix3d nearly = Eigen::AngleAxisd(1e-10, Eigen::Vector3d::UnitX()).matrix();
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  CHECK(std::abs(angle_between(axes.leftCols(2), nearly.leftCols(2)) - 1e-10) < 1e-20);
  CHECK(eigenvalue_groups(Eigen::Vector3d(3, 2, 2), 0) == std::vector<int>{0, 1, 1});
}

TEST_CASE("bands that do not vary have components of nothing") {
  Bands bands{3, 2, {{"a", std::vector<double>(6, 7)}, {"b", std::vector<double>(6, 1e6)}}};
  const auto klt = klt_of(bands);
  REQUIRE(klt);
  CHECK(klt->trace() == 0);
  const Bands again = reconstructed(components_of(bands, *klt, 1), *klt, bands);
  CHECK(again.bands[1].samples == bands.bands[1].samples);
  CHECK(largest_correlation(components_of(bands, *klt, 2)) == 0);
}

TEST_CASE("bands that are none, of other sizes, or of numbers that are none are refused") {
  CHECK_FALSE(klt_of({}));
  CHECK_FALSE(klt_of({1, 1, {{"a", {1}}}}));
  CHECK_FALSE(klt_of({2, 2, {{"a", {1, 2, 3}}}}));
  const auto nan = klt_of({2, 1, {{"a", {1, 2}}, {"infra", {1, std::nan("")}}}});
  REQUIRE_FALSE(nan);
  CHECK(nan.error().message().find("infra: the sample in column 1, row 0") != std::string::npos);
  CHECK_FALSE(klt_of({2, 1, {{"a", {1, INFINITY}}}}));
  CHECK_FALSE(klt_of({2, 1, {{"a", {0, 1e200}}}}));
  CHECK(klt_of({2, 1, {{"a", {0, 1e150}}}}));
}

TEST_CASE("the generated planet is the same everywhere, and has no seam") {
  const CloudScene scene = make_clouds(256);
  REQUIRE(scene.bands.count() == 5);
  double sum = 0;
  bool is_count = true;
  for (const Band& band : scene.bands.bands) {
    for (const double sample : band.samples) {
      is_count = is_count && sample >= 0 && sample <= 1023 && sample == std::floor(sample);
      sum += sample;
    }
  }
  CHECK(is_count);
  // A sum of whole numbers, and therefore exact.
  CHECK(sum == 84969586.0);
  // The difference across the seam is like that between two adjacent columns: at most the largest
  // such difference, and for clouds at least the smallest, so that no column is repeated. (There
  // may be no land at the seam.)
  const auto apart = [&](const auto& value, std::size_t left, std::size_t right) {
    double sum = 0;
    for (std::size_t y = 0; y < 128; ++y)
      sum += std::abs(value(256 * y + left) - value(256 * y + right));
    return sum;
  };
  const auto opacity = [&](std::size_t i) { return scene.opacity[i]; };
  const auto green = [&](std::size_t i) { return double(scene.ground.pixels[i].g); };
  const auto extremes = [&](const auto& value) {
    std::pair<double, double> range{INFINITY, 0};
    for (std::size_t x = 1; x < 256; ++x) {
      const double one = apart(value, x - 1, x);
      range = {std::min(range.first, one), std::max(range.second, one)};
    }
    return range;
  };
  const auto [least_clouds, most_clouds] = extremes(opacity);
  CHECK(apart(opacity, 255, 0) >= least_clouds);
  CHECK(apart(opacity, 255, 0) <= most_clouds);
  CHECK(apart(opacity, 0, 128) > 2 * most_clouds);  // half a turn away is another place
  CHECK(apart(green, 255, 0) <= extremes(green).second);
  // All columns meet at the poles. Half a row from a pole they form a circle of 0.7 degrees, whose
  // points differ less than those of any row of the middle half.
  const auto range = [&](std::size_t y) {
    const auto first = scene.opacity.begin() + std::ptrdiff_t(256 * y);
    const auto [low, high] = std::minmax_element(first, first + 256);
    return *high - *low;
  };
  double least = INFINITY;
  for (std::size_t y = 32; y < 96; ++y) least = std::min(least, range(y));
  CHECK(range(0) < least);
  CHECK(range(127) < least);
}

TEST_CASE("clouds are where the longer tail of a component is, from its median on") {
  // 0 .. 96, and a few values beyond, up to 1100.
  Bands component{101, 1, {{"component 1", {}}}};
  for (int i = 0; i <= 100; ++i)
    component.bands[0].samples.push_back(i < 97 ? i : 1000 + 25 * (i - 96));
  Bands inverted = component;
  for (double& sample : inverted.bands[0].samples) sample = -sample;
  const Image<Rgba8> clouds = cloud_alpha(component);
  CHECK(clouds == cloud_alpha(inverted));
  CHECK(clouds.at(50, 0) == Rgba8{255, 255, 255, 0});
  CHECK(clouds.at(51, 0).a == 0);  // 1 of 1025
  CHECK(clouds.at(60, 0).a == 2);  // 10 of 1025, times 255
  CHECK(clouds.at(98, 0).a == 249);
  CHECK(clouds.at(99, 0).a == 255);
  CHECK(clouds.at(100, 0).a == 255);
  // Where the component does not vary, the sky is clear.
  component.bands[0].samples.assign(101, 7);
  CHECK(cloud_alpha(component).at(3, 0).a == 0);
}

TEST_CASE("the clouds of a globe go round outside of its ground") {
  const Image<Rgba8> image(2, 1, {255, 255, 255, 255});
  const Scene scene = make_globe(image, image);
  REQUIRE(scene.instances.size() == 2);
  const auto radius = [&](std::size_t i) {
    const Transform<World, Object>& there = scene.nodes[scene.instances[i].node].world_from_node;
    return (there * Point<Object, double>(1, 0, 0)).x;
  };
  CHECK(radius(0) == 1);
  CHECK(radius(1) == Approx(1.015));
}

}  // namespace glassbox::views
