// Plants one cause of an empty picture in random scenes: it comes first. Scenes that are seen well
// have none.
#include <glassbox/render/trace/scene_verdict.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/mesh/triangulate.h>

#include "app/why/verdict_text.h"
#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

// A closed surface of random shape, size and place, whose fronts are outside, and a camera that
// sees all of it.
struct Stage {
  Scene scene;
  Point<World, double> middle, eye;
  double radius = 0;  // of a ball around `middle` in which all of the surface is
  Vector<World, double> up;
  double near = 0, far = 0;
  RenderSettings settings;

  Transform<World, Object>& world_from_object() { return scene.nodes[0].world_from_node; }
  Material& material() { return scene.materials[0]; }
};

Vector<World, double> random_direction(Random& random) {
  for (;;) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length > 0.2 && length <= 1) return {x / length, y / length, z / length};
  }
}

Vector<World, double> across(const Vector<World, double>& v, Random& random) {
  for (;;) {
    const Vector<World, double> a = cross(v, random_direction(random));
    const double length = std::sqrt(dot(a, a));
    if (length > 0.2 * std::sqrt(dot(v, v))) return a * (1 / length);
  }
}

Stage random_stage(Random& random) {
  Stage s;
  const int n = int(random.integer(2, 6));
  s.scene = scene_of(star_shaped_surface(n, random.between(0, 0.5), random));
  const Vector<World, double> axis = random_direction(random);
  const auto turned =
      rotate_degrees<World, Object>({axis.x, axis.y, axis.z}, random.between(-180, 180));
  REQUIRE(turned);
  const double size = std::pow(10, random.between(-3, 3));
  const Vector<World, double> aside = random_direction(random);
  s.middle = Point<World, double>() + aside * (size * random.between(0, 5));
  s.radius = size * std::sqrt(3) * 1.5;
  s.world_from_object() = translate<World>({s.middle.x, s.middle.y, s.middle.z}) * *turned *
                          scale<Object>(size, size, size);
  const Vector<World, double> away = random_direction(random);
  s.up = across(away, random);
  s.eye = s.middle + away * (s.radius * random.between(2, 4));
  s.near = s.radius * 0.05;
  s.far = s.radius * 20;
  return s;
}

// The view with the given gaze from the stage's eye.
View view_along(const Stage& s, const Vector<World, double>& gaze) {
  const auto pose = camera_pose(s.eye, gaze, s.up);
  REQUIRE(pose);
  const auto view = make_view({"", PerspectiveLens{0.9, s.near, s.far}, *pose}, 96, 64);
  REQUIRE(view);
  return *view;
}

View view_of(const Stage& s) {
  return view_along(s, s.middle - s.eye);
}

// The gaze turned by an angle away from the middle of the scene.
Vector<World, double> gaze_past(Stage& s, double degrees, Random& random) {
  const Vector<World, double> to_middle = s.middle - s.eye;
  const Vector<World, double> side = across(to_middle, random);
  s.up = cross(to_middle, side);
  const SinCos turn = sin_cos_degrees(degrees);
  const double distance = std::sqrt(dot(to_middle, to_middle));
  return to_middle * turn.cos + side * (distance * turn.sin);
}

// Leaves only the triangles that show their fronts to the eye, and winds them the other way round.
void turn_the_visible_half_round(Stage& s) {
  const auto object_from_world = inverse_affine(s.world_from_object());
  REQUIRE(object_from_world);
  const Point<Object, double> eye = *object_from_world * s.eye;
  Mesh& mesh = s.scene.meshes[0];
  std::vector<Corner> corners;
  std::vector<Face> faces;
  for (const Triangle& triangle : triangulate(mesh).triangles) {
    std::array<Point<Object, double>, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point<Object>& at = mesh.positions[mesh.corners[triangle.corners[k]].position];
      p[k] = {double(at.x), double(at.y), double(at.z)};
    }
    if (dot(three_point_normal(p[0], p[1], p[2]), eye - p[0]) <= 0) continue;
    faces.push_back({std::uint32_t(corners.size()), 3});
    for (const std::size_t k : {0u, 2u, 1u}) corners.push_back(mesh.corners[triangle.corners[k]]);
  }
  mesh.corners = corners;
  mesh.faces = faces;
}

