#include <tests/pipeline/stereo/stereo_cases.h>

#include <cmath>
#include <cstring>
#include <string>

#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {
namespace {

using test::kInfinity;
using test::view_of;

bool same_bits(float a, float b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST_CASE("the eyes' matrices are the slide's, exactly where numbers have few bits (S0-11)") {
  const View centre = view_of(FrustumLens{-0.25, 0.75, -0.5, 0.5, 0.5, 8.0});  // a = 1, b = 1/2
  const StereoPair pair{0.25, 4};
  const View left = eye_view(centre, pair, Side::kLeft);
  const View right = eye_view(centre, pair, Side::kRight);
  CHECK(left.clip_from_eye.at(0, 0) == 1);
  CHECK(left.clip_from_eye.at(0, 2) == 0.5 + 0.0625);
  CHECK(left.clip_from_eye.at(0, 3) == 0.25);
  CHECK(right.clip_from_eye.at(0, 2) == 0.5 - 0.0625);
  CHECK(right.clip_from_eye.at(0, 3) == -0.25);
  for (int row = 1; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      CAPTURE(row, column);
      CHECK(left.clip_from_eye.at(row, column) == centre.clip_from_eye.at(row, column));
      CHECK(right.clip_from_eye.at(row, column) == centre.clip_from_eye.at(row, column));
    }
  }
  CHECK(left.eye_from_world == centre.eye_from_world);
}

TEST_CASE(
    "y, z and w of every clip vertex have the same bits for both eyes and the centre (S0-03, "
    "S0-07)") {
  Random random(70);
  int differing_x = 0;
  for (int i = 0; i < 2000; ++i) {
    const View centre = test::random_view(random, test::random_pose(random));
    const StereoPair pair = test::random_pair(random, centre);
    REQUIRE(check_pair(centre, pair));
    Transform<World, Object> world_from_object;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column)
        world_from_object.at(row, column) = random.between(-2, 2);
    }
    const auto clip_from_object = [&](const View& view) {
      return round_to_float(view.clip_from_eye * view.eye_from_world * world_from_object);
    };
    const auto at_centre = clip_from_object(centre);
    const auto at_left = clip_from_object(eye_view(centre, pair, Side::kLeft));
    const auto at_right = clip_from_object(eye_view(centre, pair, Side::kRight));
    for (int vertex = 0; vertex < 100; ++vertex) {
      const Point<Object> p{float(random.between(-9, 9)), float(random.between(-9, 9)),
                            float(random.between(-9, 9))};
      const Point<Clip> c = at_centre * p, l = at_left * p, r = at_right * p;
      const bool same = same_bits(l.y, r.y) && same_bits(l.z, r.z) && same_bits(l.w, r.w) &&
                        same_bits(l.y, c.y) && same_bits(l.z, c.z) && same_bits(l.w, c.w);
      if (!same) {
        CAPTURE(i, vertex, p.x, p.y, p.z);
        CHECK(same);
      }
      differing_x += l.x != r.x ? 1 : 0;
    }
  }
  CHECK(differing_x > 199000);  // the two views differ
}

TEST_CASE(
    "a window's plane is drawn alike for both eyes: in double snapped alike, in float within a "
    "subpixel (C-70, S0-09)") {
  Random random(71);
  const auto snapped = [](double px) { return std::floor(px * 256 + 0.5); };
  double widest = 0;
  int moved_in_float = 0, vertices = 0;
  const auto compare = [&](const View& centre, const StereoPair& pair) {
    const View left = eye_view(centre, pair, Side::kLeft);
    const View right = eye_view(centre, pair, Side::kRight);
    const auto left_clip = round_to_float(left.clip_from_eye);
    const auto right_clip = round_to_float(right.clip_from_eye);
    for (int i = 0; i < 100; ++i) {
      const Point<Eye, double> eye = test::random_seen(random, centre, pair.window);
      const double xl = test::screen_of(left, test::world_of(eye)).x;
      const double xr = test::screen_of(right, test::world_of(eye)).x;
      widest = std::max(widest, std::abs(xl - xr));
      CAPTURE(pair.half_separation, pair.window, eye.x, eye.y, xl, xr);
      if (snapped(xl) != snapped(xr)) CHECK(snapped(xl) == snapped(xr));

      // In float, the vertex is rounded to a place beside the window's plane and has the parallax
      // of that place.
      const Point<Eye> vertex{float(eye.x), float(eye.y), float(eye.z)};
      const auto x_of = [&](const Transform<Clip, Eye, float>& m) {
        return to_screen(divide(m * vertex), centre.viewport).position.x;
      };
      const double apart = snapped(double(x_of(left_clip))) - snapped(double(x_of(right_clip)));
      if (std::abs(apart) > 1) CHECK(std::abs(apart) <= 1);
      moved_in_float += apart != 0 ? 1 : 0;
      ++vertices;
    }
  };
  compare(view_of(PerspectiveLens{0.8, 0.1, {}}), {0.03, 10});  // the numbers of C-70
  for (int i = 0; i < 1000; ++i) {
    const View centre = test::random_view(random);
    compare(centre, test::random_pair(random, centre));
  }
  WARN("C-70: parallax in the window's plane at most " << widest << " px in double; in float "
                                                       << moved_in_float << " of " << vertices
                                                       << " vertices are a subpixel apart");
  CHECK(widest < 1e-11);
}

