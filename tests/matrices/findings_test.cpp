// Findings about wrong matrices: planted slips are named, and correct sets raise no alarm.
#include <glassbox/matrices/findings.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glassbox/base/random.h>
#include "tests/matrices/textbook.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

namespace book = test::textbook;
using book::given;
using book::random_place;
using book::Rows;

MatrixSetup setup(const std::string& api, const Rows& model, const Rows& view,
                  const Rows& projection) {
  return {given(model), given(view), given(projection), *find_dialect(api), std::nullopt,
          std::nullopt, {}};
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
    const double x = random.between(-3, 3), turn = random.between(-180, 180);
    const Rows model = book::product(book::translation(x, 0, 1),
                                     book::product(book::turn_y(turn), book::scaling(1, 2, 0.5)));
    Rows eye_of_a_pair = book::identity();
    eye_of_a_pair[0][3] = random.between(-0.1, 0.1);
    eye_of_a_pair[0][2] = eye_of_a_pair[0][3] / random.between(1, 10);
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
        {"opengl",
         {right, book::product(book::perspective_gl(angle, aspect, n, f), eye_of_a_pair)}},
        {"reversed", {right, book::perspective_reversed_infinite(angle, aspect, n)}},
        {"reversed", {right, book::perspective_d3d_right(angle, aspect, f, n)}},
        {"reversed", {right, book::ortho_d3d(-w, w, -h, h, f, n, false)}},
    };
    for (const auto& [api, matrices] : sets) {
      const auto findings = check_matrices(setup(api, model, matrices.first, matrices.second));
      CAPTURE(i, api, n, f, angle, ids(findings, Severity::kHint));
      CHECK(ids(findings, Severity::kHint).empty());
      // The world that each set is made for: look_at_left for a left-handed one, and so on.
      MatrixSetup known = setup(api, model, matrices.first, matrices.second);
      known.world = matrices.first == left ? Handedness::kLeft : Handedness::kRight;
      CHECK(drawn_handedness(known) == known.world);
      CHECK(ids(check_matrices(known), Severity::kAlarm).empty());
    }
  }
}

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
  const auto without_last_row = [](Rows m) {
    m[3] = {0, 0, 0, 0};
    return m;
  };
  Rows offset_not_rotated = view;
  offset_not_rotated[0][3] = -3, offset_not_rotated[1][3] = -2, offset_not_rotated[2][3] = -5;
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
      {with(model, view, book::product(projection, projection)), "projection-twice", "projection"},
      {with(without_last_row(model), view, projection), "singular", "model"},
      {with(model, without_last_row(view), projection), "singular", "view"},
      {with(model, view, without_last_row(projection)), "singular", "projection"},
      {with(model, offset_not_rotated, projection), "offset-not-rotated", "view", Severity::kHint},
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
  // If only a projection is given, it may contain a view, which is factored out.
  MatrixSetup alone = with(model, view, book::product(projection, view));
  alone.view = {};
  CHECK(has(check_matrices(alone), "contains-view", Severity::kNote, "projection"));
}

TEST_CASE("a projection times itself is told from a projection times a view") {
  Random random(415);
  for (int i = 0; i < 1000; ++i) {
    const double n = std::exp(random.between(-4, 1)), f = n * std::exp(random.between(1, 8));
    const double angle = book::radians(random.between(20, 120)), aspect = random.between(0.5, 2);
    const auto eye = random_place(random, 20), target = random_place(random, 5);
    const Rows view = book::look_at_right(eye, target, {0, 1, 0});
    const std::vector<std::pair<std::string, Rows>> projections{
        {"opengl", book::perspective_gl(angle, aspect, n, f)},
        {"opengl", book::frustum_gl(-n * 0.4, n * 0.7, -n * 0.3, n * 0.5, n, f)},
        {"d3d", book::perspective_d3d_left(angle, aspect, n, f)},
        {"vulkan", book::perspective_vulkan(angle, aspect, n, f)},
        {"reversed", book::perspective_reversed_infinite(angle, aspect, n)},
    };
    for (const auto& [api, projection] : projections) {
      CAPTURE(i, api, n, f);
      const Rows twice = book::product(projection, projection);
      // The third row of P P for reversed infinite depth is that of depth without an offset.
      CHECK(has(check_matrices(setup(api, book::identity(), view, twice)), "projection-twice",
                Severity::kAlarm) == (api != "reversed"));
      for (const Rows& other : {view, book::translation(0, 0, -random.between(0.5, 20))}) {
        const auto findings =
            check_matrices(setup(api, book::identity(), view, book::product(projection, other)));
        CHECK_FALSE(has(findings, "projection-twice", Severity::kAlarm));
      }
    }
  }
}

TEST_CASE("scaled and sheared views are told apart") {
  const Rows view = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const Rows projection = book::perspective_gl(1, 1.5, 0.1, 100);
  Rows shear = book::identity();
  shear[0][1] = 1;
  const std::pair<Rows, const char*> cases[] = {
      {book::product(book::scaling(100, 100, 100), view),
       "perpendicular, but they are scaled by 100"},
      {book::product(view, book::scaling(0.01, 0.01, 0.01)), "scaled by 0.01"},
      {book::product(book::scaling(1, 1, 2), view), "are scaled by (1, 1, 2)"},
      {book::product(view, book::scaling(1, 3, 1)), "are scaled by (1, 3, 1)"},
      {book::product(shear, view), "the angles between them are 45, 90 and 90 degrees"},
  };
  for (const auto& [scaled, words] : cases) {
    std::string cause;
    for (const Finding& finding :
         check_matrices(setup("opengl", book::identity(), scaled, projection))) {
      if (std::string(finding.id) == "not-rigid") cause = finding.cause;
    }
    CAPTURE(words, cause);
    CHECK(cause.find(words) != std::string::npos);
  }
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
  // The matrix of S3.37 as written: a proper rotation that turns the gaze to +z and up to +y, for a
  // projection with w = +z.
  const book::Vector3 eye{3, 2, 5}, gaze = book::unit({-3, -2, -5});
  const book::Vector3 up = book::unit(book::cross(book::cross(gaze, {0, 1, 0}), gaze));
  // right-handed axes: x is the opposite of the picture's right
  const book::Vector3 x = book::cross(up, gaze);
  MatrixSetup set = setup("d3d", book::identity(), book::from_axes(x, up, gaze, eye),
                          book::perspective_d3d_left(1, 1.5, 0.1, 100));
  CHECK(matrix_facts(set.view.m).rigid());
  CHECK(has(check_matrices(set), "world-hand", Severity::kNote));
  set.world = Handedness::kRight;
  CHECK(has(check_matrices(set), "world-mirrored", Severity::kAlarm));
  set.world = Handedness::kLeft;
  CHECK(ids(check_matrices(set), Severity::kHint) == std::vector<std::string>());
  // Its mirror image, diag(-1, 1, 1, 1) V, draws right-handed worlds.
  const Rows mended = book::product(book::scaling(-1, 1, 1), book::from_axes(x, up, gaze, eye));
  set.view = given(mended);
  set.world = Handedness::kRight;
  CHECK(ids(check_matrices(set), Severity::kAlarm) == std::vector<std::string>());
}

}  // namespace
}  // namespace glassbox
