#include <tests/pipeline/stereo/stereo_cases.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/pipeline/stereo/parallax_budget.h>

namespace glassbox {
namespace {

using test::kInfinity;

DepthSpan random_span(Random& random, const View& view) {
  const double a = test::random_distance(random, view), b = test::random_distance(random, view);
  return {std::min(a, b), std::max(a, b)};
}

ParallaxBudget random_budget(Random& random) {
  return {random.between(0, 40), random.between(0, 40)};
}

// ---- one picture ----

TEST_CASE("the largest separation uses the budget up and never exceeds it (S0-13)") {
  Random random(100);
  int in_front = 0, behind = 0, by_limit = 0;
  for (int i = 0; i < 100000; ++i) {
    const View centre = test::random_view(random);
    const DepthSpan span = random_span(random, centre);
    const ParallaxBudget budget = random_budget(random);
    const double window = test::random_distance(random, centre);
    const StereoPair pair{largest_half_separation(centre, window, span, budget), window};
    const double near = -parallax_at(centre, pair, span.nearest).px;
    const double far = parallax_at(centre, pair, span.farthest).px;
    const double used = std::max(near / budget.in_front_px, far / budget.behind_px);
    const bool within = near <= budget.in_front_px && far <= budget.behind_px;
    const bool largest =
        used > 1 - 1e-14 || pair.half_separation == window_half_width(centre, window);
    if (!within || !largest || !check_pair(centre, pair)) {
      CAPTURE(i, near, far, budget.in_front_px, budget.behind_px, pair.half_separation, window);
      CHECK(within);
      CHECK(largest);
      CHECK(check_pair(centre, pair));
    }
    if (used <= 1 - 1e-14) {
      ++by_limit;
    } else {
      ++(near / budget.in_front_px > far / budget.behind_px ? in_front : behind);
    }
  }
  // Each of the three terms of the minimum is the smallest in some cases.
  CHECK(in_front > 1000);
  CHECK(behind > 1000);
  CHECK(by_limit > 100);
}

TEST_CASE("the separation is the slide's formula, and at most what was asked for (S0-13)") {
  const View centre = test::view_of(PerspectiveLens{kPi / 2, 0.5, {}}, 720, 720);  // k = 360
  CHECK(largest_half_separation(centre, 4, {2, kInfinity}, {18, 90}) == Approx(18 / (720 * 0.25)));
  CHECK(largest_half_separation(centre, 4, {2, kInfinity}, {90, 18}) == Approx(18 / (720 * 0.25)));
  CHECK(largest_half_separation(centre, 4, {2, 8}, {90, 18}) == Approx(18 / (720 * 0.125)));
  CHECK(largest_half_separation(centre, 4, {2, 8}, {90, 18}, 0.06) == 0.06);
  CHECK(largest_half_separation(centre, 4, {2, 8}, {90, 0}) == 0);
  CHECK(largest_half_separation(centre, 4, {4, 4}, {1, 1}) == 4);  // the limit of check_pair
}

TEST_CASE("the best window is the harmonic mean, and none lets the separation be larger (S0-13)") {
  const View plain = test::view_of(PerspectiveLens{0.8, 0.1, {}});
  CHECK(best_window(plain, {2, 6}, {10, 10}) == Approx(3));
  CHECK(best_window(plain, {2, kInfinity}, {10, 10}) == Approx(4));
  CHECK(best_window(plain, {2, 6}, {0, 0}) == Approx(3));
  CHECK(best_window(plain, {2, 6}, {10, 0}) == 6);
  CHECK(best_window(plain, {2, 6}, {0, 10}) == 2);
  CHECK(best_window(plain, {2, kInfinity}, {10, 0}) == kInfinity);
  CHECK(best_window(test::view_of(OrthographicLens{4, 0, 100}), {2, 6}, {10, 10}) == Approx(4));

  Random random(101);
  for (int i = 0; i < 2000; ++i) {
    const View centre = test::random_view(random);
    const DepthSpan span = random_span(random, centre);
    if (span.farthest < 1.01 * span.nearest) continue;
    const ParallaxBudget budget = random_budget(random);
    const double best = best_window(centre, span, budget);
    const double most = largest_half_separation(centre, best, span, budget);
    // Not where check_pair's limit decides: the eyes are at most as far apart as the window is
    // wide.
    if (most == window_half_width(centre, best)) continue;
    for (int k = 0; k < 50; ++k) {
      const double other = random.between(span.nearest, span.farthest);
      const double there = largest_half_separation(centre, other, span, budget);
      if (!(there <= most * (1 + 1e-12))) {
        CAPTURE(i, best, other, most, there);
        CHECK(there <= most * (1 + 1e-12));
      }
    }
  }
}

TEST_CASE(
    "a budget of 65 mm keeps the farthest from making eyes diverge on a two-metre screen (C-72)") {
  const View centre = test::view_of(PerspectiveLens{0.8, 0.1, {}}, 1920, 1080);
  const Display screen{2000, 3000};
  // One unit apart with the window at ten: 133 mm on this screen, and the eyes diverge.
  CHECK(displayed_parallax(parallax_at(centre, {0.5, 10}, kInfinity), screen).diverges);
  const double budget_px = kPupilDistanceMm / screen.width_mm * 1920;
  const StereoPair pair{largest_half_separation(centre, 10, {3, kInfinity}, {1000, budget_px}, 0.5),
                        10};
  CHECK(displayed_parallax(parallax_at(centre, pair, kInfinity), screen).mm == Approx(65));
  CHECK(pair.half_separation < 0.5);
}

TEST_CASE("spans and budgets that make no sense are refused") {
  const View lens = test::view_of(PerspectiveLens{0.8, 0.1, {}});
  const View parallel = test::view_of(OrthographicLens{4, -5, 100});
  const double nan = std::nan("");
  CHECK(check_parallax_budget(lens, {1, kInfinity}, {10, 0}));
  CHECK(check_parallax_budget(parallel, {-1, 50}, {10, 10}));
  CHECK_FALSE(check_parallax_budget(lens, {0, 5}, {10, 10}));
  CHECK_FALSE(check_parallax_budget(lens, {-1, 5}, {10, 10}));
  CHECK_FALSE(check_parallax_budget(lens, {5, 1}, {10, 10}));
  CHECK_FALSE(check_parallax_budget(lens, {nan, 5}, {10, 10}));
  CHECK_FALSE(check_parallax_budget(lens, {1, nan}, {10, 10}));
  CHECK_FALSE(check_parallax_budget(lens, {kInfinity, kInfinity}, {10, 10}));
  CHECK_FALSE(check_parallax_budget(parallel, {1, kInfinity}, {10, 10}));
  CHECK_FALSE(check_parallax_budget(lens, {1, 5}, {-1, 10}));
  CHECK_FALSE(check_parallax_budget(lens, {1, 5}, {10, nan}));
  CHECK_FALSE(check_parallax_budget(lens, {1, 5}, {10, kInfinity}));
}

// ---- over time ----

TEST_CASE("a rising limit is approached without overshoot, a falling one followed at once (C-79)") {
  SeparationFilter filter(10);
  const double share = low_pass_weight(10);
  CHECK(filter.next(1) == 1);  // the first frame starts at its own limit
  CHECK(filter.next(0.1) == 0.1);
  double last = 0.1;
  for (int frame = 1; frame <= 1000; ++frame) {
    const double s = filter.next(1);
    CHECK(s >= last);
    CHECK(s <= 1);
    CHECK(s - last <= share * (1 - last) + 2 * unit_roundoff<double>);
    // A tenth of the way is done at the start; each frame leaves 10/11 of the rest.
    if (frame == 10) CHECK(s == Approx(1 - 0.9 * std::pow(10.0 / 11, 10)).epsilon(1e-12));
    last = s;
  }
  CHECK(last == Approx(1).epsilon(1e-12));
}

TEST_CASE("no release time means the limit itself") {
  CHECK(low_pass_weight(0) == 1);
  SeparationFilter filter(0);
  for (const double limit : {0.5, 1.0, 0.2, 3.0}) CHECK(filter.next(limit) == limit);
}

TEST_CASE(
    "whatever the limits do, the separation stays within them and moves no more than it must "
    "(S0-13)") {
  Random random(102);
  int rises = 0, falls = 0;
  for (int run = 0; run < 1000; ++run) {
    const double frames = random.between(0, 60), share = low_pass_weight(frames);
    SeparationFilter filter(frames);
    double last_s = 0, last_limit = 0, limit = 1;
    for (int i = 0; i < 200; ++i) {
      if (random.integer(0, 9) == 0) limit = std::exp(random.between(-5, 2));
      const double s = filter.next(limit);
      bool good = s <= limit && s > 0;
      if (i > 0) {
        ++(limit > last_s ? rises : falls);
        if (limit > last_s)
          good = good && s >= last_s &&
                 s - last_s <= share * (limit - last_s) + 4 * unit_roundoff<double> * limit;
        if (limit <= last_s) good = good && s == limit && last_s - s <= last_limit - limit;
      }
      if (!good) {
        CAPTURE(run, i, frames, limit, last_limit, s, last_s);
        CHECK(good);
      }
      last_s = s;
      last_limit = limit;
    }
  }
  CHECK(rises > 10000);
  CHECK(falls > 10000);
}

TEST_CASE(
    "with a look ahead, steps are bounded both ways and the limits still hold (S0-13, C-79)") {
  Random random(103);
  for (int run = 0; run < 1000; ++run) {
    std::vector<double> limits;
    double limit = 1;
    for (int i = 0; i < 200; ++i) {
      if (random.integer(0, 19) == 0) limit = random.between(0.01, 2);
      limits.push_back(limit);
    }
    const double bound = random.between(0.001, 0.2);
    const std::vector<double> s = smooth_separations(limits, random.between(0, 30), bound);
    REQUIRE(s.size() == limits.size());
    for (std::size_t i = 0; i < s.size(); ++i) {
      const double step = i == 0 ? 0 : std::abs(s[i] - s[i - 1]);
      // A sum of two numbers up to 2 is rounded by at most 2 u, here and in the difference.
      const bool good = s[i] <= limits[i] && s[i] >= 0.01 - 1e-15 && step <= bound + 0x1p-51;
      if (!good) {
        CAPTURE(run, i, limits[i], s[i], step, bound);
        CHECK(good);
      }
    }
  }
}

TEST_CASE("a look ahead falls in time along a straight line, and rises as without it") {
  const std::vector<double> limits{1, 1, 1, 1, 0.5, 0.5, 1, 1};
  const std::vector<double> fallen = smooth_separations(limits, 0, 0.25);
  CHECK(fallen == std::vector<double>{1, 1, 1, 0.75, 0.5, 0.5, 0.75, 1});
  SeparationFilter filter(5);
  std::vector<double> causal;
  for (const double limit : limits) causal.push_back(filter.next(limit));
  CHECK(smooth_separations(limits, 5) == causal);
  CHECK(smooth_separations({}, 5, 0.1).empty());
}

TEST_CASE("a window that jumps from 10 to 1 moves monotonically and stops there (C-79)") {
  WindowFilter filter(8);
  CHECK(filter.next(10) == 10);
  double last = 10;
  for (int frame = 0; frame < 400; ++frame) {
    const double window = filter.next(1);
    CHECK(window <= last);
    CHECK(window >= 1);
    // The parallax of infinity changes by the low-pass filter's share of the rest, 2 s d/h (1 -
    // 1/f).
    CHECK(1 / window - 1 / last <= low_pass_weight(8) * (1 - 1 / last) * (1 + 1e-12) + 1e-15);
    last = window;
  }
  CHECK(last == Approx(1).epsilon(1e-12));
  CHECK(filter.next(test::kInfinity) > 1);  // an infinite window is a target like any other
}

TEST_CASE("a camera path through all this keeps its budget in every frame (S0-13, C-79)") {
  // An object passes close by in frames 60 to 89, and the window jumps from 10 to 1 and back.
  const View centre = test::view_of(PerspectiveLens{0.8, 0.1, {}}, 1280, 720);
  std::vector<StereoFrame> frames;
  for (int i = 0; i < 200; ++i) {
    const bool close = i >= 60 && i < 90;
    frames.push_back({centre, {close ? 0.6 : 4.0, kInfinity}, i >= 100 && i < 150 ? 1.0 : 10.0});
  }
  const ParallaxBudget budget{25, 15};
  SmoothingOptions rates;
  rates.max_step = 0.002;
  const std::vector<StereoPair> pairs = smoothed_stereo_pairs(frames, budget, rates);
  REQUIRE(pairs.size() == frames.size());
  double largest = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    CAPTURE(i, pairs[i].half_separation, pairs[i].window);
    CHECK(check_pair(centre, pairs[i]));
    const double near = -parallax_at(centre, pairs[i], frames[i].span.nearest).px;
    const double far = parallax_at(centre, pairs[i], frames[i].span.farthest).px;
    CHECK(near <= budget.in_front_px);
    CHECK(far <= budget.behind_px);
    largest = std::max({largest, near / budget.in_front_px, far / budget.behind_px});
    if (i > 0) {
      CHECK(std::abs(pairs[i].half_separation - pairs[i - 1].half_separation) <=
            rates.max_step + 1e-15);
      CHECK(pairs[i].window >= 1 - 1e-15);
      CHECK(pairs[i].window <= 10 + 1e-14);
    }
  }
  CHECK(largest > 0.999);  // the budget is used: depth is not given up
}

}  // namespace
}  // namespace glassbox
