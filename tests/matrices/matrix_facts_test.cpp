// Facts about a matrix: from textbook matrices the numbers that they were made from are recovered.
#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/matrices/decimal.h>
#include <glassbox/matrices/matrix_facts.h>
#include <cmath>
#include <limits>
#include "tests/matrices/textbook.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

namespace book = test::textbook;
using book::given;
using book::random_place;
using book::Rows;

TEST_CASE("affine matrices are told apart by what they do") {
  const auto shape = [](const Rows& m) { return matrix_facts(given(m).m).shape; };
  CHECK(shape(book::identity()) == MatrixShape::kIdentity);
  CHECK(shape(book::translation(1, 2, 3)) == MatrixShape::kTranslation);
  CHECK(shape(book::turn_y(30)) == MatrixShape::kRigid);
  CHECK(shape(book::product(book::translation(1, 2, 3), book::turn_x(200))) == MatrixShape::kRigid);
  CHECK(shape(book::product(book::turn_y(30), book::scaling(2, 2, 2))) == MatrixShape::kSimilarity);
  CHECK(shape(book::product(book::turn_y(30), book::scaling(1, 2, 3))) == MatrixShape::kScaled);
  CHECK(shape(book::product(book::scaling(1, 2, 3), book::turn_y(30))) ==
        MatrixShape::kScaledAfter);
  CHECK(shape(book::product(book::turn_x(20),
                            book::product(book::scaling(1, 2, 3), book::turn_y(30)))) ==
        MatrixShape::kSheared);
  CHECK(shape(book::scaling(1, 1, 0)) == MatrixShape::kFlat);
  CHECK(shape(book::perspective_gl(1, 1, 1, 10)) == MatrixShape::kProjective);
  CHECK(shape(book::transposed(book::translation(1, 2, 3))) == MatrixShape::kProjective);
  Rows broken = book::identity();
  broken[1][2] = std::numeric_limits<double>::quiet_NaN();
  CHECK(shape(broken) == MatrixShape::kNotFinite);
  const auto entry = first_not_finite(given(broken).m);
  REQUIRE(entry);
  CHECK(entry->row == 1);
  CHECK(entry->column == 2);
}

TEST_CASE("rotation, scale, mirror and translation are read back") {
  const Rows m = book::product(book::translation(1, -2, 3),
                               book::product(book::turn_y(35), book::scaling(2, 3, 4)));
  const MatrixFacts facts = matrix_facts(given(m).m);
  REQUIRE(facts.rotation);
  CHECK(degrees_from_radians(facts.rotation->radians) == Approx(35).epsilon(1e-6));
  CHECK(facts.rotation->axis.y == Approx(1).epsilon(1e-6));
  CHECK(facts.scale.x == Approx(2).epsilon(1e-6));
  CHECK(facts.scale.z == Approx(4).epsilon(1e-6));
  CHECK(facts.translation == glm::dvec3(1, -2, 3));
  CHECK(facts.determinant == Approx(24).epsilon(1e-6));
  CHECK(facts.rank == 4);
  CHECK_FALSE(facts.mirror());
  const MatrixFacts mirrored = matrix_facts(given(book::scaling(-1, 1, 1)).m);
  CHECK(mirrored.mirror());
  CHECK(mirrored.shape == MatrixShape::kRigid);
  CHECK_FALSE(mirrored.rigid());
  CHECK(mirrored.scale.x == -1);
}

TEST_CASE("rotations printed with few digits are rigid, to the digits they have") {
  Random random(410);
  for (int i = 0; i < 1000; ++i) {
    const auto eye = random_place(random, 9), target = random_place(random, 1);
    Rows view = book::look_at_right(eye, target, {0, 1, 0});
    CHECK(matrix_facts(given(view).m).orthogonality < 0x1p-21);
    for (auto& row : view) {
      for (double& entry : row) entry = std::round(entry * 1e4) / 1e4;
    }
    const MatrixFacts facts = matrix_facts(given(view).m);
    CAPTURE(i, facts.orthogonality);
    CHECK(facts.rigid());
    CHECK(facts.orthogonality > 0x1p-21);  // the lack of digits is noticed
    CHECK(facts.orthogonality < 4e-4);     // 3 products, each off by 5e-5, twice
  }
}

TEST_CASE("rank is counted by what rounding to float leaves, not by the size of the entries") {
  CHECK(rank_of(glm::dmat4(1)) == 4);
  CHECK(rank_of(glm::dmat4(0)) == 0);
  CHECK(rank_of(given(book::perspective_gl(1, 1, 1e-6, 1e6)).m) == 4);
  CHECK(rank_of(given(book::scaling(1e-12, 1, 1e12)).m) == 4);
  // The matrix of E15: diag(d, d, d, 0) and the row 0 0 1 0.
  CHECK(rank_of(given({{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 1, 0}}}).m) == 3);
  Random random(411);
  for (int i = 0; i < 500; ++i) {
    // A row is replaced by a sum of two others, rounded to float.
    Rows m{};
    for (auto& row : m) {
      for (double& entry : row) entry = double(float(random.between(-1, 1)));
    }
    CHECK(rank_of(given(m).m) == 4);
    for (std::size_t k = 0; k < 4; ++k) m[2][k] = m[0][k] * 0.75 + m[1][k] * 0.3;
    CAPTURE(i);
    CHECK(rank_of(given(m).m) == 3);
  }
}

TEST_CASE(
    "the eye's place and axes are read from a view matrix, as round as its digits leave them") {
  const auto eye = eyepoint_of(given(book::look_at_right({3, 2, 5}, {0, 0.5, 0}, {0, 1, 0})));
  REQUIRE(eye);
  CHECK(eye->digits == 3);
  CHECK(simplest_decimal(eye->position.x, eye->uncertainty).value == 3);
  CHECK(eye->level);
  const auto rolled = eyepoint_of(given(book::look_at_right({3, 2, 5}, {0, 0, 0}, {0.3, 1, 0.2})));
  REQUIRE(rolled);
  CHECK_FALSE(rolled->level);
  CHECK_FALSE(eyepoint_of(given(book::scaling(1, 0, 1))));
}

TEST_CASE("the simplest decimal has the fewest digits that the uncertainty allows") {
  CHECK(simplest_decimal(0.1f, 1e-8).digits == 1);
  CHECK(simplest_decimal(0.1f, 1e-8).value == 0.1);
  CHECK(simplest_decimal(0.1998002, 1e-7).digits == 7);
  CHECK(simplest_decimal(0.1998002, 1e-3).digits == 1);
  CHECK(simplest_decimal(1e-9, 1e-8).digits == 0);
  CHECK(simplest_decimal(std::numeric_limits<double>::infinity(), 0).digits == 1);
  CHECK(simplest_decimal(1.0 / 3, 0).value == 1.0 / 3);
}

}  // namespace
}  // namespace glassbox