struct Planted {
  Cause cause;
  std::function<View(Stage&, Random&)> plant;
};

const std::vector<Planted>& plants() {
  static const std::vector<Planted> all{
      {Cause::kEmptyScene,
       [](Stage& s, Random& random) {
         const View view = view_of(s);
         s.scene.meshes[0].faces.clear();
         if (random.unit() < 0.5) s.scene.instances.clear();
         return view;
       }},
      {Cause::kNoArea,
       [](Stage& s, Random&) {
         for (Point<Object>& p : s.scene.meshes[0].positions) p.y = p.z = 0;
         return view_of(s);
       }},
      {Cause::kDegenerateMatrix,
       [](Stage& s, Random& random) {
         const double left = random.unit() < 0.5 ? 0 : 1;
         s.world_from_object() = s.world_from_object() * scale<Object>(left, 0, 0);
         return view_of(s);
       }},
      {Cause::kMixedHands,
       [](Stage& s, Random&) {
         View view = view_of(s);
         for (int column = 0; column < 4; ++column) view.eye_from_world.at(2, column) *= -1;
         return view;
       }},
      {Cause::kNotFinite,
       [](Stage& s, Random&) {
         const View view = view_of(s);
         s.world_from_object() = s.world_from_object() * scale<Object>(1e45, 1e45, 1e45);
         for (Point<Object>& p : s.scene.meshes[0].positions) p = {p.x + 3, p.y + 3, p.z + 3};
         return view;
       }},
      {Cause::kInside,
       [](Stage& s, Random& random) {
         const Vector<World, double> aside = random_direction(random);
         s.eye = s.middle + aside * (s.radius * random.between(0, 0.2));
         s.near = s.radius * 0.001;
         const Vector<World, double> gaze = random_direction(random);
         s.up = across(gaze, random);
         return view_along(s, gaze);
       }},
      {Cause::kBehind,
       [](Stage& s, Random& random) {
         return view_along(s, gaze_past(s, random.between(140, 220), random));
       }},
      {Cause::kLooksAway,
       [](Stage& s, Random& random) {
         return view_along(s, gaze_past(s, random.between(75, 95), random));
       }},
      {Cause::kNearPlane,
       [](Stage& s, Random& random) {
         s.near = s.radius * random.between(5.5, 20);
         s.far = 10 * s.near;
         return view_of(s);
       }},
      {Cause::kFarPlane,
       [](Stage& s, Random& random) {
         s.far = s.radius * random.between(0.1, 0.9);
         s.near = s.far / 100;
         return view_of(s);
       }},
      {Cause::kTooSmall,
       [](Stage& s, Random& random) {
         const Vector<World, double> away = s.eye - s.middle;
         const double times = random.between(100, 1000);
         s.eye = s.middle + away * times;
         s.near *= times;
         s.far *= times;
         return view_of(s);
       }},
      {Cause::kInsideOut,
       [](Stage& s, Random&) {
         turn_the_visible_half_round(s);
         return view_of(s);
       }},
      {Cause::kMirroredNode,
       [](Stage& s, Random&) {
         s.world_from_object() = s.world_from_object() * scale<Object>(-1, 1, 1);
         turn_the_visible_half_round(s);
         return view_of(s);
       }},
      {Cause::kAlphaTest,
       [](Stage& s, Random& random) {
         s.material().alpha_mode = AlphaMode::kMask;
         s.material().base_color.a = float(random.between(0, 0.49));
         return view_of(s);
       }},
      {Cause::kTransparent,
       [](Stage& s, Random&) {
         s.material().alpha_mode = AlphaMode::kBlend;
         s.material().base_color.a = 0;
         return view_of(s);
       }},
      {Cause::kMasked,
       [](Stage& s, Random&) {
         s.settings.mask = {false, false, false, false};
         return view_of(s);
       }},
      {Cause::kSameColor,
       [](Stage& s, Random&) {
         s.material().unlit = true;
         s.material().base_color = {0, 0, 0, 1};
         s.settings.background = {0, 0, 0, 255};
         return view_of(s);
       }},
  };
  return all;
}

