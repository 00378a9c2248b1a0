#include <glassbox/mesh/triangulate.h>

#include <algorithm>
#include <cmath>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/ear_clipping.h>
#include <glassbox/mesh/topology.h>

#include <glassbox/base/random.h>
#include "tests/mesh/outlines.h"
#include "tests/mesh/polygons.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Points = std::vector<Point<Object>>;
using Ring = std::array<std::uint32_t, 3>;

std::vector<Ring> rings(const Triangulation& triangulation) {
  std::vector<Ring> result;
  for (const Triangle& t : triangulation.triangles) result.push_back(t.corners);
  return result;
}

// The triangles of a mesh as a mesh.
Mesh as_mesh(const Mesh& mesh, const Triangulation& triangulation) {
  Mesh result;
  result.positions = mesh.positions;
  for (const Triangle& t : triangulation.triangles) {
    add_polygon(result, {mesh.corners[t.corners[0]].position, mesh.corners[t.corners[1]].position,
                         mesh.corners[t.corners[2]].position});
  }
  return result;
}

TEST_CASE("triangles stay as they are and every face takes n - 2 numbers") {
  const Points points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}};
  const Mesh mesh =
      make_mesh(points, {{2, 0, 1}, {0, 1, 4}, {0, 1}, {0, 1, 2, 3}, {0, 0, 1, 1, 4}, {1, 2, 0}});
  const Triangulation t = triangulate(mesh);
  // 1 + 1 + 0 + 2 + 3 + 1: the collinear triangle and the collinear pentagon are numbered, but give
  // no triangles.
  CHECK(t.numbered == 8);
  const std::vector<Triangle> expected = {
      {{0, 1, 2}, 0, 0}, {{8, 9, 10}, 3, 2}, {{8, 10, 11}, 3, 3}, {{17, 18, 19}, 5, 7}};
  CHECK(t.triangles == expected);
  CHECK(t.degenerate_faces == Indices{1, 2, 4});
  CHECK(t.degenerate_triangles == 0);
  CHECK(t.fallback_faces.empty());
}

TEST_CASE("a quad is cut along its shorter diagonal, and on a tie from its first corner (C-26)") {
  const auto cut = [](const Points& points) { return rings(triangulate(make_polygon(points))); };
  const std::vector<Ring> from_first = {{0, 1, 2}, {0, 2, 3}}, from_second = {{0, 1, 3}, {1, 2, 3}};
  CHECK(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) == from_first);
  CHECK(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.25f}, {0, 1, 0}}) == from_second);
  CHECK(cut({{0, 0, 0}, {1, 0, 0.25f}, {1, 1, 0}, {0, 1, 0}}) == from_first);
  // A difference of one ulp decides.
  const float more = std::nextafter(1.0f, 2.0f);
  CHECK(cut({{0, 0, 0}, {1, 0, 0}, {more, 1, 0}, {0, 1, 0}}) == from_second);
  // The same square 2^24 away, where the rounding of squared lengths would decide.
  const float far = 0x1p24f;
  CHECK(cut({{far, 0, 0}, {far + 2, 0, 0}, {far + 2, 2, 0}, {far, 2, 0}}) == from_first);
}

TEST_CASE("a concave quad is cut from its reflex corner, even if that diagonal is the longer one") {
  // Corner 1 is reflex; the diagonal from 0 to 2 is shorter, but outside the polygon.
  const Mesh arrow = make_polygon({{0, 0, 0}, {1, 0.5f, 0}, {2, 0, 0}, {1, 9, 0}});
  CHECK(rings(triangulate(arrow)) == std::vector<Ring>{{0, 1, 3}, {1, 2, 3}});
  // The same polygon with the reflex corner elsewhere, seen from the other side.
  const Mesh turned = make_polygon({{1, 9, 0}, {0, 0, 0}, {1, 0.5f, 0}, {2, 0, 0}});
  CHECK(rings(triangulate(turned)) == std::vector<Ring>{{0, 1, 2}, {0, 2, 3}});
  const Mesh reversed = make_polygon({{0, 0, 0}, {1, 9, 0}, {2, 0, 0}, {1, 0.5f, 0}});
  CHECK(rings(triangulate(reversed)) == std::vector<Ring>{{0, 1, 3}, {1, 2, 3}});
}

TEST_CASE("a quad with a straight or repeated corner loses no area") {
  // Corner 1 is on the line from 0 to 2: only the diagonal from corner 1 gives two triangles.
  const Triangulation straight =
      triangulate(make_polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}}));
  CHECK(rings(straight) == std::vector<Ring>{{0, 1, 3}, {1, 2, 3}});
  CHECK(straight.degenerate_triangles == 0);

  const Triangulation repeated =
      triangulate(make_polygon({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0}}));
  CHECK(repeated.triangles.size() == 1);
  CHECK(repeated.degenerate_triangles == 1);
  CHECK(repeated.numbered == 2);
}