TEST_CASE(
    "what is near the right eye sees further left than the left eye, what is far further right "
    "(S0-11)") {
  const View centre = view_of(PerspectiveLens{0.8, 0.1, {}});
  const StereoPair pair{0.1, 5};
  const auto parallax = [&](double distance) {
    const Point<World, double> p{0.2, 0.1, -distance};
    return test::screen_of(eye_view(centre, pair, Side::kRight), p).x -
           test::screen_of(eye_view(centre, pair, Side::kLeft), p).x;
  };
  CHECK(parallax(2) < -1);
  CHECK(parallax(20) > 1);
}

TEST_CASE("the naive pair has everything in front of the screen (S0-08)") {
  const View centre = view_of(PerspectiveLens{0.8, 0.1, 100.0});
  const StereoPair pair{0.1, kInfinity};
  REQUIRE(check_pair(centre, pair));
  for (const double distance : {0.1, 1.0, 10.0, 100.0}) {
    const Point<World, double> p{0, 0, -distance};
    CHECK(test::screen_of(eye_view(centre, pair, Side::kRight), p).x <
          test::screen_of(eye_view(centre, pair, Side::kLeft), p).x);
  }
}

TEST_CASE("zero separation is the centre's view, bit for bit, whatever the window (C-71)") {
  Random random(72);
  for (int i = 0; i < 100; ++i) {
    const View centre = test::random_view(random, test::random_pose(random));
    const StereoPair pair{0, i % 2 == 0 ? kInfinity : 3};
    CHECK(check_pair(centre, pair));
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const View eye = eye_view(centre, pair, side);
      CHECK(std::memcmp(&eye.clip_from_eye, &centre.clip_from_eye, sizeof eye.clip_from_eye) == 0);
      CHECK(eye.eye_from_world == centre.eye_from_world);
    }
  }
}

TEST_CASE("pairs that make no sense are refused with what to do about them") {
  const View lens = view_of(PerspectiveLens{kPi / 2, 0.5, 100.0}, 720, 720);  // a = 1
  const View endless = view_of(PerspectiveLens{kPi / 2, 0.5, {}}, 720, 720);
  const View parallel = view_of(OrthographicLens{4, -1, 100}, 720, 720);
  const double nan = std::nan("");
  struct Case {
    const View* view;
    StereoPair pair;
    const char* says;  // null: accepted
  };
  const Case cases[] = {
      {&lens, {0.1, 5}, nullptr},
      {&lens, {0.1, 0.5}, nullptr},
      {&lens, {0.1, 100}, nullptr},
      {&lens, {0.1, kInfinity}, nullptr},
      {&endless, {0.1, 1e30}, nullptr},
      {&parallel, {0.1, 5}, nullptr},
      {&lens, {0, nan}, nullptr},
      {&lens,
       {-0.1, 5},
       "half of it is -0.1, which exchanges the eyes, so that near objects would look far; give a "
       "positive number"},
      {&lens, {nan, 5}, "half of it is nan; give a finite number"},
      {&lens, {kInfinity, 5}, "half of it is inf; give a finite number"},
      {&lens, {0.1, nan}, "it is at the distance nan; give a distance"},
      {&lens, {0.1, 0}, "which is not in front of the camera; give a positive distance"},
      {&lens, {0.1, -5}, "which is not in front of the camera; give a positive distance"},
      {&parallel, {0.1, -0.5}, "which is not in front of the camera"},
      {&parallel, {0.1, kInfinity}, "where a parallel projection has no parallax"},
      {&lens, {0.1, 0.4}, "nearer than the near plane at 0.5; move the window away"},
      {&lens, {0.1, 101}, "beyond the far plane at 100; bring the window closer"},
      {&parallel, {0.1, 101}, "beyond the far plane at 100"},
      {&lens,
       {5.1, 5},
       "half of it is 5.1, but half of the picture's width at the window is only 5"},
      {&lens, {100.1, kInfinity}, "half of the picture's width at the window is only 100"},
      {&parallel, {4.1, 5}, "half of the picture's width at the window is only 4,"},
      {&lens, {1e-40, 5}, "too large or too small for a float; choose a separation"},
      {&endless, {1e39, 1e39}, "too large or too small for a float; choose a separation"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.pair.half_separation, c.pair.window);
    const Result<void> checked = check_pair(*c.view, c.pair);
    if (c.says == nullptr) {
      CHECK(checked);
      continue;
    }
    REQUIRE_FALSE(checked);
    CAPTURE(checked.error().message());
    CHECK(checked.error().message().find(c.says) != std::string::npos);
    CHECK_FALSE(checked.error().remedy.empty());
  }
}

TEST_CASE("at the largest separation that is allowed, the two pictures of infinity just touch") {
  const View centre = view_of(PerspectiveLens{0.8, 0.1, {}});
  const StereoPair pair{window_half_width(centre, 5), 5};
  REQUIRE(check_pair(centre, pair));
  const Point<World, double> far{0, 0, -1e12};
  CHECK(std::abs(test::screen_of(eye_view(centre, pair, Side::kLeft), far).x) < 1e-6);
  CHECK(std::abs(test::screen_of(eye_view(centre, pair, Side::kRight), far).x - 1280) < 1e-6);
}

}  // namespace
}  // namespace glassbox
