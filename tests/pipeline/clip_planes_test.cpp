// The clip planes; what need not be clipped or is rejected because of them; and the clipping of
// segments.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/divide.h>

#include "tests/pipeline/clip_cases.h"
#include "tests/pipeline/rational_geometry.h"
#include "tests/support/catch.h"

using namespace glassbox;
using namespace glassbox::test;

TEST_CASE("the planes that rendering clips with stand where their names say") {
  const auto planes = render_planes(perspective_view(1280, 720, 0.001));
  CHECK(std::string(planes[kNearPlane].name) == "near");
  CHECK(std::string(planes[kEyePlane].name) == "eye");
  CHECK(std::string(planes[kFarPlane].name).starts_with("far"));
}

TEST_CASE("the guard band keeps what it can hold and cuts the rest at its edge (C-40)") {
  // The viewport has 1024 px, so the conversion from pixels to NDC and back is exact. A position in
  // pixels relative to the centre.
  const Viewport viewport{0, 0, 1024, 1024};
  const auto planes = guard_band_planes(viewport);
  const auto at = [](double px, double py) {
    return Point<Clip>{float(px / 512), float(py / 512), 0.5f, 1};
  };
  for (const double px : {32767.99, 32768.0}) {
    CHECK(clip_point(at(px, 0), planes));
    CHECK(clip_point(at(-px, px), planes));
    const ClipPolygon kept = clip_triangle(triangle(at(-px, 0), at(px, -px), at(0, px)), planes);
    CHECK(kept.count == 3);
    CHECK(kept.vertices[1].position == at(px, -px));
  }
  CHECK_FALSE(clip_point(at(32768.01, 0), planes));
  for (const double px : {32768.01, 1e6, 1e30}) {
    const Triangle3 t = triangle(at(-100, -100), at(px, 100), at(-100, 300));
    const ClipPolygon polygon = clip_triangle(t, planes);
    REQUIRE(polygon.count == 4);
    for (int i = 0; i < 4; ++i) {
      const Point<Clip>& p = polygon.vertices[std::size_t(i)].position;
      CHECK(double(p.x) * 512 <= 32768);
      if (p.x == at(-100, 0).x) continue;
      CHECK(p.x == 64.0f * p.w);
      // The point is on its edge, up to half an ulp of a coordinate below 300 px.
      const RationalPoint q = test::rational_of(p);
      const RationalPoint from = test::rational_of(t[p.y > at(0, 100).y ? 2 : 0].position);
      const RationalPoint to = test::rational_of(t[1].position);
      const Rational y = from.y + (to.y - from.y) * (q.x - from.x) / (to.x - from.x);
      CHECK(std::abs(double(q.y - y)) * 512 <= 300 * 0x1p-24);
    }
  }
}

TEST_CASE(
    "OpenGL's near plane is another one: mixing dialects moves it by a factor of two (E16, C-41)") {
  const double n = 1, f = 1024;
  const auto at_depth = [&](double depth, bool opengl) {
    const double z = opengl ? ((f + n) * depth - 2 * f * n) / (f - n) : f * (depth - n) / (f - n);
    return Point<Clip>{0, 0, float(z), float(depth)};
  };
  const std::vector<ClipPlane> canonical{frustum_planes()[0]}, opengl{opengl_near_plane()};
  // Just beyond the near plane: each convention's own plane keeps it.
  CHECK(clip_point(at_depth(1.5, false), canonical));
  CHECK(clip_point(at_depth(1.5, true), opengl));
  CHECK_FALSE(clip_point(at_depth(0.75, false), canonical));
  CHECK_FALSE(clip_point(at_depth(0.75, true), opengl));
  // The wrong plane cuts at 2 f n / (f + n), nearly twice as far away, or at f n / (2 f - n),
  // nearly half as far.
  CHECK_FALSE(clip_point(at_depth(1.5, true), canonical));
  CHECK(clip_point(at_depth(2.0, true), canonical));
  CHECK(clip_point(at_depth(0.75, false), opengl));
  // For large w, z = 0 and z = -w are far apart; both tests are exact on the planes themselves.
  CHECK(clip_point({0, 0, 0, 1e30f}, canonical));
  CHECK(clip_point({0, 0, -1e30f, 1e30f}, opengl));
  CHECK_FALSE(clip_point({0, 0, -1e30f, 1e30f}, canonical));
}

