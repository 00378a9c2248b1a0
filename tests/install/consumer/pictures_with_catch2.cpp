#include <glassbox/compare/testing/catch2.h>

#include "pictures.h"

using glassbox::MatchesGolden;

TEST_CASE("pictures of every type match") {
  CHECK_THAT(colours(), MatchesGolden(GOLDEN "colours.png"));
  CHECK_THAT(stored(), MatchesGolden(GOLDEN "stored.png"));
  CHECK_THAT(view(), MatchesGolden(GOLDEN "view.pfm"));
  CHECK_THAT(file(), MatchesGolden(GOLDEN "file.png"));
}
