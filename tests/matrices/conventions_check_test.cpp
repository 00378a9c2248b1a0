// Plants slips in textbook matrices: the change that undoes each must be among the reported ones,
// and first where the matrices can tell. If nothing is wrong, nothing is reported.
#include <glassbox/matrices/conventions_check.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>
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

// A camera, the points that it sees, and the numbers that its matrices are made from.
struct BookScene {
  book::Vector3 eye, at;
  double fovy = 1, aspect = 1.5, near = 0.1, far = 100;
  book::Vector3 model_offset;
  double model_turn = 0;
  std::vector<CheckedPoint> points;

  Rows model() const {
    return book::product(book::translation(model_offset[0], model_offset[1], model_offset[2]),
                         book::turn_y(model_turn));
  }
  Rows view() const { return book::look_at_right(eye, at, {0, 1, 0}); }
  Rows projection() const { return book::perspective_gl(fovy, aspect, near, far); }
};

const Viewport kWindow = window_rectangle(api_dialects().front(), 0, 0, 640, 480);

// Returns a scene whose object and camera are placed and turned by round numbers, as people type
// them, with four points well inside the picture.
BookScene random_scene(Random& random) {
  BookScene s;
  const auto round = [&](double size) { return std::round(random.between(-size, size) * 2) / 2; };
  do {
    s.eye = {round(9), 0.5 + std::abs(round(6)), round(9)};
    s.at = {round(1), 0, round(1)};
  } while (std::abs(s.eye[0] - s.at[0]) < 1 || std::abs(s.eye[2] - s.at[2]) < 1);
  s.fovy = book::radians(double(random.integer(3, 8)) * 10);
  s.model_offset = {round(2), 0, round(2)};
  s.model_turn = double(random.integer(1, 35)) * 5;
  const Rows from_world = book::rigid_inverse(s.view()),
             from_object = book::rigid_inverse(s.model());
  for (int k = 0; k < 4; ++k) {
    const double d = random.between(2, 12), half = 0.8 * d * std::tan(s.fovy / 2);
    const std::array<double, 4> eye{random.between(-half, half), random.between(-half, half), -d,
                                    1};
    std::array<double, 4> world{}, object{};
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t c = 0; c < 4; ++c) world[row] += from_world[row][c] * eye[c];
    }
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t c = 0; c < 4; ++c) object[row] += from_object[row][c] * world[c];
    }
    s.points.push_back({{object[0], object[1], object[2], 1}, std::nullopt});
  }
  return s;
}

MatrixSetup setup(const Rows& model, const Rows& view, const Rows& projection,
                  const std::string& api = "opengl") {
  return {given(model), given(view), given(projection), *find_dialect(api), std::nullopt,
          std::nullopt, {}};
}

TEST_CASE("where everything is right, every point is visible and no change is proposed") {
  Random random(420);
  for (int i = 0; i < 500; ++i) {
    const BookScene s = random_scene(random);
    const double n = s.near, f = s.far;
    const Rows left_view = book::look_at_left(s.eye, s.at, {0, 1, 0});
    const MatrixSetup sets[] = {
        setup(s.model(), s.view(), s.projection()),
        setup(s.model(), s.view(), book::perspective_d3d_right(s.fovy, s.aspect, n, f), "d3d"),
        setup(s.model(), left_view, book::perspective_d3d_left(s.fovy, s.aspect, n, f), "d3d"),
        setup(s.model(), s.view(), book::perspective_vulkan(s.fovy, s.aspect, n, f), "vulkan"),
        setup(s.model(), s.view(), book::perspective_reversed_infinite(s.fovy, s.aspect, n),
              "reversed"),
        setup(s.model(), s.view(), book::ortho_gl(-40, 40, -40, 40, 0.5, 50)),
        setup(s.model(), left_view, book::ortho_d3d(-40, 40, -40, 40, 0.5, 50, true), "d3d"),
        setup(s.model(), s.view(), book::ortho_vulkan(-40, 40, -40, 40, 0.5, 50), "vulkan"),
    };
    for (const MatrixSetup& set : sets) {
      const ConventionsReport report = check_conventions(set, kWindow, s.points);
      CAPTURE(i, set.dialect.name);
      CHECK(report.points == 4);
      CHECK(report.visible == 4);
      CHECK(report.behind_eye == 0);
      CHECK(report.alternatives.empty());
      CHECK(report.spoiling == 0);
    }
  }
}