TEST_CASE("a right-handed view times a left-handed projection shows only what is behind (E12)") {
  // T_pers of the slides (S4.18), with d = 1, f = 10, h = 1, expects positive depths; the view of
  // S4.5 has -z in front of the eye.
  const double d = 1, f = 10;
  Transform<Clip, Eye> t_pers;
  t_pers.columns = glm::dmat4(0.0);
  t_pers.at(0, 0) = t_pers.at(1, 1) = d;
  t_pers.at(2, 2) = f / (f - d);
  t_pers.at(2, 3) = -d * f / (f - d);
  t_pers.at(3, 2) = 1;
  Transform<Eye, Eye> adaptor;  // the adaptor S = diag(1, 1, -1, 1)
  adaptor.at(2, 2) = -1;
  const Transform<Clip, Eye, float> wrong = round_to_float(t_pers);
  const Transform<Clip, Eye, float> right = round_to_float(t_pers * adaptor);

  const std::uint64_t seed = 17;
  INFO("seed " << seed);
  Random random(seed);
  const auto planes = frustum_planes();
  int seen_right = 0, seen_wrong = 0;
  for (int i = 0; i < 1000; ++i) {
    const float z = -float(random.between(1.01, 9.99));
    const float x = z * float(random.between(-0.9, 0.9)), y = z * float(random.between(-0.9, 0.9));
    const Point<Eye> front{x, y, z}, behind{x, y, -z};
    REQUIRE((wrong * front).w < 0);
    REQUIRE((wrong * behind).w > 0);
    seen_right += clip_point(right * front, planes) && !clip_point(right * behind, planes);
    seen_wrong += clip_point(wrong * behind, planes) && !clip_point(wrong * front, planes);
  }
  CHECK(seen_right == 1000);
  CHECK(seen_wrong == 1000);
}

TEST_CASE("what is trivially accepted is not changed by clipping (C-42)") {
  const std::uint64_t seed = 18;
  INFO("seed " << seed);
  Random random(seed);
  const auto planes = render_planes(perspective_view(1280, 720, 0.25));
  int accepted = 0, rejected = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto position = [&] {
      return Point<Clip>{float(random.between(-200, 200)), float(random.between(-200, 200)),
                         float(random.between(-0.5, 2)), float(random.between(-0.5, 4))};
    };
    const Point<Clip> a = position(), b = position(), c = position();
    const Triangle3 t = triangle(a, b, c);
    const std::array<Outcode, 3> codes{outcode(t[0].position, planes),
                                       outcode(t[1].position, planes),
                                       outcode(t[2].position, planes)};
    const ClipVerdict verdict = trivial_verdict(codes);
    const ClipPolygon polygon = clip_triangle(t, planes);
    INFO(in_words(t));
    if (verdict == ClipVerdict::kAccept) {
      ++accepted;
      REQUIRE(polygon.count == 3);
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(polygon.vertices[k].position == t[k].position);
        REQUIRE(polygon.vertices[k].weights == t[k].weights);
      }
    }
    if (verdict == ClipVerdict::kReject) {
      ++rejected;
      REQUIRE(polygon.count == 0);
    }
  }
  CHECK(accepted > 100);
  CHECK(rejected > 100);
}

