// Facts about a projection: from textbook projections, with or without a view in them, the numbers
// that they were made from are recovered.
#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/matrices/matrix_setup.h>
#include <glassbox/matrices/projection_factors.h>
#include <glassbox/matrices/projection_facts.h>
#include <cmath>
#include <string>
#include "tests/matrices/textbook.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

namespace book = test::textbook;
using book::given;
using book::random_place;
using book::Rows;

TEST_CASE("angle, aspect ratio, planes and handedness are recovered from textbook projections") {
  Random random(412);
  for (int i = 0; i < 2000; ++i) {
    const double fovy = random.between(10, 150), aspect = random.between(0.4, 2.5);
    const double n = std::exp(random.between(-3, 1)), f = n * std::exp(random.between(1, 5));
    CAPTURE(i, fovy, aspect, n, f);
    const auto check = [&](const Rows& m, bool down, bool from_minus_one) {
      const ProjectionFacts p = projection_facts(given(m));
      REQUIRE(p.kind == ProjectionKind::kPerspective);
      CHECK(p.looks_down_minus_z == down);
      CHECK(p.fovy_degrees == Approx(fovy).epsilon(1e-6));
      CHECK(p.aspect == Approx(aspect).epsilon(1e-6));
      CHECK_FALSE(p.depth_lost);
      CHECK_FALSE(p.depth_reversed());
      CHECK_FALSE(p.off_centre());
      const DepthReading& r = from_minus_one ? p.minus_one_to_one : p.zero_to_one;
      CHECK(r.possible);
      // The error is within the uncertainty that comes from the rounding of the entries, up to
      // second order.
      CHECK(std::abs(r.near - n) <= 1.01 * r.near_uncertainty + 1e-12);
      CHECK(std::abs(r.far - f) <= 1.01 * r.far_uncertainty + 1e-12);
    };
    const double angle = book::radians(fovy);
    check(book::perspective_gl(angle, aspect, n, f), true, true);
    check(book::perspective_d3d_right(angle, aspect, n, f), true, false);
    check(book::perspective_d3d_left(angle, aspect, n, f), false, false);
    Rows scaled = book::perspective_d3d_left(angle, aspect, n, f);
    for (auto& row : scaled) {
      for (double& entry : row) entry *= 0.37;  // a multiple of the matrix is the same map
    }
    check(scaled, false, false);
  }
}

TEST_CASE(
    "parallel projections: the window, the planes, and the gaze that follows from the depth") {
  const ProjectionFacts gl = projection_facts(given(book::ortho_gl(-2, 6, -1, 3, 0.5, 20)));
  REQUIRE(gl.kind == ProjectionKind::kParallel);
  CHECK(gl.looks_down_minus_z);
  CHECK((-1 - gl.centre.x) / gl.scale.x == Approx(-2).epsilon(1e-6));
  CHECK((1 - gl.centre.y) / gl.scale.y == Approx(3).epsilon(1e-6));
  CHECK(gl.minus_one_to_one.near == Approx(0.5).epsilon(1e-5));
  CHECK(gl.minus_one_to_one.far == Approx(20).epsilon(1e-5));
  const ProjectionFacts d3d = projection_facts(given(book::ortho_d3d(-2, 6, -1, 3, 0.5, 20, true)));
  CHECK_FALSE(d3d.looks_down_minus_z);
  CHECK(d3d.zero_to_one.near == Approx(0.5).epsilon(1e-5));
  CHECK(d3d.zero_to_one.far == Approx(20).epsilon(1e-5));
}

TEST_CASE("off-centre frusta, infinite far planes and reversed depth are seen as such") {
  const ProjectionFacts skewed = projection_facts(given(book::frustum_gl(-1, 3, -1, 1, 2, 50)));
  CHECK(skewed.off_centre());
  CHECK(skewed.centre.x ==
        Approx(-0.5).epsilon(1e-6));  // the gaze meets the picture left of its centre
  const ProjectionFacts reversed =
      projection_facts(given(book::perspective_reversed_infinite(1, 1.5, 0.1)));
  CHECK(reversed.depth_reversed());
  CHECK(reversed.zero_to_one.possible);
  CHECK(reversed.zero_to_one.near == Approx(0.1).epsilon(1e-6));
  CHECK(std::isinf(reversed.zero_to_one.far));
}

