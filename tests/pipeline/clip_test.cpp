// Clipping in homogeneous clip space, compared with rational arithmetic, and the errors that occur
// without it.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/divide.h>

#include "tests/pipeline/clip_cases.h"
#include "tests/pipeline/rational_geometry.h"
#include "tests/support/catch.h"

using namespace glassbox;
using namespace glassbox::test;

TEST_CASE("a triangle through the eye plane is cut to exactly what lies in front (C-32)") {
  // z - w is -1/2 everywhere, so z = 0 at w = 1/2. All crossings have few bits, so nothing is
  // rounded.
  const std::vector<ClipPlane> near{frustum_planes()[0]};
  const Point<Clip> front{0, 0.25f, 0.5f, 1}, front2{0.5f, 0, 0.5f, 1};
  const Point<Clip> behind{-1, -1, -1.5f, -1}, behind2{1, -1, -1.5f, -1};

  for (const auto& [t, count] : {std::pair{triangle(front, behind, behind2), 3},
                                 std::pair{triangle(front, front2, behind), 4}}) {
    INFO(in_words(t));
    const ClipPolygon polygon = clip_triangle(t, near);
    REQUIRE(polygon.count == count);
    const Rational expected = test::twice_ndc_area(test::clip(test::rational_of(t), near));
    CHECK(test::twice_ndc_area(test::rational_of(polygon)) == expected);
    for (int i = 0; i < count; ++i) CHECK(polygon.vertices[std::size_t(i)].position.w >= 0.5f);
    // The trap: dividing first maps points behind the eye to the front.
    CHECK(test::twice_ndc_area(test::rational_of(t)) != expected);
  }
}

TEST_CASE("objects behind the observer do not come to the front (S3-13)") {
  // With w = -1, x/w, y/w and z/w are in the middle of the screen, at a legal depth.
  const Point<Clip> behind{-0.25f, 0.25f, -0.5f, -1};
  const NdcVertex naive = divide(behind);
  CHECK(std::abs(naive.position.x) < 1);
  CHECK(naive.position.z == 0.5f);
  CHECK_FALSE(clip_point(behind, frustum_planes()));
  const Triangle3 t = triangle(behind, {0.25f, 0, -0.5f, -1}, {0, -0.25f, -0.5f, -1});
  CHECK(clip_triangle(t, frustum_planes()).count == 0);
}

TEST_CASE("clipped areas are the rational ones for all eight patterns of signs of w (C-34)") {
  const std::uint64_t seed = 11;
  INFO("seed " << seed);
  Random random(seed);
  const std::vector<ClipPlane> planes = planes_without_far();
  // Coordinates are below 1.5 and w is at least 1/16 in the cases that are compared, so one
  // rounding moves a point in NDC by less than 1.5 * 2 * 16 u per coordinate. At most five planes
  // cut an edge. Moving the edges of a polygon inside the square of NDC (perimeter at most 8) by 5
  // * 48 u * sqrt(2) changes twice its area by less than 16 * 340 u.
  const double tolerance = 16 * 340 * 0x1p-24;
  for (int signs = 0; signs < 8; ++signs) {
    int drawn = 0;
    for (int i = 0; i < 1500; ++i) {
      std::array<Point<Clip>, 3> p;
      for (int k = 0; k < 3; ++k) {
        const bool behind = (signs >> k & 1) != 0;
        p[std::size_t(k)] = behind ? random_position(random, -1, 0) : random_position(random, 0, 1);
      }
      const Triangle3 t = triangle(p[0], p[1], p[2]);
      const RationalPolygon exact = test::clip(test::rational_of(t), planes);
      const bool too_near = std::any_of(
          exact.begin(), exact.end(), [](const RationalPoint& v) { return v.w < Rational(1, 16); });
      const ClipPolygon polygon = clip_triangle(t, planes);
      if (signs == 7) {
        // Everything is behind the eye, where -w <= x <= w cannot be true.
        REQUIRE(polygon.count == 0);
        REQUIRE(exact.empty());
      }
      if (too_near || exact.empty()) continue;
      INFO("w signs " << signs << ": " << in_words(t));
      ++drawn;
      const Rational difference =
          test::twice_ndc_area(test::rational_of(polygon)) - test::twice_ndc_area(exact);
      REQUIRE(std::abs(double(difference)) <= tolerance);
    }
    CHECK((signs == 7) == (drawn == 0));
  }
}

