#include <tests/pipeline/roundoff.h>
#include <tests/pipeline/stereo/stereo_cases.h>

#include <algorithm>
#include <cmath>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/stereo/constructions.h>

namespace glassbox {
namespace {

using test::u;

Transform<Clip, World> composed(const View& view) {
  return view.clip_from_eye * view.eye_from_world;
}

// ---- three ways to the same pair ----

TEST_CASE("skew, off-axis frustum, translation and shear are the same matrix within 4 u (S0-11)") {
  // u is relative to the entry, or to 1 for the entry that adds an offset in NDC: half a picture's
  // width. The off-axis frustum computes (r + l)/(r - l) from edges that include the shift, so a
  // small offset is correct to u of the width, not of itself.
  Random random(80);
  double scale = 0, offset = 0, translation = 0, shear = 0, others = 0;
  for (int i = 0; i < 100000; ++i) {
    const View centre = test::random_perspective(random);
    const StereoPair pair = test::random_pair(random, centre);
    const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
    const auto skewed = composed(eye_view(centre, pair, side));
    const auto sheared = composed(translate_and_shear_view(centre, pair, side));
    const Result<View> off_axis_eye = off_axis_view(centre, pair, side);
    REQUIRE(off_axis_eye);
    const auto off_axis = composed(*off_axis_eye);
    const auto relative = [&](int row, int column, const Transform<Clip, World>& m) {
      const double exact = skewed.at(row, column);
      return std::abs(m.at(row, column) - exact) / std::max(std::abs(exact), 1e-300) / u;
    };
    scale = std::max(scale, relative(0, 0, off_axis));
    translation = std::max(translation, relative(0, 3, off_axis));
    const double size = std::max(1.0, std::abs(skewed.at(0, 2)));
    offset = std::max(offset, std::abs(off_axis.at(0, 2) - skewed.at(0, 2)) / size / u);
    others = std::max(
        {others, relative(1, 1, off_axis), relative(2, 2, off_axis), relative(2, 3, off_axis)});
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        shear = std::max(shear, std::abs(sheared.at(row, column) - skewed.at(row, column)));
      }
    }
  }
  WARN("largest differences from the skew matrix, in u: off-axis frustum: scale "
       << scale << ", offset " << offset << ", translation " << translation << ", rows y and z "
       << others << "; translation and shear " << shear / u);
  CHECK(scale <= 4);
  CHECK(offset <= 4);
  CHECK(translation <= 5);  // the scale times the eye's shift, with one more rounding
  CHECK(others <= 4);
  CHECK(shear == 0);
}

TEST_CASE("the three ways draw every point in the same place, from any pose") {
  Random random(81);
  double farthest = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto pose = test::random_pose(random);
    const View centre = test::random_perspective(random, pose);
    const StereoPair pair = test::random_pair(random, centre);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const View skewed = eye_view(centre, pair, side);
      const View ways[] = {off_axis_view(centre, pair, side).value(),
                           translate_and_shear_view(centre, pair, side)};
      for (int k = 0; k < 50; ++k) {
        const double z = test::random_distance(random, centre);
        const Point<World, double> p = pose * test::random_seen(random, centre, z);
        const double x = test::screen_of(skewed, p).x;
        for (const View& way : ways) {
          // World coordinates up to 30 are rounded by 30 u, which is seen from the point's
          // distance.
          const double a = centre.clip_from_eye.at(0, 0), w = double(centre.viewport.width());
          const double bound_px = 64 * u * w * (1 + a * (30 + z) / z);
          const double apart = std::abs(test::screen_of(way, p).x - x);
          farthest = std::max(farthest, apart);
          if (!(apart <= bound_px)) {
            CAPTURE(i, k, apart, bound_px);
            CHECK(apart <= bound_px);
          }
        }
      }
    }
  }
  CHECK(farthest < 1e-6);
}

TEST_CASE("a parallel projection has no off-axis frustum, but translation and shear") {
  Random random(82);
  const View centre = test::random_parallel(random);
  const StereoPair pair = test::random_pair(random, centre);
  CHECK_FALSE(off_axis_view(centre, pair, Side::kLeft));
  const auto skewed = composed(eye_view(centre, pair, Side::kLeft));
  const auto sheared = composed(translate_and_shear_view(centre, pair, Side::kLeft));
  for (int column = 0; column < 4; ++column) {
    CHECK(std::abs(skewed.at(0, column) - sheared.at(0, column)) <= 4 * u);
  }
}

// ---- the slide's matrix after the projection (E2) ----

