// What a matrix is, and what is wrong with it: textbook matrices are read back as what they were made from, planted slips
// are named, and correct sets raise no alarm.
#include <glassbox/pipeline/matrices/matrix_facts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/matrices/decimal.h>
#include <glassbox/pipeline/matrices/dialect_guess.h>
#include <glassbox/pipeline/matrices/findings.h>
#include <glassbox/pipeline/matrices/projection_factors.h>

#include "tests/pipeline/textbook.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace glassbox {
namespace {

namespace book = test::textbook;
using book::given;
using book::Rows;
using test::Random;

const ApiDialect& dialect(const std::string& name) {
  for (const ApiDialect& one : api_dialects()) {
    if (name == one.name) return one;
  }
  FAIL("no dialect " << name);
  return api_dialects().front();
}

MatrixSetup setup(const std::string& api, const Rows& model, const Rows& view,
                  const Rows& projection) {
  return {given(model), given(view), given(projection), dialect(api), std::nullopt, std::nullopt};
}

std::vector<std::string> ids(const std::vector<Finding>& findings, Severity at_least) {
  std::vector<std::string> found;
  for (const Finding& finding : findings) {
    if (finding.severity >= at_least) found.push_back(finding.id);
  }
  return found;
}

bool has(const std::vector<Finding>& findings, const std::string& id, Severity severity,
         const std::string& matrix = "") {
  return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) {
    return f.id == id && f.severity == severity && (matrix.empty() || f.matrix == matrix);
  });
}

