#include <glassbox/base/random.h>
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/mesh/bounding_box.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {
namespace {

Box<World> box_of(const Point<World, double>& low, const Point<World, double>& high) {
  Box<World> box;
  box.include(low);
  box.include(high);
  return box;
}

bool inside(const Point<Clip, double>& c) {
  return std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && c.z >= 0 && c.z <= c.w;
}

TEST_CASE("the framed box is wholly in the picture, for any shape of box and picture") {
  Random random(70);
  for (int i = 0; i < 2000; ++i) {
    const double size = std::ldexp(1.0, int(random.integer(-20, 20)));
    const Point<World, double> low{random.between(-9, 9) * size, random.between(-9, 9) * size,
                                   random.between(-9, 9) * size};
    const Box<World> box =
        box_of(low, low + Vector<World, double>{random.unit() * size, random.unit() * size,
                                                random.unit() * size});
    const int width = int(random.integer(1, 2000)), height = int(random.integer(1, 2000));
    const auto camera = framing_camera(box, double(width) / height);
    REQUIRE(camera);
    const auto view = make_view(*camera, width, height);
    CAPTURE(i, width, height);
    REQUIRE(view);
    for (int corner = 0; corner < 8; ++corner) {
      CHECK(inside(view->clip_from_eye * view->eye_from_world * box.corner(corner)));
    }
    // The box is in the middle of the picture, and the planes' ratio leaves depth enough digits.
    const Point<Clip, double> centre = view->clip_from_eye * view->eye_from_world * box.center();
    CHECK(std::abs(centre.x / centre.w) < 1e-6);
    CHECK(std::abs(centre.y / centre.w) < 1e-6);
    CHECK(view->far / view->near <= kMaxDepthRatio);
  }
}

TEST_CASE("a scene fills the picture up to the margin and no further") {
  const Scene scene = *make_builtin("teapot:3");
  for (const double aspect : {0.25, 1.0, 16.0 / 9, 4.0}) {
    CAPTURE(aspect);
    const auto camera = framing_camera(scene, aspect);
    REQUIRE(camera);
    const auto view = make_view(*camera, int(std::lround(720 * aspect)), 720);
    REQUIRE(view);
    double reach = 0;  // of the outermost point; 1 is the edge of the picture
    for_each_drawn_position(scene, [&](const Point<World, double>& p) {
      const Point<Clip, double> c = view->clip_from_eye * view->eye_from_world * p;
      CHECK(inside(c));
      reach = std::max({reach, std::abs(c.x / c.w), std::abs(c.y / c.w)});
    });
    CHECK(std::abs(reach * FramingOptions{}.margin - 1) < 1e-12);
  }
}

TEST_CASE("the whole scene is in the picture, upright, whatever is up") {
  const Scene scene = *make_builtin("teapot:3");
  Random random(75);
  for (int i = 0; i < 200; ++i) {
    FramingOptions options;
    options.up = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (i == 0) options.up = {0, -3, 0};
    if (i == 1) options.up = {1e-9, -1, 0};
    if (i == 2) options.up = {0, 0, 1};
    CAPTURE(i, options.up.x, options.up.y, options.up.z);
    const auto camera = framing_camera(scene, 1.5, options);
    REQUIRE(camera);
    const auto view = make_view(*camera, 300, 200);
    REQUIRE(view);
    double reach = 0;
    for_each_drawn_position(scene, [&](const Point<World, double>& p) {
      const Point<Clip, double> c = view->clip_from_eye * view->eye_from_world * p;
      CHECK(inside(c));
      reach = std::max({reach, std::abs(c.x / c.w), std::abs(c.y / c.w)});
    });
    CHECK(std::abs(reach * options.margin - 1) < 1e-12);
    // The elevation is measured from the plane that is perpendicular to up.
    const Vector<Eye, double> up = view->eye_from_world * options.up;
    const double length = std::sqrt(dot(options.up, options.up));
    CHECK(std::abs(up.x / length) < 1e-14);
    CHECK(up.y > 0);
    CHECK(std::abs(up.z / length - 0.34202014332566873) < 1e-12);
  }
}

TEST_CASE("a scene turned with what is up is framed the same") {
  const Box<World> upright = box_of({-1, -2, -3}, {4, 5, 7});
  // y becomes z, and z becomes -y: exact.
  const Box<World> turned = box_of({-1, -7, -2}, {4, 3, 5});
  FramingOptions options;
  const Camera before = framing_camera(upright, 1.5, options).value();
  options.up = {0, 0, 2};
  const Camera after = framing_camera(turned, 1.5, options).value();
  for (int column = 0; column < 4; ++column) {
    CHECK(after.world_from_eye.at(0, column) == Approx(before.world_from_eye.at(0, column)));
    CHECK(after.world_from_eye.at(1, column) == Approx(-before.world_from_eye.at(2, column)));
    CHECK(after.world_from_eye.at(2, column) == Approx(before.world_from_eye.at(1, column)));
  }
  // The length of up does not matter, and y is the default.
  options.up = {0, 17, 0};
  CHECK(framing_camera(upright, 1.5, options).value().world_from_eye == before.world_from_eye);
  options.up = {0, 0, 0};
  CHECK(!framing_camera(upright, 1.5, options));
}

TEST_CASE("a single point gets a camera too, wherever it is") {
  for (double offset : {0.0, 1.0, 1e6, 1e20}) {
    const Point<World, double> p{offset, -offset, offset};
    const auto camera = framing_camera(box_of(p, p), 1.5);
    REQUIRE(camera);
    const auto view = make_view(*camera, 1280, 720);
    REQUIRE(view);
    const Point<Clip, double> c = view->clip_from_eye * view->eye_from_world * p;
    CHECK(inside(c));
  }
}

TEST_CASE("the default view is from the front, right and above") {
  const auto camera = framing_camera(box_of({-1, -1, -1}, {1, 1, 1}), 1);
  REQUIRE(camera);
  CHECK(camera->world_from_eye.at(0, 3) > 0);
  CHECK(camera->world_from_eye.at(1, 3) > 0);
  CHECK(camera->world_from_eye.at(2, 3) > 0);
  CHECK(camera->world_from_eye.at(1, 1) > 0.9);  // upright
}

TEST_CASE("nothing, infinite boxes and senseless options are refused") {
  const double inf = std::numeric_limits<double>::infinity();
  const Box<World> unit = box_of({0, 0, 0}, {1, 1, 1});
  CHECK(framing_camera(Box<World>{}, 1).error().message() ==
        "scene bounds: there is nothing to look at; give a scene with at least one vertex");
  CHECK(!framing_camera(box_of({0, 0, 0}, {inf, 1, 1}), 1));
  CHECK(!framing_camera(box_of({0, 0, 0}, {1e300, 1, 1}), 1));
  for (double aspect : {0.0, -1.0, inf, std::nan("")}) CHECK(!framing_camera(unit, aspect));
  FramingOptions options;
  options.elevation_degrees = 90;
  CHECK(!framing_camera(unit, 1, options));
  options = {};
  options.fovy_degrees = 180;
  CHECK(!framing_camera(unit, 1, options));
  options = {};
  options.margin = 0.5;
  CHECK(!framing_camera(unit, 1, options));
}

TEST_CASE("near and far enclose the box from any pose that sees all of it") {
  Random random(71);
  for (int i = 0; i < 1000; ++i) {
    const Box<World> box =
        box_of({-1, -2, -3}, {random.between(0, 4), random.between(0, 4), random.between(0, 4)});
    const Point<World, double> eye{random.between(-50, 50), random.between(10, 50),
                                   random.between(-50, 50)};
    const auto pose = camera_pose(eye, Point<World, double>{0, 0, 0}, {0, 1, 0});
    REQUIRE(pose);
    const auto planes = near_far_for(*pose, box);
    REQUIRE(planes);
    const auto eye_from_world = look_at(eye, {0, 0, 0}, {0, 1, 0});
    CHECK(planes->near > 0);
    for (int corner = 0; corner < 8; ++corner) {
      const double distance = -(*eye_from_world * box.corner(corner)).z;
      CHECK((distance > planes->near || planes->near == planes->far / kMaxDepthRatio));
      CHECK(distance < planes->far);
    }
  }
}

TEST_CASE("an eye inside the box, and one that looks away, get usable planes") {
  const Box<World> box = box_of({-1, -1, -1}, {1, 1, 1});
  const auto inside_pose =
      camera_pose(Point<World, double>{0, 0, 0}, Vector<World, double>{0, 0, -1}, {0, 1, 0});
  REQUIRE(inside_pose);
  const auto planes = near_far_for(*inside_pose, box);
  REQUIRE(planes);
  CHECK(planes->far == 1.02);
  CHECK(planes->near == 1.02 / kMaxDepthRatio);
  const auto away =
      camera_pose(Point<World, double>{0, 0, 50}, Vector<World, double>{0, 0, 1}, {0, 1, 0});
  REQUIRE(away);
  const auto behind = near_far_for(*away, box);
  REQUIRE(behind);
  CHECK(behind->near > 0);
  CHECK(behind->far > behind->near);
  const auto parallel = parallel_near_far_for(*away, box);
  REQUIRE(parallel);
  CHECK(parallel->near < -51);
  CHECK(parallel->far > -49);
  CHECK(parallel->near < parallel->far);
  CHECK(!near_far_for(*away, {}));
}

TEST_CASE("a plane that faces the eye still has room between near and far") {
  const Box<World> wall = box_of({-1, -1, 0}, {1, 1, 0});
  const auto pose =
      camera_pose(Point<World, double>{0, 0, 10}, Vector<World, double>{0, 0, -1}, {0, 1, 0});
  REQUIRE(pose);
  for (const auto& planes : {near_far_for(*pose, wall), parallel_near_far_for(*pose, wall)}) {
    REQUIRE(planes);
    CHECK(planes->near < 10);
    CHECK(planes->far > 10);
  }
}

}  // namespace
}  // namespace glassbox