// Counts how often a planted slip made the points vanish, was listed, and was listed first.
struct Score {
  int planted = 0, vanished = 0, listed = 0, first = 0, others = 0;
};

Score score_planted_mistake(const std::function<MatrixSetup(const BookScene&)>& slip,
                            SetupChange expected, int seed) {
  Random random{std::uint64_t(seed)};
  Score score;
  for (int i = 0; i < 400; ++i) {
    const BookScene s = random_scene(random);
    const ConventionsReport report = check_conventions(slip(s), kWindow, s.points);
    ++score.planted;
    if (report.visible == report.points) continue;
    ++score.vanished;
    const auto& all = report.alternatives;
    score.others += int(all.size());
    const auto is_it = [&](const Alternative& a) {
      return a.change == expected && !a.second && a.points == 4;
    };
    score.listed += std::any_of(all.begin(), all.end(), is_it);
    score.first += !all.empty() && is_it(all.front());
  }
  return score;
}

TEST_CASE("each planted slip is listed, and stands first where the matrices can tell") {
  struct PlantedMistake {
    const char* name;
    SetupChange undoes;
    std::function<MatrixSetup(const BookScene&)> slip;
    double first_share;  // share of cases in which it must be listed first
  };
  const auto rigid_part = [](Rows m) {
    m[0][3] = m[1][3] = m[2][3] = 0;
    return m;
  };
  const PlantedMistake slips[] = {
      {"all transposed", SetupChange::kTransposeAll,
       [](const BookScene& s) {
         return setup(book::transposed(s.model()), book::transposed(s.view()),
                      book::transposed(s.projection()));
       },
       1},
      {"model transposed", SetupChange::kTransposeModel,
       [](const BookScene& s) {
         return setup(book::transposed(s.model()), s.view(), s.projection());
       },
       0.99},
      {"view transposed", SetupChange::kTransposeView,
       [](const BookScene& s) {
         return setup(s.model(), book::transposed(s.view()), s.projection());
       },
       1},
      {"projection transposed", SetupChange::kTransposeProjection,
       [](const BookScene& s) {
         return setup(s.model(), s.view(), book::transposed(s.projection()));
       },
       1},
      {"E12: S4.5 times S4.18", SetupChange::kEyeHand,
       [](const BookScene& s) {
         return setup(s.model(), s.view(),
                      book::perspective_d3d_left(s.fovy, s.aspect, s.near, s.far), "d3d");
       },
       0.95},
      {"view scaled", SetupChange::kViewScale,
       [](const BookScene& s) {
         return setup(s.model(), book::product(book::scaling(0.01, 0.01, 0.01), s.view()),
                      s.projection());
       },
       0.9},
      {"view not inverted", SetupChange::kInvertView,
       [](const BookScene& s) {
         return setup(s.model(), book::rigid_inverse(s.view()), s.projection());
       },
       0.95},
      {"view T R for R T", SetupChange::kViewFactors,
       [&](const BookScene& s) {
         return setup(s.model(),
                      book::product(book::translation(-s.eye[0], -s.eye[1], -s.eye[2]),
                                    rigid_part(s.view())),
                      s.projection());
       },
       0.6},
      {"view translated by +eye", SetupChange::kViewOffsetSign,
       [&](const BookScene& s) {
         return setup(
             s.model(),
             book::product(rigid_part(s.view()), book::translation(s.eye[0], s.eye[1], s.eye[2])),
             s.projection());
       },
       0},
      {"model R T for T R", SetupChange::kModelFactorsBack,
       [](const BookScene& s) {
         return setup(book::product(book::turn_y(s.model_turn),
                                    book::translation(s.model_offset[0], 0, s.model_offset[2])),
                      s.view(), s.projection());
       },
       0},
      {"model inverted", SetupChange::kInvertModel,
       [](const BookScene& s) {
         return setup(book::rigid_inverse(s.model()), s.view(), s.projection());
       },
       0},
      {"model and view exchanged", SetupChange::kExchangeModelView,
       [](const BookScene& s) { return setup(s.view(), s.model(), s.projection()); }, 0},
      {"view and projection exchanged", SetupChange::kExchangeViewProjection,
       [](const BookScene& s) { return setup(s.model(), s.projection(), s.view()); }, 1},
      {"a left-handed parallel projection", SetupChange::kEyeHand,
       [](const BookScene& s) {
         return setup(s.model(), s.view(), book::ortho_d3d(-40, 40, -40, 40, 0.5, 50, true), "d3d");
       },
       0.9},
      {"degrees for radians", SetupChange::kDegrees,
       [](const BookScene& s) {
         return setup(
             s.model(), s.view(),
             book::perspective_gl(s.fovy * 180 / 3.14159265358979323846, s.aspect, s.near, s.far));
       },
       0.9},
      {"radians for degrees", SetupChange::kRadians,
       [](const BookScene& s) {
         return setup(s.model(), s.view(),
                      book::perspective_gl(book::radians(s.fovy), s.aspect, s.near, s.far));
       },
       0.9},
  };
  int seed = 430;
  std::printf("slips planted 400 times each, with four points:\n");
  for (const PlantedMistake& slip : slips) {
    const Score score = score_planted_mistake(slip.slip, slip.undoes, seed++);
    std::printf("  %-30s vanished %3d, listed %3d, first %3d; %.1f changes would do\n", slip.name,
                score.vanished, score.listed, score.first,
                double(score.others) / std::max(1, score.vanished));
    CAPTURE(slip.name, score.vanished, score.listed, score.first);
    CHECK(score.vanished > 20);
    CHECK(score.listed == score.vanished);
    CHECK(score.first >= slip.first_share * score.vanished);
  }
}

