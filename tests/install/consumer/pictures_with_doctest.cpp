#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <glassbox/compare/testing/doctest.h>

#include "pictures.h"

using glassbox::MatchesGolden;

TEST_CASE("pictures of every type match") {
  CHECK(MatchesGolden(colours(), GOLDEN "colours.png"));
  CHECK(MatchesGolden(stored(), GOLDEN "stored.png"));
  CHECK(MatchesGolden(view(), GOLDEN "view.pfm"));
  CHECK(MatchesGolden(file(), GOLDEN "file.png"));
}