TEST_CASE("neither the first corner nor the winding nor the order of planes matters") {
  const std::uint64_t seed = 12;
  INFO("seed " << seed);
  Random random(seed);
  const std::vector<ClipPlane> planes = planes_without_far();
  std::vector<ClipPlane> reversed(planes.rbegin(), planes.rend());
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::array<Point<Clip>, 3> p{random_position(random, -0.5, 1),
                                       random_position(random, -0.5, 1),
                                       random_position(random, -0.5, 1)};
    const Triangle3 t = triangle(p[0], p[1], p[2]);
    INFO(in_words(t));
    const ClipPolygon polygon = clip_triangle(t, planes);
    for (const ClipPolygon& other : {clip_triangle(triangle(p[1], p[2], p[0]), planes),
                                     clip_triangle(triangle(p[0], p[2], p[1]), planes)}) {
      REQUIRE(other.count == polygon.count);
      for (int k = 0; k < polygon.count; ++k) {
        REQUIRE(contains(other, polygon.vertices[std::size_t(k)].position));
      }
    }
    if (i % 20 != 0) continue;
    const ClipPolygon other = clip_triangle(t, reversed);
    const auto near_eye = [](const ClipPolygon& q) {
      return std::any_of(q.vertices.begin(), q.vertices.begin() + q.count,
                         [](const ClipVertex& v) { return v.position.w < 0x1p-4f; });
    };
    if (polygon.count == 0 || near_eye(polygon) || near_eye(other)) continue;
    ++compared;
    const Rational difference = test::twice_ndc_area(test::rational_of(polygon)) -
                                test::twice_ndc_area(test::rational_of(other));
    REQUIRE(std::abs(double(difference)) <=
            2 * 16 * 340 * 0x1p-24);  // twice the bound derived above
  }
  CHECK(compared > 200);
}

TEST_CASE("both triangles at an edge cut it at the same bits, and a + t (b - a) does not (C-38)") {
  const std::uint64_t seed = 13;
  INFO("seed " << seed);
  Random random(seed);
  const auto render = render_planes(perspective_view(1280, 720, 0.125));
  const auto frustum = frustum_planes();
  int cut_edges = 0, mismatches = 0, cut_twice = 0;
  int naive_edges = 0, naive_mismatches = 0;

  const auto naive_crossing = [](const Point<Clip>& a, const Point<Clip>& b) {
    const float t = a.z / (a.z - b.z);
    return Point<Clip>{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0, a.w + t * (b.w - a.w)};
  };
  // How many vertices of `from` on the edge of corners 0 and 1 (their weight of corner 2 is 0) are
  // not in `in`.
  const auto missing = [](const ClipPolygon& from, const ClipPolygon& in) {
    int count = 0;
    for (int i = 0; i < from.count; ++i) {
      const ClipVertex& v = from.vertices[std::size_t(i)];
      count += v.weights[2] == 0 && !contains(in, v.position);
    }
    return count;
  };
  const auto made_on_edge = [](const ClipPolygon& polygon) {
    int count = 0;
    for (int i = 0; i < polygon.count; ++i) {
      const auto& weights = polygon.vertices[std::size_t(i)].weights;
      count += weights[2] == 0 && weights[0] != 0 && weights[1] != 0;
    }
    return count;
  };

  while (cut_edges < 100000) {
    const bool wide = random.integer(0, 1) == 0;
    const auto position = [&] {
      const double size = wide ? 1e6 : 10;  // leaves the guard band, or the frustum
      return Point<Clip>{float(random.between(-size, size)), float(random.between(-size, size)),
                         float(random.between(-5, 5)), float(random.between(-2, 10))};
    };
    const Point<Clip> a = position(), b = position(), c = position(), d = position();
    const std::span<const ClipPlane> planes = wide ? std::span<const ClipPlane>(render) : frustum;
    const ClipPolygon left = clip_triangle(triangle(a, b, c), planes);
    const ClipPolygon right = clip_triangle(triangle(b, a, d), planes);
    if (made_on_edge(left) == 0 && made_on_edge(right) == 0) continue;
    ++cut_edges;
    cut_twice += made_on_edge(left) > 1;
    mismatches += missing(left, right) + missing(right, left);
    if ((a.z < 0) != (b.z < 0)) {
      ++naive_edges;
      naive_mismatches += !(naive_crossing(a, b) == naive_crossing(b, a));
    }
  }
  CHECK(mismatches == 0);
  CHECK(cut_twice > 1000);
  CHECK(naive_mismatches * 10 > naive_edges);  // 46.8 % were measured before
}