// Points in a ball around the place that the camera looks at.
std::vector<CheckedPoint> points_around(const book::Vector3& middle, double radius, int count,
                                        Random& random) {
  std::vector<CheckedPoint> points;
  for (int i = 0; i < count; ++i) {
    const book::Vector3 off = random_place(random, radius);
    points.push_back(
        {{middle[0] + off[0], middle[1] + off[1], middle[2] + off[2], 1}, std::nullopt});
  }
  return points;
}

TEST_CASE("exchanged arguments of look-at come first where the points are around the target") {
  Random random(443);
  int vanished = 0, first = 0;
  for (int i = 0; i < 400; ++i) {
    const BookScene s = random_scene(random);
    const bool left = i % 2 == 1;
    const Rows view = left ? book::look_at_left(s.at, s.eye, {0, 1, 0})
                           : book::look_at_right(s.at, s.eye, {0, 1, 0});
    const MatrixSetup set =
        left ? setup(book::identity(), view,
                     book::perspective_d3d_left(s.fovy, s.aspect, s.near, s.far), "d3d")
             : setup(book::identity(), view, s.projection());
    const auto points = points_around(s.at, 0.5, 8, random);
    const ConventionsReport report = check_conventions(set, kWindow, points);
    if (report.visible == report.points) continue;
    ++vanished;
    first += !report.alternatives.empty() && report.alternatives.front().points == 8 &&
             report.alternatives.front().change == SetupChange::kSwapLookAt;
  }
  CAPTURE(vanished, first);
  CHECK(vanished > 350);
  CHECK(first >= vanished * 9 / 10);
}

TEST_CASE("the point at which the eye itself stands is explained by exchanged arguments") {
  const Rows view = book::look_at_right({0, 0, 0}, {3, 2, 5}, {0, 1, 0});
  const CheckedPoint point;
  const ConventionsReport report = check_conventions(
      setup(book::identity(), view, book::perspective_gl(1, 1.5, 0.1, 100)), kWindow, {&point, 1});
  CHECK(report.visible == 0);
  REQUIRE_FALSE(report.alternatives.empty());
  CHECK(report.alternatives.front().change == SetupChange::kSwapLookAt);
}

