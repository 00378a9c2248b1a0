#include <glassbox/base/counted.h>

#include "tests/support/catch.h"

namespace glassbox::test {

TEST_CASE("what is counted is plural but for one") {
  CHECK(counted(0, "triangle") == "0 triangles");
  CHECK(counted(1, "triangle") == "1 triangle");
  CHECK(counted(-1, "vertex", "vertices") == "-1 vertices");
  CHECK(singular_or_plural(1, "is", "are") == "is");
  CHECK(singular_or_plural(2, "is", "are") == "are");
}

}  // namespace glassbox::test
