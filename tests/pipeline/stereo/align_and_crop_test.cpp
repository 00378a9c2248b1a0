#include <tests/pipeline/stereo/stereo_cases.h>

#include <algorithm>
#include <cmath>

#include <glassbox/pipeline/stereo/align_and_crop.h>

namespace glassbox {
namespace {

double snapped(double px) {
  return std::floor(px * 256 + 0.5);
}

// The half separation that shifts points at infinity by this many pixels.
double separation_for(const View& centre, double window, double shift_px) {
  return shift_px * window / (centre.clip_from_eye.at(0, 0) * double(centre.viewport.width()));
}

TEST_CASE(
    "cutting whole pixels from an unskewed pair puts every vertex where the skew does (S0-08)") {
  Random random(120);
  double farthest = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto pose = test::random_pose(random);
    const View centre = test::random_perspective(random, pose);
    const double window = test::random_distance(random, centre);
    const int shift = int(random.integer(0, 20));  // odd ones too
    const StereoPair pair{separation_for(centre, window, shift), window};
    const Result<AlignAndCrop> cut = align_and_crop(centre, pair);
    REQUIRE(cut);
    REQUIRE(cut->shift == shift);
    CHECK(cut->left.viewport.width() == centre.viewport.width() + float(shift));
    for (int k = 0; k < 50; ++k) {
      // Points are at least 0.1 away, a hundredth of the pose's distance, so that the rounding of
      // world positions stays below a subpixel.
      const double z = std::max(test::random_distance(random, centre), 0.1);
      const Point<World, double> p = pose * test::random_seen(random, centre, z);
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const bool left = side == Side::kLeft;
        const auto skewed = test::screen_of(eye_view(centre, pair, side), p);
        const auto wide = test::screen_of(left ? cut->left : cut->right, p);
        const double x = wide.x - (left ? cut->left_first : cut->right_first);
        farthest = std::max(farthest, std::abs(x - skewed.x));
        if (snapped(x) != snapped(skewed.x) || wide.y != skewed.y || wide.z != skewed.z) {
          CAPTURE(i, k, shift, left, x, skewed.x);
          CHECK(snapped(x) == snapped(skewed.x));
          CHECK(wide.y == skewed.y);
          CHECK(wide.z == skewed.z);
        }
      }
    }
  }
  WARN("S0-08: cut and skewed vertices at most " << farthest << " px apart in double");
  CHECK(farthest < 1e-8);
}

TEST_CASE("a shift of a fraction of a pixel leaves each picture half the remainder off (S0-08)") {
  const View centre = test::view_of(PerspectiveLens{0.8, 0.1, {}});
  for (const double shift : {6.3, 6.5, 6.8, 0.2}) {
    const StereoPair pair{separation_for(centre, 4, shift), 4};
    const AlignAndCrop cut = align_and_crop(centre, pair).value();
    CHECK(cut.shift_px == Approx(shift));
    CHECK(std::abs(cut.shift_px - cut.shift) <= 0.5 + 1e-12);
    for (const double z : {0.5, 4.0, 100.0}) {
      const Point<World, double> p{0.1, 0.2, -z};
      const double off = cut.shift_px - cut.shift;
      const double left = test::screen_of(cut.left, p).x - cut.left_first -
                          test::screen_of(eye_view(centre, pair, Side::kLeft), p).x;
      const double right = test::screen_of(cut.right, p).x - cut.right_first -
                           test::screen_of(eye_view(centre, pair, Side::kRight), p).x;
      CAPTURE(shift, z, left, right);
      CHECK(left == Approx(off / 2).margin(1e-10));
      CHECK(right == Approx(-off / 2).margin(1e-10));
    }
  }
}

TEST_CASE("what cannot be cut says so") {
  const View lens = test::view_of(PerspectiveLens{0.8, 0.1, {}}, 16000, 100);
  CHECK(align_and_crop(lens, {separation_for(lens, 4, 300), 4}));
  CHECK_FALSE(align_and_crop(lens, {separation_for(lens, 4, 400), 4}));
  CHECK_FALSE(align_and_crop(test::view_of(OrthographicLens{4, 0, 100}), {0.1, 4}));
  View part = lens;
  part.viewport.left = 10;
  CHECK_FALSE(align_and_crop(part, {0.1, 4}));
  // The naive pair, with its window at infinity, has nothing to cut.
  CHECK(align_and_crop(lens, {0.1, test::kInfinity}).value().shift == 0);
}

}  // namespace
}  // namespace glassbox