TEST_CASE("a singular matrix is never inverted") {
  Random random(444);
  for (int i = 0; i < 100; ++i) {
    const BookScene s = random_scene(random);
    Rows model = s.model(), view = s.view();
    (i % 2 == 0 ? model : view)[3] = {0, 0, 0, 0};
    const ConventionsReport report =
        check_conventions(setup(model, view, s.projection()), kWindow, s.points);
    for (const Alternative& one : report.alternatives) {
      CAPTURE(i, one.what);
      CHECK(one.change != (i % 2 == 0 ? SetupChange::kInvertModel : SetupChange::kInvertView));
      CHECK(one.second != (i % 2 == 0 ? SetupChange::kInvertModel : SetupChange::kInvertView));
    }
  }
}

TEST_CASE("E16: a point that OpenGL shows and Direct3D clips is brought back by the other range") {
  const Rows view = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const book::Vector3 gaze = book::unit({-3, -2, -5});
  // The point is 0.15 in front of the eye: farther than near = 0.1, but nearer than 0.1998.
  const CheckedPoint point{{3 + 0.15 * gaze[0], 2 + 0.15 * gaze[1], 5 + 0.15 * gaze[2], 1}, {}};
  MatrixSetup set = setup(book::identity(), view, book::perspective_gl(1, 1.5, 0.1, 100), "d3d");
  const ConventionsReport report = check_conventions(set, kWindow, {&point, 1});
  CHECK(report.visible == 0);
  REQUIRE_FALSE(report.alternatives.empty());
  CHECK(report.alternatives.front().change == SetupChange::kDepthRange);
  REQUIRE_FALSE(report.alternatives.front().reasons.empty());
  CHECK(report.alternatives.front().reasons.front().find("0.1 and far 100") != std::string::npos);
}

TEST_CASE("E12: that every w is negative is a reason, and the count is given") {
  Random random(440);
  const BookScene s = random_scene(random);
  const MatrixSetup set = setup(s.model(), s.view(),
                                book::perspective_d3d_left(s.fovy, s.aspect, s.near, s.far), "d3d");
  const ConventionsReport report = check_conventions(set, kWindow, s.points);
  CHECK(report.behind_eye == 4);
  REQUIRE_FALSE(report.alternatives.empty());
  const Alternative& first = report.alternatives.front();
  CHECK(first.change == SetupChange::kEyeHand);
  CHECK(first.remedy.find("handedness is mixed (E12)") != std::string::npos);
  REQUIRE_FALSE(first.reasons.empty());
  CHECK(first.reasons.front().find("every w is negative (4 of 4)") != std::string::npos);
}

TEST_CASE("two slips at once are found together") {
  Random random(441);
  int found = 0, tried = 0;
  for (int i = 0; i < 100; ++i) {
    const BookScene s = random_scene(random);
    const MatrixSetup set =
        setup(s.model(), book::transposed(s.view()),
              book::perspective_d3d_left(s.fovy, s.aspect, s.near, s.far), "d3d");
    const ConventionsReport report = check_conventions(set, kWindow, s.points);
    if (report.visible > 0 || report.alternatives.empty() || !report.alternatives.front().second)
      continue;
    ++tried;
    const Alternative& first = report.alternatives.front();
    found += std::set{first.change, *first.second} ==
             std::set{SetupChange::kTransposeView, SetupChange::kEyeHand};
  }
  CAPTURE(found, tried);
  CHECK(tried > 30);
  CHECK(found > tried * 9 / 10);
}

TEST_CASE("the evidence of a second slip is taken from the matrices in which it shows") {
  Random random(442);
  int found = 0;
  for (int i = 0; i < 400; ++i) {
    const BookScene s = random_scene(random);
    const auto degrees = std::lround(s.fovy / book::radians(1));
    const Rows slipped = book::perspective_gl(double(degrees), s.aspect, s.near, s.far);
    const MatrixSetup set = setup(s.model(), s.view(), book::transposed(slipped));
    const ConventionsReport report = check_conventions(set, kWindow, s.points);
    const std::string angle = "half of " + std::to_string(degrees) + " radians";
    for (const Alternative& one : report.alternatives) {
      if (one.change != SetupChange::kDegrees && one.second != SetupChange::kDegrees) continue;
      ++found;
      CAPTURE(i, degrees, one.reasons);
      CHECK(std::any_of(one.reasons.begin(), one.reasons.end(), [&](const std::string& reason) {
        return reason.find(angle) != std::string::npos;
      }));
    }
  }
  CHECK(found > 50);
}

