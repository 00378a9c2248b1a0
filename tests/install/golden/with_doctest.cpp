#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <glassbox/compare/testing/doctest.h>

#include "renderer.h"

using glassbox::MatchesGolden;

TEST_CASE("the disc is drawn as it was approved") {
  REQUIRE(MatchesGolden(renderer::render_disc(), "images/disc.png"));
}

TEST_CASE("the distances are what they were") {
  CHECK(MatchesGolden(renderer::render_distances(), "images/distances.pfm"));
}