TEST_CASE("faces without area are dropped and counted (C-24, C-25)") {
  const Points points = {{0, 0, 0}, {1, 1, 0},       {1, 0, 0},
                         {0, 1, 0}, {0.1f, 0.1f, 0}, {-0.0f, 0, 0}};
  const Mesh mesh = make_mesh(points, {{0, 1, 2, 3},  // a bow-tie whose wings are equal
                                       {0, 1, 4},     // collinear: 0.1f is twice the same number
                                       {0, 5, 1},     // 0 and -0 are the same place
                                       {0, 1, 0, 1},  // there and back
                                       {0},
                                       {},
                                       {3, 3, 3}});
  const Triangulation t = triangulate(mesh);
  CHECK(t.triangles.empty());
  CHECK(t.degenerate_faces == Indices{0, 1, 2, 3, 4, 5, 6});
  CHECK(t.numbered == 2 + 1 + 1 + 2 + 0 + 0 + 1);
}

TEST_CASE("a sliver that is not quite degenerate is kept") {
  // The middle corner is one ulp off the line; with rounded arithmetic on raw coordinates the area
  // would be 0.
  const float x = 0x1p20f, off = std::nextafter(0x1p20f, 0x1p21f);
  const Triangulation t = triangulate(make_polygon({{0, 0, 0}, {x, off, 0}, {2 * x, 2 * x, 0}}));
  CHECK(t.triangles.size() == 1);
  const Triangulation tiny = triangulate(make_polygon({{0, 0, 0}, {1e-45f, 0, 0}, {0, 1e-45f, 0}}));
  CHECK(tiny.triangles.size() == 1);
}

TEST_CASE("random simple polygons are covered exactly once by triangles that turn like them") {
  Random random(3);
  int polygons = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto n = std::size_t(random.integer(4, 16));
    const Outline outline = random_simple(random, n, trial % 2 == 0 ? 4 : 50);
    if (outline.empty()) continue;
    ++polygons;
    INFO("trial " << trial << ": " << text(outline));
    const Mesh mesh = flat_mesh(outline);
    const Triangulation t = triangulate(mesh);
    REQUIRE(t.triangles.size() == n - 2);
    REQUIRE(t.fallback_faces.empty());
    std::int64_t covered = 0;
    for (const Triangle& triangle : t.triangles) {
      const auto [a, b, c] = triangle.corners;
      const std::int64_t area = turn(outline[a], outline[b], outline[c]);
      REQUIRE(area > 0);
      covered += area;
    }
    REQUIRE(covered == twice_area(outline));
    // The triangles meet edge to edge: they form a disc whose border is the outline, with no corner
    // in the middle of an edge.
    const Topology topology = find_topology(as_mesh(mesh, t));
    REQUIRE(topology.boundary_edges == n);
    REQUIRE(topology.non_manifold_edges == 0);
    REQUIRE(topology.inconsistent_edges == 0);
    REQUIRE(topology.euler_characteristic() == 1);
  }
  CHECK(polygons > 1000);
}

TEST_CASE("the plane a polygon lies in does not matter: areas add up exactly in rationals") {
  Random random(4);
  for (int trial = 0; trial < 400; ++trial) {
    const Outline outline = random_simple(random, 9, 12);
    if (outline.empty()) continue;
    const auto small = [&random] { return random.integer(-5, 5); };
    const std::array<std::int64_t, 6> axes = {small(), small(), small(), small(), small(), small()};
    Points points;
    for (const Int2& p : outline) {
      points.emplace_back(float(7 + p.x * axes[0] + p.y * axes[3]),
                          float(p.x * axes[1] + p.y * axes[4]),
                          float(p.x * axes[2] + p.y * axes[5] - 3));
    }
    const Mesh mesh = make_polygon(points);
    const Triangulation t = triangulate(mesh);
    const auto area_vector = [](const std::vector<ExactPoint>& p) {
      ExactVector sum(0, 0, 0);
      for (std::size_t i = 2; i < p.size(); ++i) sum = sum + cross(p[i - 1] - p[0], p[i] - p[0]);
      return sum;
    };
    const ExactVector whole = area_vector(exact(points));
    INFO("trial " << trial << ": " << text(outline));
    if (dot(whole, whole) == 0) {
      CHECK(t.degenerate_faces.size() == 1);  // the two axes are parallel
      continue;
    }
    ExactVector sum(0, 0, 0);
    for (const Triangle& triangle : t.triangles) {
      const auto [a, b, c] = triangle.corners;
      const ExactVector part = area_vector({exact(points[a]), exact(points[b]), exact(points[c])});
      CHECK(dot(part, whole) > 0);
      sum = sum + part;
    }
    CHECK(sum == whole);
    CHECK(t.triangles.size() == points.size() - 2);
  }
}