TEST_CASE("a box is accepted or rejected only if every vertex in it is") {
  const std::uint64_t seed = 19;
  INFO("seed " << seed);
  Random random(seed);
  const auto planes = frustum_planes();
  int accepted = 0, rejected = 0, undecided = 0;
  for (int i = 0; i < 20000; ++i) {
    Transform<Clip, Object, float> m;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        const double size = row < 3 ? 1 : (column < 3 ? 0.25 : 4);
        m.at(row, column) = float(random.between(-size, size));
      }
    }
    Box<Object> box;
    const Point<Object> centre{float(random.between(-2, 2)), float(random.between(-2, 2)),
                               float(random.between(-2, 2))};
    // Some boxes are points, so that only rounding decides.
    const double half = i % 4 == 0 ? 0 : random.between(0, 0.5);
    const auto vertex = [&] {
      return Point<Object>{float(centre.x + random.between(-half, half)),
                           float(centre.y + random.between(-half, half)),
                           float(centre.z + random.between(-half, half))};
    };
    std::array<Point<Object>, 8> vertices;
    for (Point<Object>& v : vertices) box.include(v = vertex());
    if (i % 4 == 0) {
      // Here the plane w = x passes through the point, as exactly as floats allow.
      const Point<Clip> p = m * centre;
      m.at(3, 3) += p.x - p.w;
    }
    Outcode all = ~Outcode{0}, any = 0;
    for (const Point<Object>& v : vertices) {
      const Outcode code = outcode(m * v, planes);
      all &= code;
      any |= code;
    }
    const ClipVerdict verdict = classify_box(box, m, planes);
    if (verdict == ClipVerdict::kAccept) REQUIRE(any == 0);
    if (verdict == ClipVerdict::kReject) REQUIRE(all != 0);
    accepted += verdict == ClipVerdict::kAccept;
    rejected += verdict == ClipVerdict::kReject;
    undecided += verdict == ClipVerdict::kClip;
  }
  CHECK(accepted > 100);
  CHECK(rejected > 1000);
  CHECK(undecided > 1000);
  CHECK(classify_box({}, {}, planes) == ClipVerdict::kReject);
  Box<Object> huge;
  huge.include(Point<Object>{3e38f, 3e38f, 3e38f});
  CHECK(classify_box(huge, {}, planes) == ClipVerdict::kClip);  // positions may overflow
}

TEST_CASE(
    "the distances of a plane over a point hold that of the point as it is transformed in float") {
  const std::uint64_t seed = 23;
  INFO("seed " << seed);
  Random random(seed);
  const std::array<ClipPlane, 3> planes{frustum_planes()[2], frustum_planes()[5],
                                        guard_band_planes({0, 0, 640, 480})[1]};
  int rounded = 0, beyond_double = 0;
  for (int i = 0; i < 20000; ++i) {
    // One matrix in three is so small that products are subnormal; its last column has no part in
    // the sum, a part, or most.
    const double size = i % 3 == 0 ? 0x1p-70 : 1;
    const double last = i / 3 % 3 == 0 ? 0 : i / 3 % 3 == 1 ? 1 : 16;
    Transform<Clip, Object, float> m;
    for (int row = 0; row < 4; ++row) {
      for (int k = 0; k < 4; ++k) {
        m.at(row, k) = float(random.between(-1, 1) * size * (k < 3 ? 1 : last * size));
      }
    }
    const Point<Object> p{float(random.between(-1, 1) * size), float(random.between(-1, 1) * size),
                          float(random.between(-1, 1) * size)};
    for (const ClipPlane& plane : planes) {
      const double distance = signed_distance(plane, m * p);
      const auto [least, greatest] =
          PlaneOverBoxes(plane, m).distance_range({p.x, p.y, p.z}, {0, 0, 0});
      REQUIRE(least <= distance);
      REQUIRE(distance <= greatest);
      const double exact = (least + greatest) / 2;  // up to a dozen roundings in double
      rounded += distance != exact;
      // Counts the errors that are more than 1/100 of the bound.
      beyond_double += std::abs(distance - exact) > (greatest - least) / 200;
    }
  }
  CHECK(rounded > 40000);
  CHECK(beyond_double > 20000);
}

TEST_CASE("the sign of a distance is exact") {
  const std::uint64_t seed = 20;
  INFO("seed " << seed);
  Random random(seed);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    Point<Clip> p{random_bits(random), random_bits(random), random_bits(random),
                  random_bits(random)};
    ClipPlane plane = frustum_planes()[std::size_t(random.integer(0, 5))];
    if (i % 3 == 0) plane = guard_band_planes({0, 0, 1366, 767})[std::size_t(random.integer(0, 3))];
    if (i % 3 == 1) {
      // A slanted plane through the point, as exactly as one more double coefficient allows.
      p = {float(random.between(-1, 1)), float(random.between(-1, 1)), float(random.between(-1, 1)),
           float(random.between(0.5, 1))};
      plane = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), 0, 0};
      plane.d = -(plane.a * p.x + plane.b * p.y + plane.c * p.z) / p.w;
    }
    if (i % 7 == 0) p.w = p.z = p.x;
    const int expected = test::distance(plane, test::rational_of(p)).sign();
    const double d = signed_distance(plane, p);
    CAPTURE(plane.name, p.x, p.y, p.z, p.w, d);
    REQUIRE((d > 0) - (d < 0) == expected);
    zeros += expected == 0;
  }
  CHECK(zeros > 100);
}

