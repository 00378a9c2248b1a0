// Inputs of labs 10 and 14. Numbers that are typed into cases, because a student's own function
// must not compute them, are what the cases say they are. Generated inputs keep what the contracts
// promise.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "exact/number.h"
#include "labs/10-epipolar/cases.h"
#include "labs/14-surfaces/generators.h"
#include "tests/support/catch.h"

using namespace glassbox;

TEST_CASE("the essential matrices in the cases of lab 10 are those of their cameras") {
  const auto is_of = [](const lab_10::Matrix& typed, const lab_10::Pose& pose) {
    const lab_10::Matrix right = lab_10::given_essential(pose);
    // An entry rounds by less than 3 u |T|, u = 2^-53, and the typed number by less than another.
    const double bound = 4 * 0x1p-53 * lab_10::length(pose.translation);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        INFO("row " << i << ", column " << j);
        CHECK(std::abs(typed[i][j] - right[i][j]) <= bound);
      }
    }
  };
  is_of(lab_10::kParallelMatrix, lab_10::parallel_pose());
  is_of(lab_10::kConvergingMatrix, lab_10::converging_pose());
  is_of(lab_10::kArbitraryMatrix, lab_10::arbitrary_pose());
  const std::vector<lab_10::ChoiceCase> choices = lab_10::choices();
  const lab_10::Matrix& e = choices[3].essential;  // with the sign -1
  REQUIRE(choices[3].what == "a right camera that is to the left of the left one");
  is_of({lab_10::times(-1, e[0]), lab_10::times(-1, e[1]), lab_10::times(-1, e[2])},
        {lab_10::turned_by(15, 0, -1, 0.5), {-0.6, 0.1, 0.1}});
}

TEST_CASE("the directions in the cases of lab 14 have unit length") {
  const auto has_unit_length = [](const lab_14::Vector& v) {
    CHECK(std::abs(std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1) <= 4 * 0x1p-53);
  };
  for (const lab_14::ViewCase& each : lab_14::views_around()) {
    INFO(each.what);
    has_unit_length(each.direction);
    for (const lab_14::Vector& view : each.views) has_unit_length(view);
  }
}

TEST_CASE("the means and vectors in the cases of lab 14 are those of their pixels") {
  for (const lab_14::BandCase& each : lab_14::bands()) {
    INFO(each.what);
    const std::size_t bands = each.pixels.front().size();
    const std::vector<double> mean = lab_14::mean_of(each.pixels);
    REQUIRE(each.mean.size() == bands);
    REQUIRE(each.vectors.size() == bands);
    lab_14::Matrix covariance(bands, std::vector<double>(bands, 0));
    double largest = 0;
    for (const std::vector<double>& x : each.pixels) {
      for (std::size_t i = 0; i < bands; ++i) {
        for (std::size_t j = 0; j < bands; ++j)
          covariance[i][j] +=
              (x[i] - each.mean[i]) * (x[j] - each.mean[j]) / double(each.pixels.size());
        largest = std::max(largest, covariance[i][i]);
      }
    }
    const auto product = [bands](const std::vector<double>& a, const std::vector<double>& b) {
      double sum = 0;
      for (std::size_t i = 0; i < bands; ++i) sum += a[i] * b[i];
      return sum;
    };
    double before = INFINITY;
    for (std::size_t i = 0; i < bands; ++i) {
      INFO("number " << i);
      CHECK(std::abs(each.mean[i] - mean[i]) <= 8 * 0x1p-53 * (1 + std::abs(mean[i])));
      const std::vector<double>& v = each.vectors[i];
      for (std::size_t j = 0; j < bands; ++j)
        CHECK(std::abs(product(v, each.vectors[j]) - (i == j)) <= 32 * 0x1p-53);
      // C v = lambda v; the largest eigenvalue comes first.
      std::vector<double> image(bands);
      for (std::size_t j = 0; j < bands; ++j) image[j] = product(covariance[j], v);
      const double lambda = product(image, v);
      CHECK(lambda <= before + 64 * 0x1p-53 * largest);
      before = lambda;
      for (std::size_t j = 0; j < bands; ++j)
        CHECK(std::abs(image[j] - lambda * v[j]) <= 64 * 0x1p-53 * largest * double(bands));
    }
  }
}

TEST_CASE("rounding does not decide about the generated directions of lab 14") {
  using Exact = std::array<exact::Rational, 3>;
  const auto exact_of = [](const lab_14::Vector& v) {
    return Exact{exact::Rational(v[0]), exact::Rational(v[1]), exact::Rational(v[2])};
  };
  const auto product = [](const Exact& a, const Exact& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto across = [](const Exact& a, const Exact& b) {
    return Exact{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  constexpr double u = 0x1p-53;
  for (const auto& each : lab_14::generated_views_around()) {
    INFO(each.what);
    int small_sums = 0;
    for (int i = 0; i < 2000; ++i) {
      labs::Choices choices(labs::input_seed(14, each.what, i));
      const lab_14::ViewCase input = each.make(choices);
      const Exact v = exact_of(input.direction);
      std::array<Exact, 3> views;
      for (std::size_t k = 0; k < 3; ++k) views[k] = exact_of(input.views[k]);
      const exact::Rational volume = product(views[0], across(views[1], views[2]));
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double weight =
            double(product(v, across(views[(k + 1) % 3], views[(k + 2) % 3])) / volume);
        // A weight has this error bound before it is divided, a dot product has one of 4 u.
        CHECK((weight == 0 || std::abs(weight) > 64 * u / std::abs(double(volume))));
        const double closer = double(product(views[k], v) - product(views[(k + 1) % 3], v));
        CHECK((closer == 0 || std::abs(closer) > 8 * u));
        if (input.sees[k]) sum += std::max(0.0, weight);
      }
      small_sums += sum > 0 && sum < 1e-9;
    }
    const bool has_small_ones = std::string(each.what) == "views that are apart";
    CHECK((small_sums > 0) == has_small_ones);
  }
}
