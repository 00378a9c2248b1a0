#include <glassbox/compare/testing/catch2.h>

#include "renderer.h"

using glassbox::MatchesGolden;

TEST_CASE("the disc is drawn as it was approved") {
  REQUIRE_THAT(renderer::render_disc(), MatchesGolden("images/disc.png"));
}

TEST_CASE("the distances are what they were") {
  CHECK_THAT(renderer::render_distances(), MatchesGolden("images/distances.pfm"));
}