TEST_CASE(
    "either range of depth can be read from any matrix; the rounder planes are the likelier") {
  const ProjectionFacts gl = projection_facts(given(book::perspective_gl(1, 1, 0.1, 100)));
  CHECK(gl.zero_to_one.possible);  // with near 0.1998 and far 100
  CHECK(gl.minus_one_to_one.possible);
  const DepthReading* range = gl.likely_range();
  REQUIRE(range);
  CHECK(range->from_minus_one);
  for (const auto& [n, f] : {std::pair{0.1, 1000.0}, {0.01, 50.0}, {1.0, 5000.0}, {0.3, 77.0}}) {
    CAPTURE(n, f);
    const ProjectionFacts a = projection_facts(given(book::perspective_gl(1, 1, n, f)));
    REQUIRE(a.likely_range());
    CHECK(a.likely_range()->from_minus_one);
    const ProjectionFacts b = projection_facts(given(book::perspective_d3d_left(1, 1, n, f)));
    REQUIRE(b.likely_range());
    CHECK_FALSE(b.likely_range()->from_minus_one);
  }
  // The planes are 1 and 3 for one range, 3/2 and 3 for the other: both are round.
  const ProjectionFacts close = projection_facts(given(book::perspective_gl(1, 1, 1, 3)));
  CHECK(close.likely_range() == nullptr);
}

TEST_CASE("a product of projection and view is taken apart") {
  Random random(413);
  for (int i = 0; i < 500; ++i) {
    const auto eye = random_place(random, 9), target = random_place(random, 1);
    const Rows view = book::look_at_right(eye, target, {0, 1, 0});
    const Rows projection = i % 2 == 0 ? book::perspective_gl(0.8, 1.5, 0.5, 60)
                                       : book::perspective_d3d_left(0.8, 1.5, 0.5, 60);
    const auto parts = factor_projection(given(book::product(projection, view)));
    CAPTURE(i);
    REQUIRE(parts);
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        CHECK(std::abs(parts->view.m[column][row] - view[std::size_t(row)][std::size_t(column)]) <
              1e-4);
      }
    }
    const ProjectionFacts p = projection_facts(parts->projection);
    CHECK(p.looks_down_minus_z == (i % 2 == 0));
    CHECK(p.fovy_degrees == Approx(degrees_from_radians(0.8)).epsilon(1e-4));
  }
  CHECK_FALSE(factor_projection(given(book::perspective_gl(1, 1, 1, 10))));
}

TEST_CASE("the dialect is guessed from round planes, and from what points down") {
  const auto guess = [](const Rows& m) {
    return std::string(guess_dialect(given(m)).dialect->name);
  };
  CHECK(guess(book::perspective_gl(1, 1.5, 0.1, 100)) == "opengl");
  CHECK(guess(book::perspective_d3d_left(1, 1.5, 0.1, 100)) == "d3d");
  CHECK(guess(book::perspective_vulkan(1, 1.5, 0.1, 100)) == "vulkan");
  CHECK(guess(book::perspective_reversed_infinite(1, 1.5, 0.1)) == "reversed");
  CHECK(guess(book::ortho_gl(-1, 1, -1, 1, 0.1, 100)) == "opengl");
  CHECK(guess(book::ortho_d3d(-1, 1, -1, 1, 0.1, 100, true)) == "d3d");
  CHECK(guess(book::perspective_gl(1, 1, 1, 3)) == "opengl");  // undecided: the default
  const Rows view = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  CHECK(guess(book::product(book::perspective_d3d_right(1, 1.5, 0.5, 20), view)) == "d3d");
}