book::Vector3 random_place(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

// ---- shapes ----

TEST_CASE("affine matrices are told apart by what they do") {
  const auto shape = [](const Rows& m) { return facts_of(given(m).m).shape; };
  CHECK(shape(book::identity()) == Shape::kIdentity);
  CHECK(shape(book::translation(1, 2, 3)) == Shape::kTranslation);
  CHECK(shape(book::turn_y(30)) == Shape::kRigid);
  CHECK(shape(book::product(book::translation(1, 2, 3), book::turn_x(200))) == Shape::kRigid);
  CHECK(shape(book::product(book::turn_y(30), book::scaling(2, 2, 2))) == Shape::kSimilarity);
  CHECK(shape(book::product(book::turn_y(30), book::scaling(1, 2, 3))) == Shape::kScaled);
  CHECK(shape(book::product(book::scaling(1, 2, 3), book::turn_y(30))) == Shape::kScaledAfter);
  CHECK(shape(book::product(book::turn_x(20), book::product(book::scaling(1, 2, 3),
                                                            book::turn_y(30)))) == Shape::kSheared);
  CHECK(shape(book::scaling(1, 1, 0)) == Shape::kFlat);
  CHECK(shape(book::perspective_gl(1, 1, 1, 10)) == Shape::kProjective);
  CHECK(shape(book::transposed(book::translation(1, 2, 3))) == Shape::kProjective);
  Rows broken = book::identity();
  broken[1][2] = std::numeric_limits<double>::quiet_NaN();
  CHECK(shape(broken) == Shape::kNotFinite);
  const auto entry = first_not_finite(given(broken).m);
  REQUIRE(entry);
  CHECK(entry->row == 1);
  CHECK(entry->column == 2);
}

TEST_CASE("rotation, scale, mirror and translation are read back") {
  const Rows m = book::product(book::translation(1, -2, 3),
                               book::product(book::turn_y(35), book::scaling(2, 3, 4)));
  const MatrixFacts facts = facts_of(given(m).m);
  REQUIRE(facts.rotation);
  CHECK(degrees_from_radians(facts.rotation->radians) == Approx(35).epsilon(1e-6));
  CHECK(facts.rotation->axis.y == Approx(1).epsilon(1e-6));
  CHECK(facts.scale.x == Approx(2).epsilon(1e-6));
  CHECK(facts.scale.z == Approx(4).epsilon(1e-6));
  CHECK(facts.translation == glm::dvec3(1, -2, 3));
  CHECK(facts.determinant == Approx(24).epsilon(1e-6));
  CHECK(facts.rank == 4);
  CHECK_FALSE(facts.mirror());
  const MatrixFacts mirrored = facts_of(given(book::scaling(-1, 1, 1)).m);
  CHECK(mirrored.mirror());
  CHECK(mirrored.shape == Shape::kRigid);
  CHECK_FALSE(mirrored.rigid());
  CHECK(mirrored.scale.x == -1);
}

TEST_CASE("rotations printed with few digits are rigid, to the digits they have") {
  Random random(410);
  for (int i = 0; i < 1000; ++i) {
    Rows view = book::look_at_right(random_place(random, 9), random_place(random, 1), {0, 1, 0});
    CHECK(facts_of(given(view).m).orthogonality < 0x1p-21);
    for (auto& row : view) {
      for (double& entry : row) entry = std::round(entry * 1e4) / 1e4;
    }
    const MatrixFacts facts = facts_of(given(view).m);
    CAPTURE(i, facts.orthogonality);
    CHECK(facts.rigid());
    CHECK(facts.orthogonality > 0x1p-21);  // it is seen, too
    CHECK(facts.orthogonality < 4e-4);     // 3 products off by 5e-5 each, twice
  }
}

TEST_CASE("rank is counted by what rounding to float leaves, not by the size of the entries") {
  CHECK(rank_of(glm::dmat4(1)) == 4);
  CHECK(rank_of(glm::dmat4(0)) == 0);
  CHECK(rank_of(given(book::perspective_gl(1, 1, 1e-6, 1e6)).m) == 4);
  CHECK(rank_of(given(book::scaling(1e-12, 1, 1e12)).m) == 4);
  // E15: diag(d, d, d, 0) and the row 0 0 1 0.
  CHECK(rank_of(given({{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 1, 0}}}).m) == 3);
  Random random(411);
  for (int i = 0; i < 500; ++i) {
    // A sum of two rows, rounded to float, in the place of a third.
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

// ---- projections ----

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
      // Within what the entries' rounding leaves open, to second order.
      CHECK(std::abs(r.near - n) <= 1.01 * r.near_uncertainty + 1e-12);
      CHECK(std::abs(r.far - f) <= 1.01 * r.far_uncertainty + 1e-12);
    };
    const double angle = book::radians(fovy);
    check(book::perspective_gl(angle, aspect, n, f), true, true);
    check(book::perspective_d3d_right(angle, aspect, n, f), true, false);
    check(book::perspective_d3d_left(angle, aspect, n, f), false, false);
    Rows scaled = book::perspective_d3d_left(angle, aspect, n, f);
    for (auto& row : scaled) {
      for (double& entry : row) entry *= 0.37;  // the same map
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
  const auto likely = [](const Rows& m) { return projection_facts(given(m)).likely_range(); };
  const ProjectionFacts gl = projection_facts(given(book::perspective_gl(1, 1, 0.1, 100)));
  CHECK(gl.zero_to_one.possible);  // near 0.1998, far 100
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
  // 1 and 3 for one, 3/2 and 3 for the other: nothing tells.
  CHECK(likely(book::perspective_gl(1, 1, 1, 3)) == nullptr);
}

TEST_CASE("a product of projection and view is taken apart") {
  Random random(413);
  for (int i = 0; i < 500; ++i) {
    const Rows view =
        book::look_at_right(random_place(random, 9), random_place(random, 1), {0, 1, 0});
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

// ---- correct sets ----

TEST_CASE("correct sets of matrices raise neither alarm nor hint, in any dialect") {
  Random random(414);
  const double nears[] = {0.01, 0.1, 0.5, 1}, fars[] = {10, 50, 100, 1000};
  const double angles[] = {30, 45, 60, 75, 90};
  for (int i = 0; i < 3000; ++i) {
    const bool round = i % 2 == 0;
    const double n = round ? nears[random.integer(0, 3)] : std::exp(random.between(-4, 1));
    const double f = round ? fars[random.integer(0, 3)] : n * std::exp(random.between(1, 8));
    const double angle =
        book::radians(round ? angles[random.integer(0, 4)] : random.between(5, 150));
    const double aspect = random.between(0.5, 2), h = random.between(0.1, 10), w = h * aspect;
    const book::Vector3 eye = random_place(random, 20), at = random_place(random, 5);
    const book::Vector3 up{0, 1, 0};
    const Rows right = book::look_at_right(eye, at, up), left = book::look_at_left(eye, at, up);
    const Rows model = book::product(
        book::translation(random.between(-3, 3), 0, 1),
        book::product(book::turn_y(random.between(-180, 180)), book::scaling(1, 2, 0.5)));
    const std::vector<std::pair<std::string, std::pair<Rows, Rows>>> sets{
        {"opengl", {right, book::perspective_gl(angle, aspect, n, f)}},
        {"opengl", {right, book::ortho_gl(-w, w, -h, h, n, f)}},
        {"opengl", {right, book::frustum_gl(-n * 0.4, n * 0.7, -n * 0.3, n * 0.5, n, f)}},
        {"d3d", {left, book::perspective_d3d_left(angle, aspect, n, f)}},
        {"d3d", {right, book::perspective_d3d_right(angle, aspect, n, f)}},
        {"d3d", {left, book::ortho_d3d(-w, w, -h, h, n, f, true)}},
        {"vulkan", {right, book::perspective_vulkan(angle, aspect, n, f)}},
        {"vulkan", {right, book::ortho_vulkan(-w, w, -h, h, n, f)}},
        {"metal", {right, book::perspective_d3d_right(angle, aspect, n, f)}},
        {"reversed", {right, book::perspective_reversed_infinite(angle, aspect, n)}},
        {"reversed", {right, book::perspective_d3d_right(angle, aspect, f, n)}},
        {"reversed", {right, book::ortho_d3d(-w, w, -h, h, f, n, false)}},
    };
    for (const auto& [api, matrices] : sets) {
      const auto findings = check_matrices(setup(api, model, matrices.first, matrices.second));
      CAPTURE(i, api, n, f, angle, ids(findings, Severity::kHint));
      CHECK(ids(findings, Severity::kHint).empty());
      // The world that each draws: look_at_left in a left-handed world, and so on.
      MatrixSetup known = setup(api, model, matrices.first, matrices.second);
      known.world = matrices.first == left ? Hand::kLeft : Hand::kRight;
      CHECK(world_drawn(known) == known.world);
      CHECK(ids(check_matrices(known), Severity::kAlarm).empty());
    }
  }
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
  CHECK(guess(book::perspective_gl(1, 1, 1, 3)) == "opengl");  // nothing tells
  const Rows view = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  CHECK(guess(book::product(book::perspective_d3d_right(1, 1.5, 0.5, 20), view)) == "d3d");
}

// ---- planted slips ----

struct Slipped {
  MatrixSetup set;
  const char* id;
  const char* matrix;
  Severity severity = Severity::kAlarm;
};

TEST_CASE("every planted slip is named, on the matrix that has it") {
  const Rows model = book::product(book::translation(1, 0, 2), book::turn_y(40));
  const Rows view = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const Rows projection = book::perspective_gl(book::radians(60), 1.5, 0.1, 100);
  const auto with = [&](const Rows& m, const Rows& v, const Rows& p, const char* api = "opengl") {
    return setup(api, m, v, p);
  };
  Rows leftover = projection;
  leftover[3][3] = 1;
  Rows upside_down = projection;
  upside_down[1][1] *= -1;
  Rows mirrored = projection;
  mirrored[0][0] *= -1;
  Rows broken = view;
  broken[0][1] = std::numeric_limits<double>::quiet_NaN();
  Rows rubbish = projection;
  rubbish[1][0] = rubbish[2][0] = 0.7;
  rubbish[3] = {0.3, 0.2, -1, 0.5};
  const Rows d3d = book::perspective_d3d_right(book::radians(60), 1.5, 0.1, 100);
  const Rows rank3{{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 1, 0}}};
  const std::vector<Slipped> slips{
      {with(book::transposed(model), view, projection), "transposed", "model"},
      {with(model, book::transposed(view), projection), "transposed", "view"},
      {with(model, view, book::transposed(projection)), "transposed", "projection"},
      {with(model, view, book::transposed(book::ortho_gl(-1, 3, -1, 1, 1, 9))), "transposed",
       "projection"},
      {with(model, projection, view), "exchanged", ""},
      {with(projection, view, projection), "is-a-projection", "model"},
      {with(model, view, view), "is-a-view", "projection"},
      {with(model, view, book::product(view, projection)), "factors-exchanged", "projection"},
      {with(book::product(book::scaling(1, 3, 1), book::turn_x(30)), view, projection),
       "scale-after-rotation", "model", Severity::kHint},
      {with(book::scaling(-1, 1, 1), view, projection), "mirror", "model", Severity::kHint},
      {with(book::scaling(1, 1, 0), view, projection), "singular", "model", Severity::kHint},
      {with(model, book::scaling(0, 1, 1), projection), "singular", "view"},
      {with(model, book::product(book::scaling(2, 2, 2), view), projection), "not-rigid", "view",
       Severity::kHint},
      {with(model, book::rigid_inverse(view), projection), "pose", "view", Severity::kHint},
      {with(model, broken, projection), "not-finite", "view"},
      {with(model, view, rank3), "depth-lost", "projection"},           // E15
      {with(model, view, d3d, "opengl"), "z-range", "projection"},      // E16
      {with(model, view, projection, "d3d"), "z-range", "projection"},  // E16
      {with(model, view, book::perspective_gl(60, 1.5, 0.1, 100)), "degrees-as-radians",
       "projection"},
      {with(model, view, book::perspective_gl(45, 1.5, 0.1, 100)), "degrees-as-radians",
       "projection"},
      {with(model, view, book::perspective_gl(book::radians(book::radians(60)), 1.5, 0.1, 100)),
       "radians-as-degrees", "projection"},
      {with(model, view, book::perspective_gl(1, 1.5, 100, 0.1)), "depth-direction", "projection"},
      {with(model, view, book::perspective_reversed_infinite(1, 1.5, 0.1), "d3d"),
       "depth-direction", "projection"},
      {with(model, view, d3d, "reversed"), "depth-direction", "projection"},
      {with(model, view, book::perspective_gl(1, 1.5, -0.1, 100)), "planes", "projection"},
      {with(model, view, leftover), "w-leftover", "projection"},
      {with(model, view, upside_down), "upside-down", "projection"},
      {with(model, view, d3d, "vulkan"), "upside-down", "projection", Severity::kHint},
      {with(model, view, mirrored), "mirrored", "projection"},
      {with(model, view, rubbish), "no-projection", "projection"},
      {with(model, view, book::product(projection, view)), "contains-view", "projection",
       Severity::kHint},
  };
  for (const Slipped& slip : slips) {
    const auto findings = check_matrices(slip.set);
    CAPTURE(slip.id, slip.matrix, ids(findings, Severity::kNote));
    CHECK(has(findings, slip.id, slip.severity, slip.matrix));
    for (const Finding& finding : findings) {
      CHECK_FALSE(finding.cause.empty());
      CHECK((finding.severity == Severity::kNote || !finding.remedy.empty()));
    }
  }
  // A projection alone may have a view in it.
  MatrixSetup alone = with(model, view, book::product(projection, view));
  alone.view = {};
  CHECK(has(check_matrices(alone), "contains-view", Severity::kNote, "projection"));
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

TEST_CASE("aspect ratios that do not fit the picture are explained") {
  const Rows view = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const auto cause = [&](double aspect, int width, int height) {
    MatrixSetup set =
        setup("opengl", book::identity(), view, book::perspective_gl(1, aspect, 0.1, 100));
    set.picture = glm::ivec2(width, height);
    for (const Finding& finding : check_matrices(set)) {
      if (std::string(finding.id) == "aspect") return finding.cause;
    }
    return std::string();
  };
  CHECK(cause(16.0 / 9, 1280, 720).empty());
  CHECK(cause(9.0 / 16, 1280, 720).find("height/width") != std::string::npos);
  CHECK(cause(1, 1280, 720).find("in integers is 1") != std::string::npos);
  CHECK(cause(1.5, 1280, 720).find("ellipses") != std::string::npos);
}

TEST_CASE("E7: a gaze turned to +z mirrors a right-handed world, and fits a left-handed one") {
  // S3.37 literally: a proper rotation that sends the gaze to +z and up to +y, for a projection with w = +z.
  const book::Vector3 eye{3, 2, 5}, gaze = book::unit({-3, -2, -5});
  const book::Vector3 up = book::unit(book::cross(book::cross(gaze, {0, 1, 0}), gaze));
  const book::Vector3 x = book::cross(up, gaze);  // right-handed axes: minus the picture's right
  MatrixSetup set = setup("d3d", book::identity(), book::from_axes(x, up, gaze, eye),
                          book::perspective_d3d_left(1, 1.5, 0.1, 100));
  CHECK(facts_of(set.view.m).rigid());
  CHECK(has(check_matrices(set), "world-hand", Severity::kNote));
  set.world = Hand::kRight;
  CHECK(has(check_matrices(set), "world-mirrored", Severity::kAlarm));
  set.world = Hand::kLeft;
  CHECK(ids(check_matrices(set), Severity::kHint) == std::vector<std::string>());
  // Its mirror, diag(-1, 1, 1, 1) V, draws right-handed worlds.
  const Rows mended = book::product(book::scaling(-1, 1, 1), book::from_axes(x, up, gaze, eye));
  set.view = given(mended);
  set.world = Hand::kRight;
  CHECK(ids(check_matrices(set), Severity::kAlarm) == std::vector<std::string>());
}

}  // namespace
}  // namespace glassbox
