#include <glassbox/compare/testing/gtest.h>

#include "pictures.h"

using glassbox::MatchesGolden;

TEST(Pictures, OfEveryTypeMatch) {
  EXPECT_THAT(colours(), MatchesGolden(GOLDEN "colours.png"));
  EXPECT_THAT(stored(), MatchesGolden(GOLDEN "stored.png"));
  EXPECT_THAT(view(), MatchesGolden(GOLDEN "view.pfm"));
  EXPECT_THAT(file(), MatchesGolden(GOLDEN "file.png"));
}
