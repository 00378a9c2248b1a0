// Object space to the screen in float and back (S3-03): every coordinate comes back within its
// bound, however near, far, large, small or skewed it is; a coordinate that cannot come back is
// reported as such.
#include <glassbox/render/trace/bounds.h>

#include <cmath>
#include <cstdio>
#include <string>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/vertex_chain.h>
#include <glassbox/render/trace/tracer.h>

#include <glassbox/base/random.h>
#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

constexpr int kSide = 256;  // px

// Triangles in front of a camera at the origin that looks along -z. Their distances are spread
// evenly over the decades between two powers of ten, given by their exponents.
struct Depths {
  double from = 0, to = 0;
};

Scene triangles_at(const Depths& depths, int count, Random& random) {
  Mesh mesh;
  for (int i = 0; i < 3 * count; ++i) {
    const double distance = std::pow(10, random.between(depths.from, depths.to));
    mesh.positions.push_back({float(distance * random.between(-0.5, 0.5)),
                              float(distance * random.between(-0.5, 0.5)), float(-distance)});
  }
  for (int i = 0; i < count; ++i) {
    const auto first = std::uint32_t(3 * i);
    test::add_face(mesh, {first, first + 1, first + 2});
  }
  return test::scene_of(std::move(mesh));
}

Transform<World, Object> skewed(double size, double away, Random& random) {
  Transform<World, Object> m;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      m.at(row, column) = size * (random.between(-0.4, 0.4) + (row == column ? 1 : 0));
    }
    m.at(row, 3) = away * random.between(-1, 1);
  }
  return m;
}

// The same positions in the world, modelled in another object space.
void model_in(Scene& scene, const Transform<World, Object>& world_from_object) {
  const glm::dmat4 back = glm::inverse(world_from_object.columns);
  for (Point<Object>& p : scene.meshes[0].positions) {
    p = Point<Object>(glm::vec3(back * glm::dvec4(glm::dvec3(to_glm(p)), 1)));
  }
  scene.nodes[0].world_from_node = world_from_object;
}

View view_of(const Lens& lens, DepthRange range) {
  const auto view = make_view(Camera{"test", lens, {}}, kSide, kSide, range);
  REQUIRE(view);
  return *view;
}

// Checks that every coordinate of every corner is within its bound. Returns the figures of the run.
RoundTrips round_trips_of(const Scene& scene, const View& view) {
  TraceFilter filter;
  filter.fragments = false;
  RenderSettings settings;
  settings.cull = Cull::kNone;
  const Trace run = trace(scene, view, settings, filter).trace;
  REQUIRE(run.complete);
  const DrawBounds draw_bounds = bounds_of(run.draws.front(), view);
  RoundTrips trips;
  int broken = 0;
  for (const TracedTriangle& triangle : run.triangles) {
    const TriangleBounds bounds = bounds_of(run, triangle, run.draws.front(), draw_bounds);
    trips.add(triangle, bounds);
    for (const CornerBounds& corner : bounds.corners) {
      if (!corner.round_trip || !corner.round_trip->is_bounded()) continue;
      for (int axis = 0; axis < 3; ++axis) {
        broken += int(!(corner.round_trip->error[axis] <= corner.round_trip->bound[axis]));
      }
    }
  }
  CHECK(broken == 0);
  CHECK(trips.largest_ratio <= 1);
  CHECK(trips.corners > 0);
  return trips;
}

TEST_CASE("object to screen to object stays within its bound, from a micrometre to a light year") {
  constexpr std::uint64_t kSeed = 403;
  INFO("seed " << kSeed);
  Random random(kSeed);
  for (const DepthRange range : {DepthRange::kStandard, DepthRange::kReversed}) {
    for (const Depths& depths : {Depths{-6, -3}, {-1, 2}, {2, 7}, {10, 15}}) {
      for (const bool infinite : {false, true}) {
        for (const double size : {1.0, 1e-5, 1e4}) {
          PerspectiveLens lens{1.2, std::pow(10, depths.from), {}};
          if (!infinite) lens.far = std::pow(10, depths.to);
          Scene scene = triangles_at(depths, 300, random);
          model_in(scene, skewed(size, std::pow(10, depths.to - 1), random));
          CAPTURE(int(range), depths.from, infinite, size);
          const RoundTrips trips = round_trips_of(scene, view_of(lens, range));
          CHECK(trips.largest_ratio > 0.001);
        }
      }
    }
  }
}