TEST_CASE("vertices on planes are inside and are not repeated (C-35)") {
  const auto planes = frustum_planes();
  std::vector<Point<Clip>> lattice;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = 0; z <= 2; ++z) lattice.push_back({float(x), float(y), float(z) / 2, 1});
    }
  }
  SECTION("nothing on the surface of the box is changed") {
    for (const Point<Clip>& a : lattice) {
      CHECK(clip_point(a, planes));
      for (const Point<Clip>& b : lattice) {
        for (const Point<Clip>& c : lattice) {
          if (a == b || b == c || c == a) continue;
          const ClipPolygon polygon = clip_triangle(triangle(a, b, c), planes);
          REQUIRE(polygon.count == 3);
          REQUIRE(polygon.vertices[0].position == a);
          REQUIRE(polygon.vertices[1].position == b);
          REQUIRE(polygon.vertices[2].position == c);
        }
      }
    }
  }
  SECTION("what touches the box from outside along an edge or in a corner leaves nothing") {
    CHECK(
        clip_triangle(triangle({1, 0, 0.5f, 1}, {2, 0, 0.5f, 1}, {2, 1, 0.5f, 1}), planes).count ==
        0);
    CHECK(
        clip_triangle(triangle({1, 0, 0.5f, 1}, {1, 1, 0.5f, 1}, {2, 1, 0.5f, 1}), planes).count ==
        0);
    CHECK(clip_triangle(triangle({1, 1, 1, 1}, {2, 1, 1, 1}, {1, 2, 1, 1}), planes).count == 0);
  }
  SECTION(
      "a vertex on one plane and one beyond the opposite one give a triangle, not a "
      "quadrilateral") {
    const ClipPolygon polygon =
        clip_triangle(triangle({-1, 0, 0.5f, 1}, {3, -0.5f, 0.5f, 1}, {3, 0.5f, 0.5f, 1}), planes);
    CHECK(polygon.count == 3);
    CHECK(polygon.vertices[1].position == Point<Clip>{1, -0.25f, 0.5f, 1});
  }
  SECTION("a lattice that reaches beyond the box has no repeated vertices, and at most nine") {
    const std::uint64_t seed = 14;
    INFO("seed " << seed);
    Random random(seed);
    int corners_hit = 0;
    for (int i = 0; i < 50000; ++i) {
      const auto position = [&] {
        return Point<Clip>{float(random.integer(-4, 4)) / 2, float(random.integer(-4, 4)) / 2,
                           float(random.integer(-2, 4)) / 2, float(random.integer(1, 2))};
      };
      const Point<Clip> a = position(), b = position(), c = position();
      const Triangle3 t = triangle(a, b, c);
      INFO(in_words(t));
      const ClipPolygon polygon = clip_triangle(t, planes);
      REQUIRE((polygon.count == 0 || (polygon.count >= 3 && polygon.count <= 9)));
      REQUIRE_FALSE((polygon.count > 0 && repeats_a_vertex(polygon)));
      for (int k = 0; k < polygon.count; ++k) {
        const Point<Clip>& p = polygon.vertices[std::size_t(k)].position;
        // Rounding is monotonic, so it never leads out of the frustum again.
        REQUIRE(outcode(p, planes) == 0);
        corners_hit += std::abs(p.x) == p.w && std::abs(p.y) == p.w;
      }
    }
    CHECK(corners_hit > 100);
  }
}

TEST_CASE("all six planes cut a triangle to nine vertices, and no triangle to more (C-36)") {
  const auto planes = frustum_planes();
  // The plane x + y + z' = 0 (z' = 2z - 1) meets the box in a regular hexagon; this triangle cuts
  // off three of its corners.
  const float r = 1.875f;
  const Triangle3 t = triangle({-r, r, 0.5f, 1}, {0, -r, (r + 1) / 2, 1}, {r, 0, (1 - r) / 2, 1});
  const ClipPolygon polygon = clip_triangle(t, planes);
  CHECK(polygon.count == 9);
  CHECK(fan_size(polygon) == 7);
  CHECK(fan_triangle(polygon, 6)[0].position == polygon.vertices[0].position);
  CHECK(fan_triangle(polygon, 6)[2].position == polygon.vertices[8].position);

  SECTION("a triangle that contains the whole screen becomes the screen exactly") {
    const ClipPolygon screen = clip_triangle(
        triangle({-64, -64, 0.5f, 1}, {192, -64, 0.5f, 1}, {-64, 192, 0.5f, 1}), planes);
    REQUIRE(screen.count == 4);
    for (const float x : {-1.0f, 1.0f}) {
      for (const float y : {-1.0f, 1.0f}) CHECK(contains(screen, {x, y, 0.5f, 1}));
    }
    CHECK(test::twice_ndc_area(test::rational_of(screen)) == 8);
  }
}

