// S2-03, S2-04, C-114: errors relative to a true disparity map, and the true disparities of
// rendered pairs.
#include <tests/support/catch.h>

#include <cmath>
#include <limits>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>

#include "views/matching/disparity_errors.h"
#include "views/matching/rendered_pair.h"
#include "views/matching/winner.h"
#include "views/two_view/truth.h"

namespace glassbox::views {
namespace {

TEST_CASE("C-114: what is not known is no error, and what is not answered is one") {
  Image<float> stored(6, 1), disparity(6, 1);
  stored.pixels = {40, 0, std::numeric_limits<float>::infinity(), std::nanf(""), 20, 8};
  disparity.pixels = {10, 50, 50, 50, kNoDisparity, 5};
  const Image<float> truth = known_disparities(stored, 4);
  const DisparityErrors errors = disparity_errors(disparity, truth);
  CHECK(errors.known == 3);
  CHECK(errors.answered == 2);
  // 10 is right, 5 is off by 3, and one pixel has no answer.
  CHECK(errors.bad_percent[0] == Approx(200.0 / 3));
  CHECK(errors.bad_percent[3] == Approx(100.0 / 3));
  CHECK(errors.bad_of_answered[2] == Approx(50.0));
  CHECK(errors.rms == Approx(std::sqrt(4.5)));
  CHECK(errors.density_percent == Approx(200.0 / 3));
}

TEST_CASE("S2-03: of pixels that fall on one, the nearer hides the others") {
  Image<float> truth(8, 1, 1);
  truth.pixels[5] = truth.pixels[6] = 4;  // they fall on pixels 1 and 2, as do pixels 2 and 3
  const Image<std::uint8_t> visible = visible_by_reprojection(truth);
  const std::vector<int> expected{0, 1, 0, 0, 1, 1, 1, 1};
  for (int x = 0; x < 8; ++x) {
    INFO(x);
    CHECK(int(visible.at(x, 0)) == expected[std::size_t(x)]);
  }
}

TEST_CASE(
    "S2-13: a rendered pair's disparity is f B / z less that of the window, and its depth comes "
    "back") {
  const auto scene = make_builtin("room");
  REQUIRE(scene);
  const auto view = make_view(scene->cameras.at(0), 160, 120);
  REQUIRE(view);
  for (const double window : {3.0, std::numeric_limits<double>::infinity()}) {
    const StereoPair eyes{0.1, window};
    const auto pair = rendered_pair(*scene, *view, eyes, {});
    REQUIRE(pair);
    const auto left = known_picture(*scene, eye_view(*view, eyes, Side::kLeft), {});
    REQUIRE(left);
    const double product = pair->calibration.focal_px * 0.2;
    const Image<float> depths = depths_of(pair->truth.disparity, pair->calibration);
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < left->distance.pixels.size(); ++i) {
      const double z = double(left->distance.pixels[i]);
      if (!std::isfinite(z)) continue;
      ++drawn;
      // The position of a match is a float of up to 160 px, whose neighbours are 2^-17 apart; the
      // depth has the same relative error.
      CHECK(std::abs(double(pair->truth.disparity.pixels[i]) - product * (1 / z - 1 / window)) <
            2e-5);
      CHECK(std::abs(double(depths.pixels[i]) / z - 1) < 1e-4);
    }
    CHECK(drawn > 15000);
  }
}

}  // namespace
}  // namespace glassbox::views