TEST_CASE("in clip space the slide's matrix has its window at the NDC depth `focus` (E2)") {
  const View centre = test::view_of(PerspectiveLens{0.8, 1, 9.0});
  const ClipSkew skew{0.01, 0.75};  // the depth z' = 9/8 (z - 1)/z is 3/4 at z = 3
  for (const double z : {1.0, 2.0, 3.0, 9.0}) {
    const Point<Clip, double> c = centre.clip_from_eye * Point<Eye, double>{0.5, 0.2, -z};
    const Point<Clip, double> left =
        clip_skew_view(centre, skew, Side::kLeft).clip_from_eye * Point<Eye, double>{0.5, 0.2, -z};
    CAPTURE(z);
    CHECK(std::abs(left.x / left.w - (c.x / c.w + 0.01 * (1 - c.z / c.w / 0.75))) <= 8 * u);
    CHECK(left.y == c.y);
    CHECK(left.z == c.z);
    CHECK(left.w == c.w);
    CHECK(std::abs((1 - c.z / c.w / 0.75)) == Approx(std::abs(1.5 / z - 0.5)).margin(1e-12));
  }
  CHECK(pair_of_clip_skew(centre, skew).window == Approx(3).epsilon(1e-15));
}

TEST_CASE("with its numbers changed, the skew in clip space is the pair in eye space (E2)") {
  Random random(83);
  double farthest_px = 0, window_error = 0, separation_error = 0;
  for (int i = 0; i < 20000; ++i) {
    const View centre = test::random_view(random);
    const StereoPair pair = test::random_pair(random, centre);
    const Result<ClipSkew> skew = clip_skew_of_pair(centre, pair);
    REQUIRE(skew);
    // Depth has a relative error of about n/z, and its distance from the nearer end of the range
    // costs digits on the way there and back.
    const double lost = centre.perspective ? pair.window / std::min(centre.near, pair.window) /
                                                 std::abs(skew->focus)
                                           : 1000 / std::abs(skew->focus);
    const StereoPair back = pair_of_clip_skew(centre, *skew);
    window_error = std::max(window_error, std::abs(back.window / pair.window - 1) / u / lost);
    separation_error = std::max(
        separation_error, std::abs(back.half_separation / pair.half_separation - 1) / u / lost);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const View in_eye = eye_view(centre, pair, side);
      const View in_clip = clip_skew_view(centre, *skew, side);
      for (int k = 0; k < 5; ++k) {
        const double z = test::random_distance(random, centre);
        const auto p = test::world_of(test::random_seen(random, centre, z));
        farthest_px = std::max(
            farthest_px, std::abs(test::screen_of(in_eye, p).x - test::screen_of(in_clip, p).x));
      }
    }
  }
  WARN("E2: the two skews at most " << farthest_px << " px apart; there and back, window "
                                    << window_error << ", separation " << separation_error
                                    << " u of the digits that depth keeps");
  CHECK(farthest_px <= 1e-9);
  CHECK(window_error <= 16);
  CHECK(separation_error <= 16);
}

TEST_CASE("a window at depth 0 has no skew in clip space") {
  const View standard = test::view_of(PerspectiveLens{0.8, 0.5, 100.0});
  CHECK_FALSE(clip_skew_of_pair(standard, {0.01, 0.5}));
  const View reversed = test::view_of(PerspectiveLens{0.8, 0.5, {}}, 64, 64, DepthRange::kReversed);
  CHECK_FALSE(clip_skew_of_pair(reversed, {0.01, test::kInfinity}));
}

// ---- the wrong way ----

TEST_CASE(
    "toed-in cameras stand where the skewed ones do and meet at the window's centre (S0-07)") {
  Random random(84);
  for (int i = 0; i < 1000; ++i) {
    const View centre = test::view_of(PerspectiveLens{0.8, 0.1, {}});
    const StereoPair pair = test::random_pair(random, centre);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const View eye = toe_in_view(centre, pair, side);
      const Point<Eye, double> met = eye.eye_from_world * Point<World, double>{0, 0, -pair.window};
      CHECK(std::abs(met.x) <= 8 * u * pair.window);
      const Point<Eye, double> itself =
          eye.eye_from_world * Point<World, double>{-eye_shift(pair, side), 0, 0};
      CHECK(std::abs(itself.x) <= 8 * u * pair.half_separation);
      CHECK(std::abs(itself.z) <= 8 * u * pair.half_separation);
    }
  }
}

}  // namespace
}  // namespace glassbox