TEST_CASE("each plane adds one vertex at most, even where rounding has bent the polygon") {
  const std::uint64_t seed = 15;
  INFO("seed " << seed);
  Random random(seed);
  // The vertices are nearly in the plane 2^16 w = 1366 x, on either side, and other planes cut
  // first: their crossings are rounded again, and end up inside or outside.
  const auto guard = guard_band_planes({0, 0, 1366, 768});
  const std::array<ClipPlane, 3> planes{frustum_planes()[0], frustum_planes()[1], guard[1]};
  const std::span<const ClipPlane> first_two(planes.data(), 2);
  const auto all = render_planes(perspective_view(1366, 768, 0.125));
  int bent = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto position = [&] {
      const float w = float(random.between(0.5, 3));
      const float x = float(65536.0 / 1366 * w) * (1 + float(random.integer(-1, 1)) * 0x1p-23f);
      const float y = i % 2 == 0 ? -float(65536.0 / 768 * w) : float(random.between(-1, 1));
      return Point<Clip>{x, y, float(random.between(-1, 4)), w};
    };
    const Point<Clip> a = position(), b = position(), c = position();
    const Triangle3 t = triangle(a, b, c);
    INFO(in_words(t));
    const ClipPolygon before = clip_triangle(t, first_two);
    const auto outside = [&](int k) {
      const Point<Clip>& p = before.vertices[std::size_t(k % before.count)].position;
      return signed_distance(guard[1], p) < 0;
    };
    int changes = 0;
    for (int k = 0; k < before.count; ++k) changes += outside(k) != outside(k + 1);
    bent += changes > 2;
    REQUIRE(clip_triangle(t, planes).count <= before.count + 1);
    REQUIRE(clip_triangle(t, all).count <= kMaxClipVertices);
  }
  CHECK(bent > 100);
}

TEST_CASE("any finite triangle divides to finite pixels (C-33, C-40)") {
  const std::uint64_t seed = 16;
  INFO("seed " << seed);
  Random random(seed);
  View view = perspective_view(1920, 1080, 0.01);
  int drawn = 0;
  const auto check = [&](const Triangle3& t) {
    INFO(in_words(t));
    const ClipPolygon polygon = clip_triangle(t, render_planes(view));
    for (int k = 0; k < polygon.count; ++k) {
      const ClipVertex& v = polygon.vertices[std::size_t(k)];
      REQUIRE(v.position.w >= float(view.near / 2));
      const NdcVertex ndc = divide(v);
      const ScreenVertex screen = to_screen(ndc, view.viewport);
      // A rounded crossing, a rounded quotient and the two roundings of the viewport: 4 u of a
      // number below 2^16.
      REQUIRE(std::abs(double(screen.position.x) - 960) <= kGuardBandPx + 0x1p-6);
      REQUIRE(std::abs(double(screen.position.y) - 540) <= kGuardBandPx + 0x1p-6);
      REQUIRE(screen.position.z >= 0);
      REQUIRE(screen.position.z <= 2);
      REQUIRE(std::isfinite(screen.inverse_w));
      double sum = 0;
      for (const double weight : v.weights) {
        REQUIRE(weight >= 0);
        sum += weight;
      }
      // Four roundings in double for each of up to seven planes.
      REQUIRE(std::abs(sum - 1) <= 64 * 0x1p-53);
    }
    drawn += polygon.count > 0;
  };
  SECTION("random bits") {
    for (const double far : {100.0, std::numeric_limits<double>::infinity()}) {
      for (const DepthRange range : {DepthRange::kStandard, DepthRange::kReversed}) {
        view.far = far;
        view.depth_range = range;
        for (int i = 0; i < 20000; ++i) {
          const auto position = [&] {
            Point<Clip> p{random_bits(random), random_bits(random), random_bits(random),
                          random_bits(random)};
            // Some vertices can be seen: all four coordinates are of the same magnitude.
            if (random.integer(0, 3) != 0) {
              const float size = std::abs(p.w);
              p = {size * float(random.between(-1, 1)), size * float(random.between(-1, 1)),
                   size * float(random.unit()), size};
            }
            return p;
          };
          const Point<Clip> a = position(), b = position(), c = position();
          check(triangle(a, b, c));
        }
      }
    }
    CHECK(drawn > 5000);
  }
  SECTION("w close to zero") {
    for (const float w : {1e-38f, 1e-45f, 0.0f, -1e-45f, -1e-38f}) {
      check(triangle({1, 0, w, w}, {0, 1, 0.5f, 1}, {-1, -1, 0.5f, 1}));
      check(triangle({0, 0, 0, w}, {0, 0, w, w}, {w, w, w, w}));
    }
    CHECK(drawn == 5);
  }
  SECTION("what is not finite is not drawn") {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {infinity, -infinity, nan}) {
      CHECK(
          clip_triangle(triangle({bad, 0, 0.5f, 1}, {0, 1, 0.5f, 1}, {1, 0, 0.5f, 1}), {}).count ==
          0);
      CHECK_FALSE(clip_point({0, 0, bad, 1}, {}));
      const std::array<Outcode, 3> codes{outcode({0, bad, 0, 1}, {}), 0, 0};
      CHECK(trivial_verdict(codes) == ClipVerdict::kReject);
    }
  }
}
