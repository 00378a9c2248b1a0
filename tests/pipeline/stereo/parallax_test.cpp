#include <tests/pipeline/stereo/stereo_cases.h>

#include <algorithm>
#include <cmath>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/stereo/constructions.h>
#include <glassbox/pipeline/stereo/parallax.h>

namespace glassbox {
namespace {

using test::kInfinity;

double measured_px(const View& centre, const StereoPair& pair, const Point<World, double>& p) {
  return test::screen_of(eye_view(centre, pair, Side::kRight), p).x -
         test::screen_of(eye_view(centre, pair, Side::kLeft), p).x;
}

TEST_CASE("the parallax of vertices is the formula's, for every kind of camera (S0-11)") {
  Random random(90);
  double worst_half_widths = 0;
  for (int i = 0; i < 100000; ++i) {
    const View centre = test::random_view(random);
    const StereoPair pair = test::random_pair(random, centre);
    const double z = test::random_distance(random, centre);
    const auto p = test::world_of(test::random_seen(random, centre, z));
    const Parallax formula = parallax_at(centre, pair, z);
    const double half = double(centre.viewport.width()) / 2;
    // Two screen positions, each with a few terms of the size of the picture or of the parallax.
    const double size = 4 + std::abs(centre.clip_from_eye.at(0, 2)) +
                        std::abs(formula.half_widths) +
                        2 * pair.half_separation * centre.clip_from_eye.at(0, 0) /
                            (centre.perspective ? std::min(z, pair.window) : 1) *
                            (centre.perspective ? 1 : 1 + z / pair.window);
    const double error = std::abs(measured_px(centre, pair, p) / half - formula.half_widths);
    worst_half_widths = std::max(worst_half_widths, error / size);
    if (!(error <= 8 * unit_roundoff<double> * size)) {
      CAPTURE(i, z, pair.half_separation, pair.window, error, formula.half_widths);
      CHECK(error <= 8 * unit_roundoff<double> * size);
    }
    if (formula.px != formula.half_widths * half) CHECK(formula.px == formula.half_widths * half);
    if (formula.percent != formula.half_widths * 50)
      CHECK(formula.percent == 50 * formula.half_widths);
  }
  WARN("parallax law: error at most "
       << worst_half_widths / unit_roundoff<double> << " u of the positions on the screen");
}

TEST_CASE("parallax is within 5 ulps of 2 s (d/h) (1/f - 1/z), next to the window too") {
  Random random(91);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const View centre = test::random_perspective(random);
    const StereoPair pair = test::random_pair(random, centre);
    const double z = i % 2 == 0 ? test::random_distance(random, centre)
                                : pair.window * (1 + std::ldexp(random.between(-1, 1), -30));
    const auto wide = [](double x) { return static_cast<long double>(x); };
    const long double exact = 2 * wide(pair.half_separation) * wide(centre.clip_from_eye.at(0, 0)) *
                              (wide(z) - wide(pair.window)) / (wide(pair.window) * wide(z));
    worst = std::max(worst, error_in_ulps(parallax_at(centre, pair, z).half_widths, exact));
  }
  WARN("worst error " << worst << " ulps");
  CHECK(worst <= 5);
}

TEST_CASE("at the window there is no parallax, and infinity has what very far things tend to") {
  const View centre = test::view_of(PerspectiveLens{kPi / 2, 0.5, {}}, 720, 720);  // a = 1
  const StereoPair pair{0.25, 4};
  CHECK(parallax_at(centre, pair, 4).half_widths == 0);
  const Parallax infinity = parallax_at(centre, pair, kInfinity);
  CHECK(infinity.half_widths == Approx(2 * 0.25 / 4).epsilon(1e-15));
  CHECK(infinity.px == Approx(45).epsilon(1e-15));
  CHECK(infinity.percent == Approx(6.25).epsilon(1e-15));
  CHECK(parallax_at(centre, pair, 1e15).half_widths == Approx(infinity.half_widths).epsilon(1e-12));
  CHECK(parallax_at(centre, {0.25, kInfinity}, kInfinity).half_widths == 0);
  CHECK(parallax_at(centre, {0.25, kInfinity}, 2).half_widths == Approx(-0.25).epsilon(1e-15));
  CHECK(parallax_at(centre, {0, kInfinity}, 2).half_widths == 0);

  const ParallaxTable table = parallax_table(centre, pair);
  CHECK(table.near.distance == 0.5);
  CHECK(table.near.half_widths == Approx(2 * 0.25 * (0.25 - 2)).epsilon(1e-15));
  CHECK(table.window.px == 0);
  CHECK(table.far.distance == kInfinity);
  CHECK(table.far.px == infinity.px);
}

TEST_CASE("a parallel projection's parallax is linear in depth") {
  const View centre = test::view_of(OrthographicLens{4, 0, 100}, 800, 800);  // a = 1/4
  const StereoPair pair{0.5, 10};
  CHECK(parallax_at(centre, pair, 0).px == -100);
  CHECK(parallax_at(centre, pair, 10).px == 0);
  CHECK(parallax_at(centre, pair, 20).px == 100);
  CHECK(parallax_at(centre, pair, 100).px == 900);
}

TEST_CASE("the far parallax grows by 2 s d/h per inverse window distance (S0-12)") {
  // Measured with a vertex at 1e9 window distances, as the difference between two windows.
  Random random(92);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    View centre = test::random_perspective(random);
    const double s = random.between(0.001, 0.1), f = random.between(1, 20);
    const double half = double(centre.viewport.width()) / 2;
    const Point<World, double> far{0, 0, -1e9 * f};
    const double slope = (measured_px(centre, {s, f / 2}, far) - measured_px(centre, {s, f}, far)) /
                         half / (2 / f - 1 / f);
    worst = std::max(worst, std::abs(slope / (2 * s * centre.clip_from_eye.at(0, 0)) - 1));
  }
  WARN("S0-12: the slope differs from the formula by at most " << worst);
  CHECK(worst < 1e-6);
}