TEST_CASE(
    "degrees taken for radians are found for every whole angle, round angles are never blamed") {
  int found = 0;
  for (int degrees = 4; degrees < 180; ++degrees) {
    const ProjectionFacts slipped =
        projection_facts(given(book::perspective_gl(degrees, 1.5, 0.1, 100)));
    const ProjectionFacts right =
        projection_facts(given(book::perspective_gl(book::radians(degrees), 1.5, 0.1, 100)));
    CAPTURE(degrees);
    CHECK_FALSE(right.degrees_taken_as_radians);
    CHECK_FALSE(right.radians_taken_as_degrees);
    CHECK(slipped.degrees_taken_as_radians == std::optional<int>(degrees));
    found += slipped.degrees_taken_as_radians.has_value();
  }
  CHECK(found == 176);
}

TEST_CASE("near and far exchanged are no dialect of their own") {
  const auto guess = [](const Rows& m) {
    return std::string(guess_dialect(given(m)).dialect->name);
  };
  CHECK(guess(book::perspective_gl(1, 1.5, 100, 0.1)) == "opengl");
  CHECK(guess(book::perspective_d3d_right(1, 1.5, 100, 0.1)) ==
        "reversed");  // the same as reversed depth
}

TEST_CASE(
    "E13: the angle in half of the window is found for every whole angle, round ones are never "
    "blamed") {
  for (int degrees = 5; degrees < 175; ++degrees) {
    for (const double aspect : {1.0, 4.0 / 3, 16.0 / 9, 2.35}) {
      Rows m = book::perspective_gl(book::radians(degrees), aspect, 0.1, 100);
      CAPTURE(degrees, aspect);
      CHECK_FALSE(projection_facts(given(m)).degrees_of_half_window);
      m[0][0] /= 2;
      m[1][1] /= 2;
      const ProjectionFacts halved = projection_facts(given(m));
      // At 90 degrees the scale is 1/2, which may as well have been typed on purpose.
      if (degrees != 90) CHECK(halved.degrees_of_half_window == std::optional<int>(degrees));
    }
  }
}

TEST_CASE("one eye of a stereo pair: where it stands, and where it sees no parallax (S0-11, E2)") {
  Random random(415);
  for (int i = 0; i < 500; ++i) {
    const double s = random.between(-0.1, 0.1), f = random.between(0.5, 20);
    Rows skew = book::identity();
    skew[0][2] = s / f;  // the sign for an eye that looks down -z
    skew[0][3] = s;
    const Rows m = book::product(book::perspective_gl(1, 1.5, 0.1, 100), skew);
    const ProjectionFacts p = projection_facts(given(m));
    CAPTURE(i, s, f);
    REQUIRE(p.kind == ProjectionKind::kPerspective);
    CHECK(-p.shift.x / p.scale.x == Approx(-s).epsilon(1e-5));
    REQUIRE(p.without_parallax());
    CHECK(*p.without_parallax() == Approx(f).epsilon(1e-5));
    CHECK(p.minus_one_to_one.near == Approx(0.1).epsilon(1e-5));
  }
  CHECK_FALSE(projection_facts(given(book::frustum_gl(-1, 3, -1, 1, 2, 50))).without_parallax());
}

TEST_CASE("a 1 in the corner is the identity's where the planes are rounder without it") {
  Rows leftover = book::perspective_gl(1, 1.5, 0.1, 100);
  leftover[3][3] = 1;
  CHECK(has_corner_left_over(given(leftover)));
  CHECK(projection_facts(projection_part(given(leftover))).minus_one_to_one.near ==
        Approx(0.1).epsilon(1e-5));
  const Rows stepped_back =
      book::product(book::perspective_gl(1, 1.5, 0.1, 100), book::translation(0, 0, -1));
  CHECK(stepped_back[3][3] == 1);
  CHECK_FALSE(has_corner_left_over(given(stepped_back)));
  CHECK(projection_facts(projection_part(given(stepped_back))).minus_one_to_one.near ==
        Approx(0.1).epsilon(1e-5));
}

}  // namespace
}  // namespace glassbox