TEST_CASE("a parallel projection's round trip stays within its bound") {
  Random random(404);
  for (const Depths& depths : {Depths{-3, 0}, {0, 4}}) {
    Scene scene = triangles_at(depths, 500, random);
    model_in(scene, skewed(0.01, 10, random));
    const OrthographicLens lens{std::pow(10, depths.to), 0, 2 * std::pow(10, depths.to)};
    const RoundTrips trips = round_trips_of(scene, view_of(lens, DepthRange::kStandard));
    CHECK(trips.unbounded == 0);
    CHECK(trips.largest_ratio > 0.001);
  }
}

TEST_CASE("beyond 2^25 near distances only reversed depth brings a point back") {
  Random random(405);
  const Scene scene = triangles_at({8, 9}, 300, random);
  const PerspectiveLens lens{1.2, 1, {}};
  const RoundTrips standard = round_trips_of(scene, view_of(lens, DepthRange::kStandard));
  CHECK(standard.unbounded == standard.corners);
  const RoundTrips reversed = round_trips_of(scene, view_of(lens, DepthRange::kReversed));
  CHECK(reversed.unbounded == 0);
  CHECK(reversed.bound < 1e-6 * 1e9);
  CHECK(reversed.largest_error <= reversed.bound);
}

TEST_CASE("what is at or behind the eye has no round trip, and a flattened object no way back") {
  Random random(406);
  Scene scene = triangles_at({0, 1}, 4, random);
  for (Point<Object>& p : scene.meshes[0].positions) p.z = -p.z;
  const View view = view_of(PerspectiveLens{1.2, 0.5, {}}, DepthRange::kStandard);
  const Trace run = trace(scene, view, RenderSettings{}, {}).trace;
  const DrawBounds draw_bounds = bounds_of(run.draws.front(), view);
  for (const TracedTriangle& triangle : run.triangles) {
    for (const CornerBounds& corner :
         bounds_of(run, triangle, run.draws.front(), draw_bounds).corners) {
      CHECK(!corner.round_trip);
    }
  }

  const ForwardTransform flat{glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0.5, 1),
                              glm::dmat4(0)};
  const auto trip = round_trip(Point<Object>(0.25f, 0.5f, 3), Point<Clip>(0.25f, 0.5f, 0.5f, 1),
                               glm::dvec4(0), flat, Viewport{0, 0, kSide, kSide});
  REQUIRE(trip);
  CHECK(!trip->is_bounded());
}

TEST_CASE("the built-in scenes come back to within a thousandth of a unit") {
  for (const char* name : {"cube", "teapot", "room", "checker"}) {
    CAPTURE(name);
    const auto scene = make_builtin(name);
    REQUIRE(scene);
    const auto view = make_view(test::camera_for(*scene, 1.5), 96, 64);
    REQUIRE(view);
    TraceFilter filter;
    filter.fragments = false;
    const Trace run = trace(*scene, *view, RenderSettings{}, filter).trace;
    RoundTrips trips;
    for (const TracedTriangle& triangle : run.triangles) {
      for (const TracedDraw& draw : run.draws) {
        if (draw.instance != triangle.instance) continue;
        trips.add(triangle, bounds_of(run, triangle, draw, bounds_of(draw, *view)));
      }
    }
    CHECK(trips.corners > 0);
    CHECK(trips.largest_ratio <= 1);
    CHECK(trips.largest_error < 1e-3);
  }
}

}  // namespace
}  // namespace glassbox
