#include <tests/support/catch.h>

#include <cmath>
#include <limits>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {
namespace {

constexpr double kNoFarPlane = std::numeric_limits<double>::infinity();

Camera camera_with(const Lens& lens) {
  Camera camera;
  camera.lens = lens;
  camera.world_from_eye =
      camera_pose(Point<World, double>{0, 0, 5}, Point<World, double>{0, 0, 0}, {0, 1, 0}).value();
  return camera;
}

Point<Screen> screen_point(const View& view, const Point<World, double>& p) {
  const Point<Clip, double> c = view.clip_from_eye * view.eye_from_world * p;
  const NdcVertex ndc{{float(c.x / c.w), float(c.y / c.w), float(c.z / c.w)}, float(1 / c.w)};
  return to_screen(ndc, view.viewport).position;
}

TEST_CASE("a perspective camera is the look-at and the projection of its parts") {
  const auto view = make_view(camera_with(PerspectiveLens{kHalfPi, 1, 9}), 640, 480);
  REQUIRE(view);
  CHECK(view->eye_from_world == look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}).value());
  CHECK(view->clip_from_eye == perspective(kHalfPi, 640.0 / 480, {1, 9}).value());
  CHECK(view->perspective);
  CHECK(view->near == 1);
  CHECK(view->far == 9);
  CHECK(view->viewport.right == 640);
  CHECK(view->viewport.bottom == 480);
  CHECK(view->depth_range == DepthRange::kStandard);

  const auto endless =
      make_view(camera_with(PerspectiveLens{kHalfPi, 1, {}}), 640, 480, DepthRange::kReversed);
  REQUIRE(endless);
  CHECK(endless->far == kNoFarPlane);
  CHECK(endless->clip_from_eye.at(2, 2) == 0);
}

TEST_CASE(
    "orthographic extents follow the picture's shape, and powers of two are exact to the pixel") {
  const auto view = make_view(camera_with(OrthographicLens{128, 0, 16}), 512, 256);
  REQUIRE(view);
  CHECK(!view->perspective);
  // 256 world units are 256 pixels: world (x, y) is at pixel (x + 256, 128 - y), with fractions of
  // 1/256.
  for (double x : {-256.0, -3.00390625, 0.0, 0.5, 17.25, 255.99609375}) {
    const Point<Screen> p = screen_point(*view, {x, x / 2, 0});
    CHECK(p.x == x + 256);
    CHECK(p.y == 128 - x / 2);
  }
  const auto television = make_view(camera_with(OrthographicLens{240, 0, 16}), 640, 480);
  REQUIRE(television);
  CHECK(television->clip_from_eye.at(0, 0) == 1.0 / 320);
}

TEST_CASE("a frustum lens is taken as given, whatever the picture's shape") {
  const auto view = make_view(camera_with(FrustumLens{-1, 2, -1, 1, 1, 10}), 100, 300);
  REQUIRE(view);
  CHECK(view->clip_from_eye == frustum({-1, 2, -1, 1}, {1, 10}).value());
}

TEST_CASE("the viewport's corners are exact, y downwards (S3-17)") {
  const Viewport viewport{0, 0, 1280, 720};
  CHECK(to_screen({{-1, 1, 0}, 1}, viewport).position == Point<Screen>(0, 0, 0));
  CHECK(to_screen({{1, -1, 1}, 1}, viewport).position == Point<Screen>(1280, 720, 1));
  CHECK(to_screen({{0, 0, 0.5f}, 1}, viewport).position == Point<Screen>(640, 360, 0.5f));
  const Viewport inset{100, 50, 300, 250};
  CHECK(to_screen({{-1, -1, 0}, 1}, inset).position == Point<Screen>(100, 250, 0));
}

TEST_CASE("E14: screen coordinates are reals, negative ones too, until they are sampled") {
  const auto view = make_view(camera_with(PerspectiveLens{kHalfPi, 1, 9}), 64, 64);
  REQUIRE(view);
  const Point<Screen> inside = screen_point(*view, {1, 1, 0});
  CHECK(inside.x == 32 + 32 / 5.0f);
  CHECK(inside.x != std::floor(inside.x));
  const Point<Screen> outside = screen_point(*view, {-8, 8, 0});  // left of and above the picture
  CHECK(outside.x < 0);
  CHECK(outside.y < 0);
  // As an unsigned pixel index it would be far outside.
  CHECK(unsigned(int(std::floor(outside.x))) > 64u);
}