// ---- in front of a display ----

TEST_CASE("more than 65 mm behind a two-metre screen makes the eyes diverge (C-72)") {
  const Display display{2000, 3000};
  const auto shown = [&](double mm) {
    return displayed_parallax({0, mm / 1000, 0, mm / 20}, display);
  };
  CHECK_FALSE(shown(64.9).diverges);
  CHECK(shown(65.1).diverges);
  CHECK(shown(65.1).mm == Approx(65.1).epsilon(1e-14));
  CHECK_FALSE(shown(-200).diverges);
  CHECK(shown(0).degrees == 0);
  // At 65 mm the eyes look straight ahead: their convergence is gone.
  CHECK(shown(65).degrees ==
        Approx(degrees_from_radians(2 * std::atan(32.5 / 3000))).epsilon(1e-12));
  // They converge more in front of the screen.
  CHECK(shown(-65).degrees < -1.2);
}

// ---- toe-in ----

TEST_CASE(
    "toe-in's vertical parallax is the formula's within 1e-3 px; skewed frusta have none (S0-07, "
    "C-75)") {
  Random random(93);
  double worst = 0, largest = 0;
  for (int i = 0; i < 100000; ++i) {
    const View centre = test::random_perspective(random);
    const StereoPair pair = test::random_pair(random, centre);
    const double z = std::max(test::random_distance(random, centre), 10 * pair.half_separation);
    const Point<Eye, double> eye = test::random_seen(random, centre, z);
    const auto p = test::world_of(eye);
    const auto y_up = [&](const View& view) { return -test::screen_of(view, p).y; };
    const double formula = toe_in_vertical_parallax_px(centre, pair, eye);
    const double measured = y_up(toe_in_view(centre, pair, Side::kLeft)) -
                            y_up(toe_in_view(centre, pair, Side::kRight));
    worst = std::max(worst, std::abs(formula - measured));
    largest = std::max(largest, std::abs(formula));
    const double skewed =
        y_up(eye_view(centre, pair, Side::kLeft)) - y_up(eye_view(centre, pair, Side::kRight));
    if (skewed != 0) CHECK(skewed == 0);
  }
  WARN("S0-07: formula and vertices differ by at most " << worst << " px, of up to " << largest);
  CHECK(worst <= 1e-3);
  CHECK(largest > 1);
}

TEST_CASE("toe-in's vertical parallax is zero on the axes and largest in a corner (S0-07, C-75)") {
  for (const Lens& lens : {Lens{PerspectiveLens{0.8, 0.1, {}}},
                           Lens{FrustumLens{-0.02, 0.08, -0.03, 0.03, 0.1, {}}}}) {
    const View centre = test::view_of(lens);
    const StereoPair pair{0.2, 6};
    CHECK(toe_in_vertical_parallax_px(centre, pair, {0, 2, -8}) == 0);
    CHECK(toe_in_vertical_parallax_px(centre, pair, {2, 0, -8}) == 0);
    double last = 0;
    for (const double z : {3.0, 6.0, 20.0, 1e9}) {
      double largest = 0;
      for (int row = 0; row <= 40; ++row) {
        for (int column = 0; column <= 40; ++column) {
          const auto& m = centre.clip_from_eye;
          const Point<Eye, double> p{z * (column / 20.0 - 1 + m.at(0, 2)) / m.at(0, 0),
                                     z * (row / 20.0 - 1 + m.at(1, 2)) / m.at(1, 1), -z};
          largest = std::max(largest, std::abs(toe_in_vertical_parallax_px(centre, pair, p)));
        }
      }
      const double corner = largest_toe_in_vertical_parallax_px(centre, pair, z);
      CHECK(corner == Approx(largest).epsilon(1e-12));
      CHECK(corner > last);
      last = corner;
    }
    CHECK(last > 1);  // C-75
    CHECK(largest_toe_in_vertical_parallax_px(centre, pair, kInfinity) ==
          Approx(last).epsilon(1e-6));
    WARN("C-75: half separation 0.2, window 6, 1280 x 720: up to " << last
                                                                   << " px of vertical parallax");
  }
}

}  // namespace
}  // namespace glassbox
