// C-112: slanted walls, matched to a fraction of a pixel.
#include <tests/support/catch.h>

#include "tests/views/matching/slanted_wall.h"
#include "views/matching/disparity_errors.h"
#include "views/matching/filters.h"
#include "views/matching/match.h"
#include "views/matching/winner.h"

namespace glassbox::views {
namespace {

DisparityErrors errors_on(const SlantedWall& wall, const MatchSettings& settings) {
  const auto match = match_pictures(wall.left, wall.right, settings);
  REQUIRE(match);
  return disparity_errors(match->disparity, wall.disparity, &wall.is_inside);
}

TEST_CASE(
    "C-112: a textured wall that slants is found to a tenth of a pixel, and by planes to a "
    "twentieth") {
  for (const Slant& slant : {Slant{20, 0.1, 0}, Slant{20, 0, 0.1}, Slant{24, 0.05, 0.05},
                             Slant{30, -0.1, 0.05}, Slant{18, 0.15, 0}}) {
    const SlantedWall wall = slanted_wall(160, 100, slant, 7);
    INFO("slant " << slant.a << ", " << slant.b);
    MatchSettings settings = *settings_named("default");
    settings.range = {0, 50};
    const DisparityErrors usual = errors_on(wall, settings);
    // The targets of a default match and of one with planes. Errors of a pixel or more are counted
    // separately, at most one in a thousand.
    CHECK(usual.rms_good <= 0.1);
    CHECK(usual.bad_percent[1] <= 0.1);
    settings.smooth = false;
    CHECK(errors_on(wall, settings).rms_good > usual.rms_good);
    settings.smooth = true;
    settings.planes = 1;
    const DisparityErrors by_planes = errors_on(wall, settings);
    CHECK(by_planes.rms_good <= 0.05);
    CHECK(by_planes.bad_percent[1] <= 0.1);
  }
}

TEST_CASE("planes and averages leave what has no disparity, and step over no jump") {
  Image<float> disparity(12, 6, 3);
  for (int y = 0; y < 6; ++y) {
    for (int x = 6; x < 12; ++x) disparity.at(x, y) = 3.5f;
  }
  disparity.at(2, 2) = kNoDisparity;
  disparity.at(3, 4) = 3.25f;
  const Image<float> smooth = smooth_parts(disparity, best_target());
  CHECK(smooth.at(2, 2) == kNoDisparity);
  CHECK(smooth.at(0, 0) == 3);
  CHECK(smooth.at(11, 0) == 3.5f);
  // Half a pixel is a jump, a quarter is not. Columns 1 to 5 and rows 2 to 5 have 20 pixels: 18
  // are 3, one has no disparity, and one is the pixel itself.
  CHECK(smooth.at(5, 0) == 3);
  CHECK(smooth.at(3, 4) == Approx(3.25 - 0.25 * 18 / 19));
}

TEST_CASE("planes do not move what has no contrast") {
  const Image<Rgba8> blank(40, 30, {90, 90, 90, 255});
  MatchSettings settings = *settings_named("default");
  settings.range = {0, 9};
  const auto usual = match_pictures(blank, blank, settings);
  settings.planes = 2;
  const auto by_planes = match_pictures(blank, blank, settings);
  REQUIRE(usual);
  REQUIRE(by_planes);
  CHECK(by_planes->disparity == usual->disparity);
}

}  // namespace
}  // namespace glassbox::views