TEST_CASE("the planted cause of an empty picture comes first") {
  Random random(460);
  REQUIRE(plants().size() == kCauses);
  for (const Planted& planted : plants()) {
    for (int i = 0; i < 60; ++i) {
      Stage stage = random_stage(random);
      const View view = planted.plant(stage, random);
      const SceneVerdict found = scene_verdict(stage.scene, view, stage.settings);
      std::string causes;
      for (const SceneCause& cause : found.causes) {
        const CauseText text = explain(stage.scene, view, found, cause);
        CHECK_FALSE(text.why.empty());
        CHECK_FALSE(text.mend.empty());
        causes += std::string(name_of(cause.cause)) + " " + std::to_string(cause.triangles) + ": " +
                  text.why + " -> " + text.mend + "\n";
      }
      CAPTURE(name_of(planted.cause), i, found.shown_pixels, found.triangles, causes);
      REQUIRE(found.is_little_seen());
      REQUIRE_FALSE(found.causes.empty());
      CHECK(found.causes.front().cause == planted.cause);
    }
  }
}

TEST_CASE("a scene that is seen well has no cause, whatever its size and wherever it is") {
  Random random(461);
  for (int i = 0; i < 300; ++i) {
    Stage stage = random_stage(random);
    if (i % 3 == 1) stage.material().double_sided = true;
    if (i % 3 == 2) stage.world_from_object() = stage.world_from_object() * scale<Object>(-1, 1, 1);
    const SceneVerdict found = scene_verdict(stage.scene, view_of(stage), stage.settings);
    CAPTURE(i, found.shown_pixels);
    CHECK_FALSE(found.is_little_seen());
    CHECK(found.causes.empty());
  }
  for (const char* name : {"room", "forest", "thicket", "teapot:3", "cube", "f-glyph", "checker"}) {
    const Scene scene = built_in(name);
    const auto view = make_view(camera_for(scene, 1.5), 96, 64);
    REQUIRE(view);
    CAPTURE(name);
    CHECK(scene_verdict(scene, *view, {}).causes.empty());
  }
}

TEST_CASE("what is lost in an ordinary way has no cause beside the planted one") {
  // Ten or so of a cube's twelve triangles show their backs or are hidden; that its two fronts are
  // transparent is the only cause.
  Random random(462);
  for (int i = 0; i < 60; ++i) {
    Stage stage = random_stage(random);
    stage.scene.meshes[0] = star_shaped_surface(1, 0, random);
    stage.material().alpha_mode = AlphaMode::kBlend;
    stage.material().base_color.a = 0;
    const SceneVerdict found = scene_verdict(stage.scene, view_of(stage), stage.settings);
    CHECK(found.at(TriangleResult::kTurnedAway).triangles >= 6);
    REQUIRE(found.causes.size() == 1);
    CHECK(found.causes.front().cause == Cause::kTransparent);
  }
}

TEST_CASE("the direction in which the camera has to turn is told in degrees") {
  Random random(463);
  for (int i = 0; i < 100; ++i) {
    Stage stage = random_stage(random);
    const double degrees = random.between(45, 135);
    const View view = view_along(stage, gaze_past(stage, degrees, random));
    // gaze_past() turns in a plane that contains the axis to the right or its opposite.
    const SceneExtent extent = scene_verdict(stage.scene, view, {}).extent;
    CHECK(std::abs(extent.to_the_right) == Approx(degrees).margin(15));
    CHECK(std::abs(extent.up) <= 15);
  }
}

}  // namespace
}  // namespace glassbox::test
