#include <tests/pipeline/cameras.h>
#include <tests/pipeline/roundoff.h>
#include <tests/support/catch.h>

#include <cmath>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/projection.h>

namespace glassbox {
namespace {

using test::u;
using WorldPoint = Point<World, double>;

TEST_CASE("the adaptors of eye and depth are their own inverses, exactly") {
  CHECK(eye_from_eye_left() * eye_left_from_eye() == Transform<Eye, Eye>{});
  CHECK(clip_from_clip_gl() * clip_gl_from_clip() == Transform<Clip, Clip>{});
  CHECK(clip_gl_from_clip() * clip_from_clip_gl() == Transform<ClipGl, ClipGl>{});
  CHECK(reverse_depth() * reverse_depth() == Transform<Clip, Clip>{});
  for (double z : {0.0, 0.25, 0.5, 1.0}) {
    CHECK(depth_from_gl_depth(gl_depth_from_depth(z)) == z);
    CHECK(reversed_depth(reversed_depth(z)) == z);
  }
  CHECK(gl_depth_from_depth(0) == -1);
  CHECK(gl_depth_from_depth(1) == 1);
  CHECK(reversed_depth(0) == 1);
}

TEST_CASE(
    "E12: T_pers on a right-handed eye without the adaptor shows what is behind the camera "
    "(C-07)") {
  const auto eye_from_world = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
  const auto t = t_pers(1, 1, 100);
  REQUIRE(eye_from_world);
  REQUIRE(t);
  const Transform<Clip, World> right = *t * eye_left_from_eye() * *eye_from_world;
  // The view of S4.5 times the projection of S4.18, as printed; the types must be circumvented to
  // make this mistake.
  const Transform<Clip, World> wrong(t->columns * eye_from_world->columns);

  Random random(60);
  int right_in_front = 0, wrong_in_front = 0, wrong_behind = 0;
  for (int i = 0; i < 500; ++i) {
    const WorldPoint front{random.between(-1, 1), random.between(-1, 1), random.between(-50, 3.9)};
    // Mirrored in the plane z = 5 of the eye.
    const WorldPoint behind{front.x, front.y, 10 - front.z};
    right_in_front += (right * front).w > 0 ? 1 : 0;
    wrong_in_front += (wrong * front).w > 0 ? 1 : 0;
    wrong_behind += (wrong * behind).w > 0 ? 1 : 0;
  }
  CHECK(right_in_front == 500);
  CHECK(wrong_in_front == 0);
  CHECK(wrong_behind == 500);
}

TEST_CASE("E15: the 4x4 projection of S3.26 has no depth and no inverse") {
  const Transform<Clip, EyeLeft> m = singular_projection(2);
  CHECK(glm::determinant(m.columns) == 0);
  for (double z : {1.0, 3.0, 1000.0}) {
    const Point<Clip, double> c = m * Point<EyeLeft, double>(1, 1, z);
    CHECK(c.z / c.w == 2);  // every distance has the depth d
  }
  const auto with_depth = t_pers(1, 2, 10);
  REQUIRE(with_depth);
  CHECK(glm::determinant(with_depth->columns) > 0);
  const auto depth = [&](double z) {
    const Point<Clip, double> c = *with_depth * Point<EyeLeft, double>(1, 1, z);
    return c.z / c.w;
  };
  CHECK(depth(3) < depth(4));
}

TEST_CASE("E16: the near planes of the two depth conventions are not the same plane (C-41)") {
  const auto ours = perspective_degrees(90, 1, {1, 101});
  REQUIRE(ours);
  const Transform<ClipGl, Eye> gl = clip_gl_from_clip() * *ours;
  const auto clip = [](const glm::dmat4& m, double distance) {
    return m * glm::dvec4(0, 0, -distance, 1);
  };
  // Between the near plane and the far plane: visible in both conventions, by each one's own test.
  for (double distance : {1.25, 1.5, 50.0}) {
    const glm::dvec4 c = clip(ours->columns, distance), c_gl = clip(gl.columns, distance);
    CHECK(c.z >= 0);
    CHECK(c_gl.z >= -c_gl.w);
  }
  for (double distance : {0.5, 0.9}) {
    CHECK(clip(ours->columns, distance).z < 0);
    CHECK(clip(gl.columns, distance).z < -clip(gl.columns, distance).w);
  }
  // Mixed: OpenGL vertices tested with z >= 0 lose the strip from 1 to 2 n f/(f + n); our vertices
  // tested with z >= -w keep one in front of the near plane.
  CHECK(clip(gl.columns, 1.25).z < 0);
  CHECK(clip(ours->columns, 0.9).z > -0.9);
  const double edge = 2.0 * 101 / 102;
  CHECK(clip(gl.columns, edge * 0.999).z < 0);
  CHECK(clip(gl.columns, edge * 1.001).z > 0);
}

TEST_CASE("reversed depth is one minus depth") {
  Random random(61);
  for (int i = 0; i < 1000; ++i) {
    const test::LensCase c = test::random_lens(random);
    const auto standard = perspective_degrees(c.fovy_degrees, c.aspect, {c.near, c.far});
    const auto reversed =
        perspective_degrees(c.fovy_degrees, c.aspect, {c.near, c.far, DepthRange::kReversed});
    REQUIRE(standard);
    REQUIRE(reversed);
    const Transform<Clip, Eye> turned = reverse_depth() * *standard;
    // Entries that cancel lose up to f/(f - n) and n/(f - n); the error is relative to the numbers
    // that are subtracted.
    const double size = c.far / (c.far - c.near);
    for (int row = 0; row < 4; ++row) {
      CHECK(std::abs(turned.at(row, 2) - reversed->at(row, 2)) <= 8 * u * size);
      CHECK(std::abs(turned.at(row, 3) - reversed->at(row, 3)) <= 8 * u * size * c.near);
    }
  }
}

TEST_CASE("the stereo skew moves points by s (1 - z/f), in either eye space (S0.21)") {
  const double s = 0.25, f = 8;
  for (double distance : {1.0, 4.0, 8.0, 16.0}) {
    const Point<EyeLeft, double> left =
        stereo_skew_left_handed(s, f) * Point<EyeLeft, double>(3, 2, distance);
    const Point<Eye, double> right = stereo_skew(s, f) * Point<Eye, double>(3, 2, -distance);
    CHECK(left.x == 3 + s * (1 - distance / f));
    CHECK(right.x == left.x);
    CHECK(right.y == 2);
    CHECK(right.z == -distance);
  }
  CHECK(stereo_skew(s, f).at(0, 2) == s / f);
  CHECK(stereo_skew_left_handed(s, f).at(0, 2) == -s / f);
  // With the wrong sign, points at the focus move.
  CHECK((Transform<Eye, Eye>(stereo_skew_left_handed(s, f).columns) * Point<Eye, double>(3, 2, -f))
            .x == 3 + 2 * s);
  CHECK(stereo_skew(s, f) ==
        eye_from_eye_left() * stereo_skew_left_handed(s, f) * eye_left_from_eye());
}

TEST_CASE("storage and row vectors: the same numbers in the same order are the same map") {
  Transform<World, Object> m;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) m.at(row, column) = 10 * row + column;
  }
  CHECK(column_major(m)[4] == 1);  // column 1, row 0
  CHECK(row_major(m)[1] == 1);
  CHECK(from_column_major<World, Object>(column_major(m)) == m);
  CHECK(from_row_major<World, Object>(row_major(m)) == m);
  CHECK(from_row_major<World, Object>(column_major(m)) != m);
  // p' = M p for columns is p' = p M^T for rows. M^T stored row by row is M stored column by
  // column.
  const Transform<World, Object> transposed(row_vector_matrix(m));
  CHECK(row_major(transposed) == column_major(m));
  const glm::dvec4 p(1, 2, 3, 1);
  CHECK(p * row_vector_matrix(m) == m.columns * p);
}

}  // namespace
}  // namespace glassbox