TEST_CASE("after an infinite far plane nothing distant is lost, and w is never too small") {
  const View view = perspective_view(1280, 720, 0.001);
  const auto planes = render_planes(view);
  // z = w - near is rounded, so it may be an ulp above w for distant points.
  CHECK(clip_point({0, 0, std::nextafter(1e5f, 1e6f), 1e5f}, planes));
  CHECK_FALSE(clip_point({0, 0, std::nextafter(1e5f, 1e6f), 1e5f}, frustum_planes()));
  // Rounding with a large offset may make z positive where w is negative or zero.
  CHECK_FALSE(clip_point({0, 0, 0.001f, -0.001f}, planes));
  CHECK_FALSE(clip_point({0, 0, 0, 0}, planes));
  CHECK(clip_point({0, 0, 0, 1}, render_planes([] {
                     View parallel;
                     parallel.perspective = false;
                     parallel.near = -1;
                     parallel.far = 1;
                     return parallel;
                   }())));
}

TEST_CASE("parallel projections keep w = 1 through clipping") {
  const std::uint64_t seed = 21;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 5000; ++i) {
    const Point<Clip> a = random_position(random, 1, 1), b = random_position(random, 1, 1);
    const Triangle3 t = triangle(a, b, random_position(random, 1, 1));
    const ClipPolygon polygon = clip_triangle(t, frustum_planes());
    for (int k = 0; k < polygon.count; ++k)
      REQUIRE(polygon.vertices[std::size_t(k)].position.w == 1);
  }
}

TEST_CASE("a segment is cut like an edge, the same from both ends") {
  const std::uint64_t seed = 22;
  INFO("seed " << seed);
  Random random(seed);
  const auto planes = frustum_planes();
  int visible = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::array<ClipVertex, 2> ends{ClipVertex{random_position(random, -1, 2), {1, 0, 0}},
                                         ClipVertex{random_position(random, -1, 2), {0, 1, 0}}};
    const auto there = clip_segment(ends, planes);
    const auto back = clip_segment({ends[1], ends[0]}, planes);
    REQUIRE(there.has_value() == back.has_value());
    if (!there) continue;
    ++visible;
    for (std::size_t k = 0; k < 2; ++k) {
      REQUIRE((*there)[k].position == (*back)[1 - k].position);
      REQUIRE((*there)[k].weights == (*back)[1 - k].weights);
      REQUIRE(clip_point((*there)[k].position, planes));
    }
  }
  CHECK(visible > 1000);

  const auto vertex = [](float x, float y) { return ClipVertex{{x, y, 0.5f, 1}, {}}; };
  CHECK_FALSE(clip_segment({vertex(1, 0), vertex(2, 0)}, planes).has_value());  // touches
  CHECK_FALSE(clip_segment({vertex(-2, 1.5f), vertex(2, 1.5f)}, planes).has_value());
  CHECK(clip_segment({vertex(1, -1), vertex(1, 1)}, planes).has_value());  // in the plane
  CHECK(clip_segment({vertex(0.5f, 0), vertex(0.5f, 0)}, planes)
            .has_value());  // a segment that was a point
}

TEST_CASE("reversed depth has the same half-spaces under swapped names") {
  const auto standard = frustum_planes(DepthRange::kStandard);
  const auto reversed = frustum_planes(DepthRange::kReversed);
  CHECK(std::string(reversed[0].name) == "near");
  CHECK(std::string(reversed[1].name) == "far");
  CHECK(signed_distance(reversed[0], {0, 0, 1, 1}) == 0);
  CHECK(signed_distance(reversed[1], {0, 0, 0, 1}) == 0);
  CHECK(signed_distance(standard[0], {0, 0, 0, 1}) == 0);
  CHECK(signed_distance(standard[1], {0, 0, 1, 1}) == 0);
}
