#include <tests/pipeline/cameras.h>
#include <tests/support/catch.h>

#include <cmath>
#include <limits>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/unproject.h>

namespace glassbox {
namespace {

using WorldPoint = Point<World, double>;

View view_by(const Lens& lens, DepthRange range = DepthRange::kStandard) {
  Camera camera;
  camera.lens = lens;
  camera.world_from_eye = camera_pose(WorldPoint{3, 4, 12}, WorldPoint{0, 0, 0}, {0, 1, 0}).value();
  const auto view = make_view(camera, 1280, 720, range);
  REQUIRE(view);
  return *view;
}

// World space to screen space in double; the stages compute this in float.
Point<Screen, double> screen_of(const View& view, const WorldPoint& p) {
  const Point<Clip, double> c = view.clip_from_eye * (view.eye_from_world * p);
  const Viewport& v = view.viewport;
  return {(c.x / c.w + 1) / 2 * double(v.width()) + double(v.left),
          (1 - c.y / c.w) / 2 * double(v.height()) + double(v.top), c.z / c.w};
}

TEST_CASE("world to screen to world returns every kind of camera's points (S3-03)") {
  Random random(90);
  const View views[] = {view_by(PerspectiveLens{1, 0.5, 100.0}),
                        view_by(PerspectiveLens{1, 0.5, {}}),
                        view_by(PerspectiveLens{1, 0.5, 100.0}, DepthRange::kReversed),
                        view_by(PerspectiveLens{1, 0.5, {}}, DepthRange::kReversed),
                        view_by(OrthographicLens{5, -10, 100}),
                        view_by(FrustumLens{-0.2, 0.7, -0.1, 0.3, 0.5, 100.0})};
  for (const View& view : views) {
    for (int i = 0; i < 500; ++i) {
      const WorldPoint p{random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)};
      const auto back = unproject(view, screen_of(view, p));
      REQUIRE(back);
      // The few roundings of depth times d(distance)/d(depth) <= 17^2/0.5, and those of the pose
      // times 30.
      const double bound = 16 * unit_roundoff<double> * (17 * 17 / 0.5 + 30);
      CHECK(test::length(*back - p) <= bound);
    }
  }
}

TEST_CASE("pixel corners at the near plane are the window's (S3-17)") {
  const View view = view_by(FrustumLens{-0.25, 0.5, -0.125, 0.25, 0.5, 100.0});
  const auto corner = unproject(view, {0, 0, 0});
  REQUIRE(corner);
  const Point<Eye, double> eye = view.eye_from_world * *corner;
  // 13 world units from the origin, with an error of 60 u of that.
  CHECK(std::abs(eye.x + 0.25) <= 1e-14);
  CHECK(std::abs(eye.y - 0.25) <= 1e-14);
  CHECK(std::abs(eye.z + 0.5) <= 1e-14);
}

TEST_CASE("an error in depth is magnified by z^2 (f - n)/(f n) (C-20, bound 8)") {
  const double n = 0.01, f = 1000;  // f/n = 1e5
  const View view = view_by(PerspectiveLens{1, n, f});
  const View reversed = view_by(PerspectiveLens{1, n, f}, DepthRange::kReversed);
  const auto distance_of = [](const View& v, double depth) {
    const auto p = unproject(v, {640, 360, depth});
    REQUIRE(p);
    return -(v.eye_from_world * *p).z;
  };
  double worst = 0, worst_reversed = 0;
  for (double z = 100; z < 900; z *= 1.01) {
    CHECK(std::abs(distance_per_depth(view, z) / (z * z * (f - n) / (f * n)) - 1) <=
          8 * unit_roundoff<double>);
    const double exact = f / (f - n) * (1 - n / z);
    const double stored = float(exact), error = std::abs(stored - exact);
    const double moved = std::abs(distance_of(view, stored) - z);
    // First order, with an allowance for the curvature nearby and for the roundings of double.
    CHECK(moved <= distance_per_depth(view, z) * error * 1.1 + 1e-6 * z);
    worst = std::max(worst, moved / z);
    const double exact_reversed = n / (f - n) * (f / z - 1);
    worst_reversed = std::max(
        worst_reversed, std::abs(distance_of(reversed, double(float(exact_reversed))) / z - 1));
  }
  CHECK(worst > 1e-4);                   // standard depth has lost five digits of the distance
  CHECK(worst_reversed <= 2 * 0x1p-24);  // reversed depth has kept them
}

TEST_CASE("depths that no point in front of the eye has are refused") {
  const View endless = view_by(PerspectiveLens{1, 0.5, {}});
  CHECK(!unproject(endless, {0, 0, 1}));    // infinity itself
  CHECK(!unproject(endless, {0, 0, 1.5}));  // beyond infinity
  CHECK(!unproject(endless, {0, 0, std::nan("")}));
  const View reversed = view_by(PerspectiveLens{1, 0.5, {}}, DepthRange::kReversed);
  CHECK(!unproject(reversed, {0, 0, 0}));
}

}  // namespace
}  // namespace glassbox
