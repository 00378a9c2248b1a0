#include <glassbox/compare/testing/gtest.h>

#include "renderer.h"

using glassbox::MatchesGolden;

TEST(Disc, IsDrawnAsItWasApproved) {
  ASSERT_THAT(renderer::render_disc(), MatchesGolden("images/disc.png"));
}

TEST(Disc, HasTheDistancesItHad) {
  EXPECT_THAT(renderer::render_distances(), MatchesGolden("images/distances.pfm"));
}