TEST_CASE(
    "with the pixel where it is expected, mirrors and windows that count from the other edge "
    "show") {
  const Rows view = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const Rows projection = book::perspective_gl(1, 640.0 / 480, 0.1, 100);
  CheckedPoint point{{1, 0.5, -1, 1}, {}};
  const MatrixSetup set = setup(book::identity(), view, projection);
  const ConventionsReport seen = check_conventions(set, kWindow, {&point, 1});
  CHECK(seen.visible == 1);

  // The point's position by a second computation: (P V x) / w.
  const Rows both = book::product(projection, view);
  const auto row = [&](std::size_t r) {
    return both[r][0] * 1 + both[r][1] * 0.5 + both[r][2] * -1 + both[r][3];
  };
  const double x = (row(0) / row(3) + 1) * 320, y = (row(1) / row(3) + 1) * 240;
  const auto expecting = [&](double at_x, double at_y) {
    point.expected = glm::dvec2(at_x, at_y);
    return check_conventions(set, kWindow, {&point, 1});
  };
  CHECK(expecting(x + 1, y - 1).visible == 1);
  CHECK(expecting(x + 3, y).visible == 0);
  const ConventionsReport turned = expecting(x, 480 - y);
  CHECK(turned.visible == 0);
  REQUIRE(turned.alternatives.size() == 1);
  CHECK(turned.alternatives.front().change == SetupChange::kFlipY);
  const ConventionsReport mirrored = expecting(640 - x, y);
  REQUIRE(mirrored.alternatives.size() == 1);
  CHECK(mirrored.alternatives.front().change == SetupChange::kFlipX);
  REQUIRE(mirrored.alternatives.front().window);
  CHECK(mirrored.alternatives.front().window->x == Approx(640 - x));
}

TEST_CASE("a corner left over from the identity is found by the pixel that was expected") {
  const Rows view = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const Rows right = book::perspective_gl(1, 1.5, 0.1, 100);
  Rows leftover = right;
  leftover[3][3] = 1;
  CheckedPoint point{{1, 1, -1, 1}, {}};
  const Rows both = book::product(right, view);
  const auto row = [&](std::size_t r) { return both[r][0] + both[r][1] - both[r][2] + both[r][3]; };
  point.expected = glm::dvec2((row(0) / row(3) + 1) * 320, (row(1) / row(3) + 1) * 240);
  const ConventionsReport report =
      check_conventions(setup(book::identity(), view, leftover), kWindow, {&point, 1});
  CHECK(report.visible == 0);
  REQUIRE(report.alternatives.size() == 1);
  CHECK(report.alternatives.front().change == SetupChange::kClearCorner);
}

TEST_CASE("changes that spoil a sound matrix are counted, not proposed") {
  Random random(442);
  int spoiling = 0;
  for (int i = 0; i < 300; ++i) {
    BookScene s = random_scene(random);
    for (CheckedPoint& point : s.points) {
      for (int k = 0; k < 3; ++k) point.object[k] = random.between(-8, 8);
    }
    const ConventionsReport report = check_conventions(setup(s.model(), s.view(), s.projection()),
                                                       kWindow, {s.points.data(), 1});
    spoiling += report.spoiling;
    for (const Alternative& a : report.alternatives) {
      CAPTURE(i, a.what);
      CHECK(a.change != SetupChange::kTransposeView);
      // The transpose of a mere rotation is a sound matrix.
      const bool moves = s.model_offset[0] != 0 || s.model_offset[2] != 0;
      CHECK((a.change != SetupChange::kTransposeModel || !moves));
      CHECK(a.change != SetupChange::kTransposeAll);
    }
  }
  CHECK(spoiling > 10);
}

TEST_CASE("NaN and infinity in the matrices or the point are no visible points") {
  MatrixSetup set = setup(book::identity(), book::identity(), book::perspective_gl(1, 1, 0.1, 100));
  set.view.m[1][2] = std::nan("");
  const CheckedPoint point{{0, 0, -5, 1}, {}};
  const ConventionsReport report = check_conventions(set, kWindow, {&point, 1});
  CHECK(report.visible == 0);
  CHECK(report.behind_eye == 0);
}

}  // namespace
}  // namespace glassbox
