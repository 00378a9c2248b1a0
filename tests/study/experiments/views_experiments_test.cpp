// D-18 to D-25: the laws of voxels and of two or more pictures, in addition to those that hold for
// every experiment.
#include <cmath>

#include "study/bench/statistics.h"
#include "tests/study/experiments/check_experiment.h"

namespace glassbox::test {
namespace {

using namespace study;

std::vector<Sample> series_of(const std::vector<Measured>& all, const std::string& series,
                              const std::string& measure) {
  std::vector<Sample> samples;
  for (const Measured& m : all) {
    if (m.configuration.series == series && m.configuration.measure == measure)
      samples.push_back({m.configuration.parameter, m.error});
  }
  return samples;
}

// Width, height and number of disparities are proportional to the parameter. Along a row the first
// columns have fewer disparities, a term of second order: 1/3 of the width's share at 32 px, less
// than 0.03 in the exponent.
TEST_CASE("matching along rows goes with W H D, in the whole picture with W^2 H^2 (D-20)") {
  const auto all = measure(d20_search());
  const auto row = fit_power_law(series_of(all, "along the row", "comparisons"));
  const auto whole = fit_power_law(series_of(all, "in the whole picture", "comparisons"));
  CHECK(std::abs(row.exponent - 3) < 0.03);
  CHECK(std::abs(whole.exponent - 4) < 1e-9);
}

TEST_CASE("the best baseline is neither the shortest nor the longest (D-21)") {
  const std::vector<Measured> all = measure(d21_baseline());
  // Estimates are bounded from both sides: neither the law alone nor ten times as much would be
  // accepted.
  for (const Measured& each : all) {
    const auto& [why, least, greatest] = each.configuration.finding.value_or(Finding{});
    if (why.empty()) continue;
    const double ratio = each.error / each.configuration.predicted_error.value();
    INFO(each.configuration.parameter << ": " << ratio << " in " << least << " to " << greatest);
    CHECK(greatest < 30 * least);
    CHECK((ratio >= least && ratio <= greatest));
  }
  const auto errors = series_of(all, "the default matcher", "");
  const auto best = std::ranges::min_element(errors, {}, &Sample::y);
  REQUIRE(errors.size() >= 5);
  CHECK(errors.front().y > 2 * best->y);
  CHECK(errors.back().y > 2 * best->y);
  CHECK(best->x >= 0.05);
  CHECK(best->x <= 0.2);
}

// 1177 and 145 samples: a factor of eight. Medians of five runs, each of which finds its own share
// of inliers.
TEST_CASE(
    "with half of the matches wrong, eight points take eight times the samples of five (D-22)") {
  const auto all = measure(d22_samples());
  const double five = error_at(all, "five points", "", 0.5);
  const double eight = error_at(all, "eight points", "", 0.5);
  CHECK(eight / five > 4);
  CHECK(eight / five < 16);
  for (const double matches : {8.0, 20.0, 50.0}) {
    const double gain = error_at(all, "pixels", "", matches, "condition") /
                        error_at(all, "normalised points", "", matches, "condition");
    CHECK(std::log10(gain) > 3);
    CHECK(std::log10(gain) < 3.7);
  }
}

TEST_CASE(
    "all ways to triangulate agree where both cameras are as far away; where one is nearer, those "
    "that weigh pixels are better at high convergence (D-23)") {
  const auto all = measure(d23_triangulation());
  for (const double degrees : {1.0, 5.0, 20.0, 60.0, 90.0, 120.0}) {
    const auto at = [&](const char* series, const char* scene) {
      return error_at(all, series, scene, degrees);
    };
    const double best = at("Hartley-Sturm", "both cameras equally far away");
    for (const char* series : {"midpoint", "linear", "linear, normalised", "Lindstrom"}) {
      INFO(series << " at " << degrees);
      CHECK(std::abs(at(series, "both cameras equally far away") / best - 1) < 0.03);
    }
    const double nearer = at("Hartley-Sturm", "one camera six times nearer");
    CHECK(std::abs(at("Lindstrom", "one camera six times nearer") / nearer - 1) < 1e-3);
    if (degrees >= 60) {
      CHECK(at("midpoint", "one camera six times nearer") > 1.05 * nearer);
    }
  }
}

// Visits of voxels and pictures are counted, not timed.
TEST_CASE(
    "voxel colouring looks N^3 m times and asks for memory as N^2, and smaller voxels are nearer "
    "to "
    "the surface until they are pixels (D-18)") {
  const auto all = check_experiment(d18_voxels());
  const auto looks = fit_power_law(series_of(all, "centre", "looks"));
  CHECK(std::abs(looks.exponent - 3) < 0.01);
  const auto memory = fit_power_law(series_of(all, "centre", "memory"));
  CHECK(std::abs(memory.exponent - 2) < 0.1);
  // No finding is needed: the laws hold within a third, and for the memory nearly exactly.
  for (const Measured& each : all) {
    CHECK_FALSE(each.configuration.finding);
    if (!each.configuration.predicted_error) continue;
    const double ratio = each.error / *each.configuration.predicted_error;
    INFO(each.configuration.series << " " << each.configuration.parameter << ": " << ratio);
    CHECK(ratio > 0.95);
    CHECK(ratio < (each.configuration.measure.empty() ? 4.0 / 3 : 1.001));
  }
  // Four times as many voxels across, as long as each voxel has its own pixels.
  const auto surface = series_of(all, "centre", "");
  CHECK(surface.front().y > 2 * surface.back().y);
  // More pictures do not worsen the match with a picture that was left out.
  const auto pictures = series_of(all, "centre", "pictures");
  CHECK(pictures.back().y < 1.5 * pictures.front().y);
}

TEST_CASE("coarse to fine looks at a part of the voxels, and loses what is thin (D-19)") {
  const auto all = check_experiment(d19_coarse_to_fine());
  const char* twice = "coarse thresholds times 2";
  CHECK(error_at(all, twice, "ball", 2, "judged") < 0.6);
  CHECK(error_at(all, twice, "ball", 2) < 0.1);
  // One more level never restores what was lost, and the rods are lost before the ball.
  const char* rods = "ball and rods two voxels thick";
  CHECK(error_at(all, twice, rods, 3) > error_at(all, twice, rods, 1));
  CHECK(error_at(all, twice, rods, 3) > error_at(all, twice, "ball", 3));
}

}  // namespace
TEST_CASE(
    "three pictures make the one between them better than the nearest, whose weights jump (D-24)") {
  const auto all = check_experiment(d24_view_blends());
  for (const double degrees : {4.0, 8.0, 16.0}) {
    CHECK(error_at(all, "barycentric weights", "shiny teapot", degrees) <
          error_at(all, "the nearest picture", "shiny teapot", degrees));
  }
  for (const char* blend :
       {"the nearest picture", "barycentric weights", "four neighbours by their angles"}) {
    // The control: without highlights the angle has no effect, and with a single colour no error is
    // left.
    CHECK(error_at(all, blend, "dull teapot", 24) < 1.5 * error_at(all, blend, "dull teapot", 4));
    CHECK(error_at(all, blend, "teapot of one colour", 24) == 0);
    // This error is the resampling of pixels. In pictures eight times as fine, a linear
    // interpolation errs by 1/64 as much within a smooth colour, and one pixel in eight times as
    // many is on an edge, which gives 1/sqrt(8) of the RMS.
    const double fall = error_at(all, blend, "dull teapot, 8 degrees apart", 1, "finer") /
                        error_at(all, blend, "dull teapot, 8 degrees apart", 8, "finer");
    CHECK(fall > std::sqrt(8.0));
    CHECK(fall < 64);
  }
  CHECK(series_of(all, "the nearest picture", "jump").front().y == 1);
  CHECK(series_of(all, "barycentric weights", "jump").front().y < 1e-4);
}

TEST_CASE("only the fifteen cases leave holes; tetrahedra take three times the triangles (D-25)") {
  const auto all = measure(d25_surfaces());
  for (const Sample& holes : series_of(all, "fifteen cases", "holes")) CHECK(holes.y > 0);
  const double cubes = error_at(all, "one rule for every ambiguous face", "sphere", 6, "triangles");
  const double tetrahedra = error_at(all, "six tetrahedra", "sphere", 6, "triangles");
  CHECK(tetrahedra / cubes > 2.7);
  CHECK(tetrahedra / cubes < 3.2);
}

}  // namespace glassbox::test