TEST_CASE("any closed outline whatever is cut into n - 2 triangles, the same ones every time") {
  Random random(5);
  int fallbacks = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto n = std::size_t(random.integer(3, 24));
    Points points;
    for (std::size_t i = 0; i < n; ++i) {
      // Few distinct coordinates, so that many corners repeat and many edges overlap.
      const auto x = float(random.integer(-2, 2)), y = float(random.integer(-2, 2));
      points.emplace_back(x, y, float(random.integer(0, 1)));
    }
    const Mesh mesh = make_polygon(points);
    const Triangulation t = triangulate(mesh);
    CAPTURE(trial);
    CHECK(t.numbered == n - 2);
    if (t.degenerate_faces.empty()) CHECK(t.triangles.size() + t.degenerate_triangles == n - 2);
    fallbacks += int(t.fallback_faces.size());
    CHECK(triangulate(mesh).triangles == t.triangles);
  }
  CHECK(fallbacks > 0);
}

TEST_CASE("an outline that crosses itself is reported") {
  // A bow-tie with unequal wings has an area but no triangulation.
  const Triangulation t = triangulate(make_polygon({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}));
  CHECK(t.fallback_faces == Indices{0});
  CHECK(t.triangles.size() == 2);
}

TEST_CASE("a hole that a bridge joins to the outline stays open") {
  // A square of side 6 with a square hole of side 2. The bridge runs from corner 0 to the hole and
  // back.
  const Outline outline = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0},
                           {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}};
  const Triangulation t = triangulate(flat_mesh(outline));
  CHECK(t.fallback_faces.empty());
  std::int64_t covered = 0;
  for (const Triangle& triangle : t.triangles) {
    const auto [a, b, c] = triangle.corners;
    CHECK(turn(outline[a], outline[b], outline[c]) > 0);
    covered += turn(outline[a], outline[b], outline[c]);
  }
  CHECK(covered == 2 * (36 - 4));
}

// ---- size ----

// How many corners and grid cells are visited, divided by the number of corners of the outline.
double work_for(const Points& points) {
  std::vector<FlatPoint> outline;
  for (const Point<Object>& p : points) outline.push_back({p.x, p.y});
  const EarClipping clipped = clip_ears(outline, [](const auto&) {});
  return double(clipped.test_count) / double(points.size());
}

TEST_CASE("polygons of 20 000 corners take little more work than to look at them") {
  constexpr int kCorners = 20000;
  Points circle, star, comb, spiral;
  for (int i = 0; i < kCorners; ++i) {
    const SinCos turn = sin_cos_degrees(360.0 * i / kCorners);
    const double radius = i % 2 == 0 ? 1 : 0.5;
    circle.emplace_back(float(1000 * turn.cos), float(1000 * turn.sin), 0.0f);
    star.emplace_back(float(radius * turn.cos), float(radius * turn.sin), 0.0f);
  }
  // Teeth that reach almost across. When they are cut off, one long row of straight corners is
  // left, for which the grid does not help: this takes quadratic time.
  constexpr int kTeeth = 5000;
  for (int i = 0; i < kTeeth; ++i) comb.emplace_back(float(i), i % 2 == 0 ? 1.0f : 1000.0f, 0.0f);
  comb.emplace_back(float(kTeeth), 0.0f, 0.0f);
  comb.emplace_back(0.0f, 0.0f, 0.0f);
  std::reverse(comb.begin(), comb.end());
  // Out along a spiral of 50 turns, and back beside it.
  for (int i = 0; i < kCorners / 2; ++i) {
    const SinCos turn = sin_cos_degrees(360.0 * 50 * i / (kCorners / 2));
    const double radius = 1 + 100.0 * i / kCorners;
    spiral.emplace_back(float(radius * turn.cos), float(radius * turn.sin), 0.0f);
  }
  for (int i = kCorners / 2; i-- > 0;) {
    const Point<Object> p = spiral[std::size_t(i)];
    spiral.emplace_back(p.x * 0.995f, p.y * 0.995f, 0.0f);
  }
  struct Outline {
    const char* name;
    const Points& points;
    double most;  // limit of visits per corner: twice the count, which no machine changes
  };
  for (const auto& [name, points, most] : {Outline{"circle", circle, 16},
                                           {"star", star, 440},
                                           {"comb", comb, 1400},
                                           {"spiral", spiral, 50}}) {
    INFO(name);
    CHECK(work_for(points) < most);
    const Triangulation t = triangulate(make_polygon(points));
    CHECK(t.fallback_faces.empty());
    CHECK(t.triangles.size() + t.degenerate_triangles == points.size() - 2);
    CHECK(t.degenerate_triangles == 0);
  }
}

TEST_CASE("a tangle of 20 000 corners comes to an end") {
  // Every edge crosses most others, so hardly any corner is ever an ear.
  Random random(6);
  Points points;
  for (int i = 0; i < 20000; ++i) {
    const auto x = float(random.between(-1, 1)), y = float(random.between(-1, 1));
    points.emplace_back(x, y, 0.0f);
  }
  CHECK(work_for(points) < 5400);  // twice the count
  const Triangulation t = triangulate(make_polygon(points));
  CHECK(t.triangles.size() + t.degenerate_triangles == points.size() - 2);
  CHECK(t.fallback_faces == Indices{0});
}

}  // namespace
}  // namespace glassbox::test