TEST_CASE("the y flip of the screen turns counter-clockwise fronts clockwise (SPEC 0.2)") {
  const auto view = make_view(camera_with(PerspectiveLens{kHalfPi, 1, 9}), 64, 64);
  REQUIRE(view);
  const Point<Screen> a = screen_point(*view, {0, 0, 0}), b = screen_point(*view, {1, 0, 0}),
                      c = screen_point(*view, {0, 1, 0});
  // The triangle is counter-clockwise in the world, seen from +z. With y down its doubled area is
  // negative.
  CHECK((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0);
}

TEST_CASE("reversed depth is accepted where standard depth is: near 1e-30, far 1e10 (C-10)") {
  const PerspectiveLens lens{1, 1e-30, 1e10};
  CHECK(make_view(camera_with(lens), 64, 64, DepthRange::kStandard));
  const auto view = make_view(camera_with(lens), 64, 64, DepthRange::kReversed);
  REQUIRE(view);
  // The slope n/(f - n) = 1e-40 is a subnormal float, but not 0, which belongs to the matrix of an
  // infinite far plane.
  const float slope = round_to_float(view->clip_from_eye).at(2, 2);
  CHECK(slope > 0);
  CHECK(std::abs(double(slope) - 1e-40) <= 0x1p-150);
  // A slope that float rounds to 0 is refused: points beyond the far plane would be drawn.
  CHECK_FALSE(
      make_view(camera_with(PerspectiveLens{1, 1e-30, 1e30}), 64, 64, DepthRange::kReversed));
}

TEST_CASE("degenerate lenses are refused with a reason and a remedy (C-08, C-09)") {
  const double nan = std::nan("");
  struct Case {
    Lens lens;
    const char* place;
  };
  const Case cases[] = {
      {PerspectiveLens{0, 1, 10.0}, "field of view"},
      {PerspectiveLens{kPi, 1, 10.0}, "field of view"},
      {PerspectiveLens{nan, 1, 10.0}, "field of view"},
      {PerspectiveLens{1e-300, 1, 10.0}, "projection"},
      {PerspectiveLens{1, 0, 10.0}, "near plane"},
      {PerspectiveLens{1, -1, 10.0}, "near plane"},
      {PerspectiveLens{1, nan, 10.0}, "near plane"},
      {PerspectiveLens{1, 1e-40, 10.0}, "near plane"},
      {PerspectiveLens{1, 10, 10.0}, "far plane"},
      {PerspectiveLens{1, 10, 1.0}, "far plane"},
      {PerspectiveLens{1, 1, 1e300}, "far plane"},
      {OrthographicLens{0, 0, 1}, "orthographic height"},
      {OrthographicLens{nan, 0, 1}, "orthographic height"},
      {OrthographicLens{-2, 0, 1}, "orthographic height"},
      {OrthographicLens{1, 1, 1}, "far plane"},
      {OrthographicLens{1, nan, 1}, "near plane"},
      {OrthographicLens{1, 0, kNoFarPlane}, "far plane"},
      {OrthographicLens{1e-300, 0, 1}, "projection"},
      {FrustumLens{1, 1, -1, 1, 1, 10.0}, "window"},
      {FrustumLens{-1, 1, nan, 1, 1, 10.0}, "window"},
      {FrustumLens{-1, 1, -1, 1, 0, 10.0}, "near plane"},
  };
  int index = 0;
  for (const Case& c : cases) {
    const auto view = make_view(camera_with(c.lens), 64, 64);
    CAPTURE(index++, c.place);
    REQUIRE(!view);
    CHECK(view.error().place == c.place);
    CHECK(!view.error().cause.empty());
    CHECK(!view.error().remedy.empty());
  }
}

TEST_CASE("pictures have 1 to 16384 pixels each way") {
  const Camera camera = camera_with(PerspectiveLens{});
  for (int bad : {0, -1, 16385, std::numeric_limits<int>::min()}) {
    CHECK(make_view(camera, bad, 64).error().place == "image size");
    CHECK(make_view(camera, 64, bad).error().place == "image size");
  }
  CHECK(make_view(camera, 16384, 1));
  CHECK(make_view(camera, 1, 16384));
}

TEST_CASE("poses that scale, shear, mirror or are not finite are refused") {
  Camera camera = camera_with(PerspectiveLens{});
  const Transform<World, Eye> good = camera.world_from_eye;
  const auto cause_of = [&](const Transform<World, Eye>& pose) {
    camera.world_from_eye = pose;
    const auto view = make_view(camera, 64, 64);
    REQUIRE(!view);
    CHECK(view.error().place == "camera pose");
    return view.error().cause;
  };
  CHECK(cause_of(good * scale<Eye>(2, 2, 2)).find("not perpendicular unit vectors") !=
        std::string::npos);
  CHECK(cause_of(good * shear<Eye>(Axis::kX, Axis::kY, 0.1)).find("not perpendicular") !=
        std::string::npos);
  CHECK(cause_of(good * scale<Eye>(-1, 1, 1)).find("left-handed") != std::string::npos);
  Transform<World, Eye> bad = good;
  bad.at(1, 2) = std::nan("");
  CHECK(cause_of(bad).find("entry (1, 2) is nan") != std::string::npos);
  bad = good;
  bad.at(3, 1) = 0.5;
  CHECK(cause_of(bad).find("last row") != std::string::npos);
}

TEST_CASE("a pose with few digits is repaired to the nearest rotation (C-12)") {
  // A rotation printed with six digits, as data files have them.
  Camera camera = camera_with(PerspectiveLens{});
  camera.world_from_eye = rotate_degrees<World, Eye>({1, 2, 3}, 40).value();
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      double& entry = camera.world_from_eye.at(row, column);
      entry = std::floor(entry * 1e6 + 0.5) / 1e6;
    }
  }
  CHECK(orthogonality_error(glm::dmat3(camera.world_from_eye.columns)) > 1e-8);
  const auto view = make_view(camera, 1280, 720);
  REQUIRE(view);
  CHECK(orthogonality_error(glm::dmat3(view->eye_from_world.columns)) <=
        16 * unit_roundoff<double>);
  // The repair moves points by less than 1e-3 px in a picture of 1280 pixels width.
  const Transform<Eye, World> unrepaired(glm::transpose(camera.world_from_eye.columns));
  const Point<World, double> p = camera.world_from_eye * Point<Eye, double>(1, 0.5, -4);
  View other = *view;
  other.eye_from_world = unrepaired;
  CHECK(std::abs(screen_point(*view, p).x - screen_point(other, p).x) <= 1e-3f);
  CHECK(std::abs(screen_point(*view, p).y - screen_point(other, p).y) <= 1e-3f);
}

}  // namespace
}  // namespace glassbox
